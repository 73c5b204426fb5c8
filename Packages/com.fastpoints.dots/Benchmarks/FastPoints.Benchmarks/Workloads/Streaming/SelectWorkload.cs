using System.Collections.Generic;

namespace FastPoints.Benchmarks
{
    /// <summary>What is chosen of a billion points for a camera that goes along a circle, on one core.</summary>
    sealed class SelectWorkload : IWorkload
    {
        /// <summary>Of a camera that flies half a metre a frame, in radians.</summary>
        const double SmallStep = 0.0002;

        readonly int m_levels;
        readonly long m_budget;
        readonly double m_step;
        SelectionBenchmark m_benchmark;
        double m_way;

        /// <param name="levels">Of the cloud: 9 for 100,000 nodes.</param>
        /// <param name="step">Radians between two choices.</param>
        SelectWorkload(string name, int levels, long budget, double step)
        {
            Name = name;
            m_levels = levels;
            m_budget = budget;
            m_step = step;
        }

        public static IEnumerable<IWorkload> All()
        {
            yield return new SelectWorkload("select, small step", 9, 5_000_000, SmallStep);
            // A camera that is somewhere else each time.
            yield return new SelectWorkload("select, cut", 9, 5_000_000, 2.4);
            // The time follows what is chosen.
            yield return new SelectWorkload("select, 1 M", 9, 1_000_000, SmallStep);
            // The same choice as of a billion points where only a fraction of the nodes exist.
            yield return new SelectWorkload("select, small cloud", 8, 5_000_000, SmallStep);
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
}
