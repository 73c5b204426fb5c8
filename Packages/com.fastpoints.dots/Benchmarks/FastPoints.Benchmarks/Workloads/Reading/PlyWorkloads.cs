namespace FastPoints.Benchmarks
{
    /// <summary>An ascii PLY file, positions and colours; finding the lines is part of it.</summary>
    public sealed class PlyAsciiWorkload : ColumnsWorkload
    {
        public PlyAsciiWorkload() : base("ply ascii", null)
        {
        }

        protected override string Find(WorkloadContext context) => PlyBenchmarkFile.Make(context, true);
    }

    /// <summary>A binary PLY file, positions and colours.</summary>
    public sealed class PlyBinaryWorkload : ColumnsWorkload
    {
        public PlyBinaryWorkload() : base("ply binary", "ply read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => PlyBenchmarkFile.Make(context, false);
    }

    /// <summary>The loop of <see cref="PlyBinaryWorkload"/> over raw pointers in plain threads, against the same bound.</summary>
    public struct PlyPointersWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply pointers";
        public string LimitName => "ply read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => PlyPlainPass.Run(m_path, true);

        public void Dispose()
        {
        }
    }

    /// <summary>The file of <see cref="PlyBinaryWorkload"/> read and copied once, no more: its bound.</summary>
    public struct PlyReadCopyWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => PlyPlainPass.Run(m_path, false);

        public void Dispose()
        {
        }
    }
}
