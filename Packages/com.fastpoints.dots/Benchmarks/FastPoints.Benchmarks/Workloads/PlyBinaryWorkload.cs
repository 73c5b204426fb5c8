namespace FastPoints.Benchmarks
{
    /// <summary>A binary PLY file, positions and colours, to columns.</summary>
    public struct PlyBinaryWorkload : IWorkload
    {
        string m_path;

        public string Name => "ply binary";
        public string LimitName => "ply read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = PlyBenchmarkFile.Make(context, false);
            Run();
        }

        public WorkloadResult Run() => PlyBenchmarkFile.Scan(m_path);

        public void Dispose()
        {
        }
    }
}
