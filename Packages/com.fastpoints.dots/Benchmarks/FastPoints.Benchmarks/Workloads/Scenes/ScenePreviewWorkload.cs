using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using FastPoints.Streaming;

namespace FastPoints.Benchmarks
{
    sealed class ScenePreviewWorkload : IWorkload
    {
        readonly Func<WorkloadContext, string> m_find;
        string m_path;

        ScenePreviewWorkload(string name, Func<WorkloadContext, string> find) => (Name, m_find) = (name, find);

        public static IEnumerable<IWorkload> All()
        {
            // Streamed as it is.
            yield return new ScenePreviewWorkload("scene copc", BenchmarkSamples.FindCopc);
            // Points are read where they are wanted.
            yield return new ScenePreviewWorkload("scene las", TerrainBenchmarkFile.Make);
            // Prefixes of chunks, then all of it.
            yield return new ScenePreviewWorkload("scene laz", context =>
                BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered));
        }

        public string Name { get; }
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using var scene = new SceneBenchmark(256 << 20);
            scene.Settings.Selection = new LodSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
            var view = StreamView.Everything(1e9);
            var watch = Stopwatch.StartNew();
            scene.Show(m_path);
            double firstMs = 0;
            long points;
            int frames = 0;
            do
            {
                points = scene.Frame(view).DrawnPoints;
                frames++;
                if (points > 0 && firstMs == 0)
                    firstMs = watch.Elapsed.TotalMilliseconds;
            }
            while (!scene.IsIdle);
            return new WorkloadResult
            {
                Points = points,
                Error = firstMs,
                ErrorUnit = "ms to first points",
                // Most of the frames wait for jobs, without a pause: of their times the longest alone means something.
                Note = string.Format(CultureInfo.InvariantCulture,
                    "the longest of {0} frames took {1:0.0} ms of the main thread", frames, scene.FrameTimes.QuantileMs(1)),
            };
        }

        public void Dispose() { }
    }
}
