using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using FastPoints.Partition;
using FastPoints.Streaming;
using Unity.Collections;

namespace FastPoints.Benchmarks
{
    /// <summary>All nodes of a converted cloud lose their memory and come again, time after time: of 4 M points 3,500 nodes in
    /// 60 frames, of 12 M three times as many, with and without entities for them. The error is the main thread's time for a
    /// frame that 99 of 100 do not exceed. Each frame takes a sixtieth of a second.</summary>
    public sealed class SceneNodesWorkload : IWorkload
    {
        const int Frames = 60, FramesPerRound = 8;
        const double FrameMs = 1000.0 / 60;

        readonly bool m_hasEntities;
        long m_poolBytes;
        SceneBenchmark m_scene;

        SceneNodesWorkload(bool hasEntities) => m_hasEntities = hasEntities;

        public static IEnumerable<IWorkload> All() => new[] { new SceneNodesWorkload(false), new SceneNodesWorkload(true) };

        public string Name => m_hasEntities ? "scene node entities" : "scene nodes";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_poolBytes = 20L * context.Points;
            m_scene = new SceneBenchmark(m_poolBytes);
            m_scene.Settings.Selection = new SelectionSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            m_scene.Settings.UploadBytesPerFrame = 16 << 20;
            if (m_hasEntities)
                m_scene.WantNodes();
            m_scene.Show(TerrainBenchmarkFile.MakeConverted(context));
            do
                m_scene.Frame(StreamView.Everything(1));
            while (!m_scene.IsOpen);
            Run();
        }

        public WorkloadResult Run()
        {
            using (var before = new SliceTimes(Allocator.Persistent))
                before.Take(m_scene.FrameTimes);
            long points = 0, bytes = 0, garbage = 0;
            int come = 0;
            for (int i = 0; i < Frames; i++)
            {
                var frame = Stopwatch.StartNew();
                m_scene.PoolBytes = i % FramesPerRound == 0 ? 0 : m_poolBytes;
                var stats = m_scene.Frame(StreamView.Everything(1));
                points += stats.DrawnPoints;
                bytes += stats.UploadedBytes;
                come += stats.UploadedNodes;
                garbage += m_scene.Garbage;
                FrameLoop.Rest(frame, FrameMs);
            }
            var times = m_scene.FrameTimes;
            return new WorkloadResult
            {
                Points = points,
                Bytes = bytes,
                Error = times.QuantileMs(0.99),
                ErrorUnit = "ms p99 a frame",
                Note = string.Format(CultureInfo.InvariantCulture, "{0:N0} nodes came in {1} frames; main thread {2:0.0} ms a "
                    + "frame (p50), {3:0.0} (p99), {4:0.0} (max); {5} bytes of garbage", come, Frames, times.QuantileMs(0.5),
                    times.QuantileMs(0.99), times.QuantileMs(1), garbage),
            };
        }

        public void Dispose() => m_scene?.Dispose();
    }
}
