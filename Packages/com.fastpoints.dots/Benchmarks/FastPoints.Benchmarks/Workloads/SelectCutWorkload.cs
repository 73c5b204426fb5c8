namespace FastPoints.Benchmarks
{
    /// <summary>A camera that is somewhere else each time: five million points of a billion, one core.</summary>
    public struct SelectCutWorkload : IWorkload
    {
        SelectionBenchmark m_benchmark;
        double m_way;

        public string Name => "select, cut";
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_benchmark = new SelectionBenchmark(9, 5_000_000);

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_way += 2.4), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }
}
