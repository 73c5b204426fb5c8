namespace FastPoints.Benchmarks
{
    /// <summary>The same choice as of a billion points where only a fraction of the nodes exist.</summary>
    public struct SelectSmallCloudWorkload : IWorkload
    {
        SelectionBenchmark m_benchmark;
        double m_way;

        public string Name => "select, small cloud";
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_benchmark = new SelectionBenchmark(8, 5_000_000);

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_way += 0.0002), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }
}
