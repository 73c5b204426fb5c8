namespace FastPoints.Benchmarks
{
    /// <summary>What is chosen of a billion points for a camera that goes along a circle, on one core.</summary>
    public abstract class SelectWorkload : IWorkload
    {
        readonly int m_levels;
        readonly long m_budget;
        readonly double m_step;
        SelectionBenchmark m_benchmark;
        double m_way;

        /// <param name="levels">Of the cloud: 9 for 100,000 nodes.</param>
        /// <param name="step">Radians between two choices.</param>
        protected SelectWorkload(string name, int levels, long budget, double step)
        {
            Name = name;
            m_levels = levels;
            m_budget = budget;
            m_step = step;
        }

        public string Name { get; }
        public string LimitName => null;

        public void Prepare(WorkloadContext context) => m_benchmark = new SelectionBenchmark(m_levels, m_budget);

        public WorkloadResult Run() => new WorkloadResult
        {
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_way += m_step), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }

    /// <summary>A camera that flies 0.5 m between frames: five million points.</summary>
    public sealed class SelectMoveWorkload : SelectWorkload
    {
        public SelectMoveWorkload() : base("select, small step", 9, 5_000_000, 0.0002)
        {
        }
    }

    /// <summary>A camera that is somewhere else each time: five million points.</summary>
    public sealed class SelectCutWorkload : SelectWorkload
    {
        public SelectCutWorkload() : base("select, cut", 9, 5_000_000, 2.4)
        {
        }
    }

    /// <summary>A fifth of the budget: the time follows what is chosen.</summary>
    public sealed class SelectFewWorkload : SelectWorkload
    {
        public SelectFewWorkload() : base("select, 1 M", 9, 1_000_000, 0.0002)
        {
        }
    }

    /// <summary>The same choice as of a billion points where only a fraction of the nodes exist.</summary>
    public sealed class SelectSmallCloudWorkload : SelectWorkload
    {
        public SelectSmallCloudWorkload() : base("select, small cloud", 8, 5_000_000, 0.0002)
        {
        }
    }
}
