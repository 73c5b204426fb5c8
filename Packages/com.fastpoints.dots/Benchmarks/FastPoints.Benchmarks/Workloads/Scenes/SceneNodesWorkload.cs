using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using FastPoints.Streaming;
using Unity.Mathematics;

namespace FastPoints.Benchmarks
{
    /// <summary>A camera in the middle of a converted cloud turns round, and all points that it sees are wanted: of 48 M points
    /// some 10,000 nodes are added and as many removed in every 60 frames, a few in each, with and without entities for them. The
    /// error is the main thread's time for a frame that 99 of 100 do not exceed. Each frame takes a sixtieth of a
    /// second.</summary>
    public sealed class SceneNodesWorkload : IWorkload
    {
        const int Frames = 300, FramesPerRound = 30;
        const double FovRadians = math.PI_DBL / 2;
        const double ShareKept = 0.4;
        const double FrameMs = 1000.0 / 60;

        readonly bool m_hasEntities;
        SceneBenchmark m_scene;

        SceneNodesWorkload(bool hasEntities) => m_hasEntities = hasEntities;

        public static IEnumerable<IWorkload> All() => new[] { new SceneNodesWorkload(false), new SceneNodesWorkload(true) };

        public string Name => m_hasEntities ? "scene node entities" : "scene nodes";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_scene = new SceneBenchmark(math.max(20L * context.Points, SceneBenchmark.MaxBankBytes));
            m_scene.Settings.Selection = new LodSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            m_scene.Settings.MaxUploadBytesPerFrame = 16 << 20;
            if (m_hasEntities)
                m_scene.WantNodes();
            m_scene.Show(TerrainBenchmarkFile.MakeConverted(context));
            long all;
            do
                all = m_scene.Frame(StreamView.Everything(1)).PoolBytes;
            while (!m_scene.IsIdle);
            m_scene.PoolBytes = math.max((long)(ShareKept * all), SceneBenchmark.MinBankBytes);
            // More than the camera sees.
            m_scene.Settings.Selection.PointBudget = context.Points / 3;
            Run();
        }

        public WorkloadResult Run()
        {
            m_scene.ResetTimes();
            long points = 0, bytes = 0, garbage = 0;
            int added = 0, removed = 0;
            for (int i = 0; i < Frames; i++)
            {
                var frame = Stopwatch.StartNew();
                var stats = m_scene.Frame(ViewAt(i));
                points += stats.DrawnPoints;
                bytes += stats.UploadedBytes;
                added += stats.UploadedNodes;
                removed += stats.EvictedNodes;
                garbage += m_scene.Garbage;
                FrameLoop.Rest(frame, FrameMs);
            }
            var times = m_scene.FrameTimes;
            return m_scene.Result(points, bytes, string.Format(CultureInfo.InvariantCulture,
                "{0:N0} nodes came and {1:N0} went in {2} frames; main thread {3:0.0} ms a frame (p50), {4:0.0} (p99), {5:0.0} "
                + "(max); {6} bytes of garbage", added, removed, Frames, times.QuantileMs(0.5), times.QuantileMs(0.99),
                times.QuantileMs(1), garbage));
        }

        public void Dispose() => m_scene?.Dispose();

        static StreamView ViewAt(int frame)
        {
            double angle = 2 * math.PI_DBL * frame / FramesPerRound;
            var forward = new double3(math.cos(angle), 0, -math.sin(angle));
            var right = new double3(math.sin(angle), 0, math.cos(angle));
            return StreamView.Perspective(0, right, new double3(0, 1, 0), forward, FovRadians, 1e7);
        }
    }
}
