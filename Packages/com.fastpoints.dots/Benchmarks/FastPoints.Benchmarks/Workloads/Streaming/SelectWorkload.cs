using System.Collections.Generic;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    sealed class SelectWorkload : IWorkload
    {
        const double SmallStep = 0.0002; // Radians a frame, of a camera that flies half a metre.

        readonly int m_levels;
        readonly long m_budget;
        readonly double m_step;
        SelectionBenchmark m_benchmark;
        double m_distance;

        /// <param name="levels">Of the cloud: 9 for 100,000 nodes.</param>
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
            Points = m_benchmark.Choose(SelectionBenchmark.Over(m_distance += m_step), false),
            Note = m_benchmark.Note,
        };

        public void Dispose() => m_benchmark.Dispose();
    }

    public sealed unsafe class SelectionBenchmark : System.IDisposable
    {
        readonly LodSelector m_selector = new LodSelector();
        readonly SimulatedHierarchy m_cloud;
        readonly LodSettings m_settings = LodSettings.Default;
        NativeArray<StreamView> m_views;

        /// <param name="levels">9 for 100,000 nodes.</param>
        public SelectionBenchmark(int levels, long budget)
        {
            m_cloud = new SimulatedHierarchy(levels, 1);
            m_settings.PointBudget = budget;
            m_views = new NativeArray<StreamView>(1, Allocator.Persistent);
            // The code is compiled before it is timed.
            for (int i = 0; i < 200; i++)
                Choose(Over(i * 0.37), i % 4 == 0);
            Note = m_selector.Selected.Length + " nodes chosen of " + m_cloud.NodeCount;
        }

        public string Note { get; }

        public long Choose(in StreamView view, bool withPrefetch)
        {
            m_views[0] = view;
            m_selector.Begin();
            m_selector.Add(0, m_cloud.Pages, new CloudPlacement(double3x3.identity, new double3(4_000_000, 5_000_000, 0)));
            m_selector.Select(m_views, m_settings);
            if (withPrefetch)
                m_selector.Prefetch(m_views, m_settings, m_settings.PointBudget / 4);
            return m_selector.Points;
        }

        /// <summary>A place 40 m over the hills, looking along them.</summary>
        /// <param name="way">Radians along a circle of 2.5 km.</param>
        public static StreamView Over(double way)
        {
            double x = 4096 + 2500 * math.cos(way), y = 4096 + 2500 * math.sin(way);
            var eye = new double3(4_000_000 + x, 5_000_000 + y, SimulatedHierarchy.HeightAt(x, y) + 40);
            var forward = math.normalize(new double3(-math.sin(way), math.cos(way), -0.2));
            var right = math.normalize(math.cross(forward, new double3(0, 0, 1)));
            return StreamView.Perspective(eye, right, math.cross(right, forward), forward, math.radians(60.0),
                new double2(1920, 1080));
        }

        public void Dispose()
        {
            m_selector.Dispose();
            m_cloud.Dispose();
            m_views.Dispose();
        }
    }
}
