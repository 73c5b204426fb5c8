namespace FastPoints.Benchmarks
{
    /// <summary>All attributes of a pointwise LAZ file to columns, through the reader and all workers.</summary>
    public struct LazPointwiseWorkload : IWorkload
    {
        string m_path;

        public string Name => "laz pointwise";
        public string LimitName => "laz pointwise read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = LazBenchmarkFile.Find(context, LazBenchmarkFile.Pointwise);
            Run();
        }

        public WorkloadResult Run() => LazBenchmarkFile.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
