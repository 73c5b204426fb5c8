using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using FastPoints.Base;
using FastPoints.Convert;
using FastPoints.Files;
using FastPoints.LazEncoding;
using FastPoints.Points;
using FastPoints.Samplers;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>A conversion beside frames, as an editor runs it: all workers, and a tick of the pump a frame. Each frame has a
    /// few small jobs of its own and waits for them before it ends: how long, is the error. Its limit is the same conversion
    /// run to its end with as many workers.</summary>
    sealed class FrameBesideBuildWorkload : IWorkload
    {
        /// <summary>Seconds of each stage of the last run to the end of the same build.</summary>
        readonly Dictionary<string, double> m_toTheEnd;
        readonly bool m_isLaz;
        readonly Sampler m_sampler;
        readonly double m_frameMs;
        readonly double m_tickMs;
        string m_source;
        string m_target;

        /// <param name="frameMs">0 to run to the end.</param>
        FrameBesideBuildWorkload(bool isLaz, Sampler sampler, double frameMs, double tickMs, Dictionary<string, double> toTheEnd)
            => (m_isLaz, m_sampler, m_frameMs, m_tickMs, m_toTheEnd) = (isLaz, sampler, frameMs, tickMs, toTheEnd);

        public static IEnumerable<IWorkload> All()
        {
            foreach (bool isLaz in new[] { false, true })
            {
                foreach (var sampler in new[] { Sampler.Random, Sampler.Poisson })
                {
                    var toTheEnd = new Dictionary<string, double>();
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 0, 0, toTheEnd);
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 1000.0 / 60, 2, toTheEnd);
                    // An editor without focus.
                    yield return new FrameBesideBuildWorkload(isLaz, sampler, 100, 4, toTheEnd);
                }
            }
        }

        public string Name => m_frameMs == 0 ? "no frame beside " + Build
            : string.Format(CultureInfo.InvariantCulture, "frame beside {0} at {1:0} Hz", Build, 1000 / m_frameMs);
        public string LimitName => m_frameMs == 0 ? null : "no frame beside " + Build;

        string Build => (m_isLaz ? "laz " : "las ") + m_sampler.ToString().ToLowerInvariant();

        public void Prepare(WorkloadContext context)
        {
            m_source = TerrainBenchmarkFile.Make(context);
            if (m_isLaz)
                m_source = Compressed(m_source);
            m_target = Path.Combine(context.ScratchFolder, Name + ".fastpoints");
        }

        static string Compressed(string las)
        {
            string laz = Path.ChangeExtension(las, ".laz");
            if (File.Exists(laz))
                return laz;
            using var stream = File.Create(laz);
            LazFile.Write(las, stream, new StageProgress(), default);
            return laz;
        }

        public WorkloadResult Run()
        {
            var progress = new StageProgress();
            ConvertResult result = null;
            var settings = new ConvertSettings
            {
                Sampler = m_sampler,
                Workers = Math.Max(1, JobsUtility.JobWorkerCount),
                AheadMs = m_frameMs > 50 ? 250 : 50,
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            using var reader = PointReaders.Open(m_source);
            var work = ConvertCloud.Run(new[] { reader }, m_target, settings, r => result = r, progress);
            var done = new WorkloadResult { Bytes = reader.Info.FileBytes };
            if (m_frameMs == 0)
                WorkPump.RunToEnd(work);
            else
                RunBeside(work, progress, ref done);
            foreach (var stage in progress.Finished)
                if (m_frameMs == 0)
                    m_toTheEnd[stage.Name] = stage.Seconds;
            done.Points = result.Manifest.Points;
            return done;
        }

        public void Dispose()
        {
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }

        void RunBeside(IEnumerator<Work> work, StageProgress progress, ref WorkloadResult done)
        {
            using var frames = new FrameLoop(m_tickMs, JobsUtility.JobWorkerCount);
            frames.Run(work, m_frameMs);
            done.Error = frames.WaitMs;
            done.ErrorUnit = "ms p99 wait";
            done.Note = frames.Frames + " " + frames.Times + "; stages took, and to the end:" + Shares(progress);
        }

        string Shares(StageProgress progress) => string.Concat(progress.Finished.Where(s => m_toTheEnd.ContainsKey(s.Name))
            .Select(s => string.Format(CultureInfo.InvariantCulture, " {0} {1:0} of {2:0} ms,", s.Name, 1000 * s.Seconds,
                1000 * m_toTheEnd[s.Name]))).TrimEnd(',');
    }
}
