using System.Diagnostics;
using System.Globalization;
using FastPoints.Streaming;

namespace FastPoints.Benchmarks
{
    /// <summary>A file that is not converted comes into a scene: until all that its preview brings is shown. The error is the
    /// time to the first frame that draws points.</summary>
    public abstract class ScenePreviewWorkload : IWorkload
    {
        string m_path;

        public abstract string Name { get; }
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_path = Find(context);
            Run();
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using (var scene = new SceneBenchmark(256 << 20))
            {
                scene.Settings.Selection = new SelectionSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
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
                while (!scene.IsAtRest);
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
        }

        public void Dispose()
        {
        }

        /// <returns>The file's path; null where there is none.</returns>
        protected abstract string Find(WorkloadContext context);
    }

    /// <summary>A COPC file, streamed as it is.</summary>
    public sealed class SceneCopcWorkload : ScenePreviewWorkload
    {
        public override string Name => "scene copc";

        protected override string Find(WorkloadContext context) => BenchmarkSamples.FindCopc(context);
    }

    /// <summary>A LAS file: its points are read where they are wanted.</summary>
    public sealed class SceneLasWorkload : ScenePreviewWorkload
    {
        public override string Name => "scene las";

        protected override string Find(WorkloadContext context) => TerrainBenchmarkFile.Make(context);
    }

    /// <summary>A LAZ file: prefixes of its chunks, then all of it.</summary>
    public sealed class SceneLazWorkload : ScenePreviewWorkload
    {
        public override string Name => "scene laz";

        protected override string Find(WorkloadContext context) => BenchmarkSamples.Find(context, BenchmarkSamples.LazLayered);
    }
}
