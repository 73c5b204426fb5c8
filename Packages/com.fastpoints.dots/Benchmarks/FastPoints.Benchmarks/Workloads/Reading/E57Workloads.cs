using System.IO;
using FastPoints.Base;
using FastPoints.Files;

namespace FastPoints.Benchmarks
{
    /// <summary>An E57 file, all fields: its walk, checksums and invalid points included.</summary>
    public sealed class E57ColumnsWorkload : ColumnsWorkload
    {
        public E57ColumnsWorkload() : base("e57 columns", "e57 read and copy")
        {
        }

        protected override string Find(WorkloadContext context) => E57BenchmarkFile.Make(context);
    }

    /// <summary>What comes before the first point of an E57 file: its header, its XML section, and the walk over its packets'
    /// headers.</summary>
    public struct E57WalkWorkload : IWorkload
    {
        string m_path;

        public string Name => "e57 walk";
        public string LimitName => "e57 read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = E57BenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run()
        {
            using (var reader = E57Reader.Open(m_path))
            {
                WorkPump.RunToEnd(reader.FindBlocks());
                return new WorkloadResult { Points = reader.PointCount, Bytes = reader.Info.FileBytes };
            }
        }

        public void Dispose()
        {
        }
    }

    /// <summary>The file of <see cref="E57ColumnsWorkload"/> read and copied once by plain threads, as many as the job system
    /// has: its bound.</summary>
    public struct E57ReadCopyWorkload : IWorkload
    {
        string m_path;

        public string Name => "e57 read and copy";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = E57BenchmarkFile.Make(context);
            Run();
        }

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = PlyPlainPass.Run(m_path, false).Points,
            Bytes = new FileInfo(m_path).Length,
        };

        public void Dispose()
        {
        }
    }
}
