using FastPoints.Streaming;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>A camera over a billion points that nobody stored, and what is chosen for it.</summary>
    public sealed unsafe class SelectionBenchmark : System.IDisposable
    {
        readonly NodeSelector m_selector = new NodeSelector();
        readonly SimulatedHierarchy m_cloud;
        readonly SelectionSettings m_settings = SelectionSettings.Default;
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

        /// <summary>Points that were chosen.</summary>
        public long Choose(in StreamView view, bool withForecast)
        {
            m_views[0] = view;
            m_selector.Begin();
            m_selector.Add(0, m_cloud.Pages, new CloudPlacement(double3x3.identity, new double3(4_000_000, 5_000_000, 0)));
            m_selector.Choose(m_views, m_settings);
            if (withForecast)
                m_selector.Forecast(m_views, m_settings, m_settings.PointBudget / 4);
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
            return StreamView.Perspective(eye, right, math.cross(right, forward), forward, math.radians(60.0), 1920, 1080);
        }

        public void Dispose()
        {
            m_selector.Dispose();
            m_cloud.Dispose();
            m_views.Dispose();
        }
    }
}
