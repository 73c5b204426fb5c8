namespace FastPoints.Benchmarks
{
    /// <summary>A camera that flies 0.5 m between frames: five million points of a billion, one core.</summary>
    public struct SelectMoveWorkload : IWorkload
    {
        SelectionBenchmark m_benchmark;
        double m_way;

        public string Name => "select, small step";
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_benchmark = new SelectionBenchmark(9, 5_000_000);

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_way += 0.0002), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }
}
