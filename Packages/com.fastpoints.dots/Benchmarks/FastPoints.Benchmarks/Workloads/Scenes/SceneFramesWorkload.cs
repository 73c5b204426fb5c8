using System.Globalization;
using FastPoints.Streaming;
using Unity.Mathematics;
using Camera = FastPoints.Picture.Camera;

namespace FastPoints.Benchmarks
{
    /// <summary>A camera flies a round low over a converted cloud in a scene, nodes coming and going: the error is the main
    /// thread's time for a frame that 99 of 100 do not exceed. Points are those of
    /// all frames, bytes those that came into the pool.</summary>
    public sealed class SceneFramesWorkload : IWorkload
    {
        const int Frames = 300, WidthPx = 1920, HeightPx = 1080;
        const double EyeMetres = 3;
        const int MaxBytesPerPoint = 10;

        double m_radiusMetres;
        SceneBenchmark m_scene;

        public string Name => "scene frames";
        public string LimitName => null;

        public void Prepare(WorkloadContext context)
        {
            m_radiusMetres = 0.3 * TerrainBenchmarkFile.SideMetres(context);
            // Twice what is drawn, so that nodes are loaded and evicted.
            int budget = context.Points / 16;
            m_scene = new SceneBenchmark(2L * MaxBytesPerPoint * budget);
            m_scene.Settings.Selection.PointBudget = budget;
            m_scene.Show(TerrainBenchmarkFile.MakeConverted(context));
            do
                m_scene.Frame(ViewAt(0));
            while (!m_scene.IsIdle);
        }

        public WorkloadResult Run()
        {
            long points = 0, uploaded = 0, garbage = 0;
            m_scene.ResetTimes();
            for (int frame = 0; frame < Frames; frame++)
            {
                var stats = m_scene.Frame(ViewAt(frame));
                points += stats.DrawnPoints;
                uploaded += stats.UploadedBytes;
                garbage += m_scene.Garbage;
            }
            var times = m_scene.FrameTimes;
            return m_scene.Result(points, uploaded, string.Format(CultureInfo.InvariantCulture,
                "main thread {0:0.0} ms a frame (p50), {1:0.0} (p99), {2:0.0} (max); {3} bytes of garbage in {4} frames",
                times.QuantileMs(0.5), times.QuantileMs(0.99), times.QuantileMs(1), garbage, Frames));
        }

        public void Dispose() => m_scene?.Dispose();

        StreamView ViewAt(int frame)
        {
            double angle = 2 * math.PI_DBL * frame / Frames;
            var limit = new double3(math.cos(angle), -0.1, -math.sin(angle));
            var eye = new double3(math.sin(angle) * m_radiusMetres, EyeMetres, math.cos(angle) * m_radiusMetres);
            return Camera.Perspective(eye, eye + limit, new double3(0, 1, 0), 60).ToStreamView(WidthPx, HeightPx);
        }
    }
}
