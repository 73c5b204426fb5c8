namespace FastPoints.Benchmarks
{
    /// <summary>A fifth of the budget: the time follows what is chosen.</summary>
    public struct SelectFewWorkload : IWorkload
    {
        SelectionBenchmark m_benchmark;
        double m_way;

        public string Name => "select, 1 M";
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_benchmark = new SelectionBenchmark(9, 1_000_000);

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_way += 0.0002), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }
}
