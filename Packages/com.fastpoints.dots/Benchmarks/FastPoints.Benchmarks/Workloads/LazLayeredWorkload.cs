namespace FastPoints.Benchmarks
{
    /// <summary>All attributes of a layered LAZ file to columns.</summary>
    public struct LazLayeredWorkload : IWorkload
    {
        string m_path;

        public string Name => "laz layered";
        public string LimitName => "laz layered read and copy";

        public void Prepare(WorkloadContext context)
        {
            m_path = LazBenchmarkFile.Find(context, LazBenchmarkFile.Layered);
            Run();
        }

        public WorkloadResult Run() => LazBenchmarkFile.Decode(m_path);

        public void Dispose()
        {
        }
    }
}
