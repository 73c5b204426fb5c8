using System.IO;

namespace FastPoints.Benchmarks
{
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
