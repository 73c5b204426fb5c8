using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Draw;
using FastPoints.Files;
using FastPoints.SourceFeeds;
using FastPoints.Verify;

namespace FastPoints.Benchmarks
{
    /// <summary>Work that a pump steps beside frames: alone, at 60 Hz, and at 10 Hz, as an editor without focus has. The error is
    /// how long frames wait for their own jobs; the note has the shares of the speed alone, and the ticks.</summary>
    public sealed class BesideFramesWorkload : IWorkload
    {
        readonly double m_tickMs;
        readonly Func<WorkloadContext, string> m_find;
        readonly Func<string, IEnumerator<Work>> m_begin;
        string m_path;
        long m_points;

        /// <param name="tickMs">Main-thread time of the work in a frame.</param>
        /// <param name="find">The input's path; null where there is none.</param>
        /// <param name="begin">Makes the work once more.</param>
        BesideFramesWorkload(string name, double tickMs, Func<WorkloadContext, string> find,
            Func<string, IEnumerator<Work>> begin)
        {
            Name = "frame beside " + name;
            m_tickMs = tickMs;
            m_find = find;
            m_begin = begin;
        }

        public string Name { get; }
        public string LimitName => null;

        public static IEnumerable<IWorkload> All() => new[]
        {
            new BesideFramesWorkload("verify", 4, TerrainBenchmarkFile.MakeConverted, Verify),
            new BesideFramesWorkload("preview las", 2, TerrainBenchmarkFile.Make, Preview),
            new BesideFramesWorkload("preview laz", 2, c => BenchmarkSamples.Find(c, BenchmarkSamples.LazLayered), Preview),
        };

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            m_points = context.Points;
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            using (var frames = new FrameLoop(m_tickMs, Math.Max(1, Environment.ProcessorCount - 1)))
            {
                string note = frames.Compare(() => m_begin(m_path));
                return new WorkloadResult
                {
                    Points = 3 * m_points,
                    Error = frames.WaitMs,
                    ErrorUnit = "ms p99 wait",
                    Note = note,
                };
            }
        }

        public void Dispose()
        {
        }

        static IEnumerator<Work> Verify(string cloud)
        {
            var result = new VerifyResult();
            yield return Work.Of(VerifyCloud.Run(cloud, Array.Empty<PointReader>(), result, null));
            if (!result.Ok)
                throw new InvalidOperationException(result.Problems[0]);
        }

        /// <summary>As a scene takes it, and drawn.</summary>
        static IEnumerator<Work> Preview(string file)
        {
            using (var reader = PointReaders.Open(file))
            using (var preview = new PreviewCloud(reader, new PreviewOptions { Points = SourceFeed.PreviewPoints }))
                yield return Work.Of(preview.Run(null));
        }
    }
}
