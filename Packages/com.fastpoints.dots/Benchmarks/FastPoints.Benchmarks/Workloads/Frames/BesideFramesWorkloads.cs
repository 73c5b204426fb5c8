using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using FastPoints.Build;
using FastPoints.Export;
using FastPoints.Nodes;
using FastPoints.Picture;
using FastPoints.Reading;
using FastPoints.Sources;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Benchmarks
{
    /// <summary>Work that a coroutine steps beside frames, at 60 Hz and at 10 Hz, as an editor without focus has. Its limit is
    /// the same work run to its end by as many workers, while the main thread does nothing but step it; with the main thread's
    /// help there is one more of them. The error is how long frames wait for their own jobs; the note has medians of all
    /// runs.</summary>
    public sealed class BesideFramesWorkload : IWorkload
    {
        /// <summary>How the work is run: by a frame, the coroutine's share of it, and how far workers are kept busy ahead. At 10
        /// Hz as the package's editor does without focus: 4 ms of each sixtieth of a second, all at once.</summary>
        static readonly (string Name, double FrameMs, double TickMs, double InFlightMs)[] s_modes =
        {
            ("to its end by workers alone", 0, 0, 0), ("with the main thread's help", -1, 0, 0),
            ("at 60 Hz", 1000.0 / 60, 2, 50), ("at 10 Hz", 100, 24, 250),
        };

        readonly Func<WorkloadContext, string> m_find;
        readonly Func<BesideFramesWorkload, StageProgress, double, IEnumerator<JobStep>> m_begin;
        readonly List<double>[] m_runMs = s_modes.Select(m => new List<double>()).ToArray();
        string m_path;
        string m_target;
        long m_points;

        BesideFramesWorkload(string name, Func<WorkloadContext, string> find,
            Func<BesideFramesWorkload, StageProgress, double, IEnumerator<JobStep>> begin)
        {
            Name = "frame beside " + name;
            m_find = find;
            m_begin = begin;
        }

        public string Name { get; }
        public string LimitName => null;

        public static IEnumerable<IWorkload> All()
        {
            foreach (var sampler in new[] { Sampler.Random, Sampler.Poisson })
            {
                string name = sampler.ToString().ToLowerInvariant();
                yield return new BesideFramesWorkload("convert las " + name, TerrainBenchmarkFile.Make,
                    (w, progress, ms) => w.Convert(sampler, progress, ms));
                yield return new BesideFramesWorkload("convert laz " + name, Compressed,
                    (w, progress, ms) => w.Convert(sampler, progress, ms));
            }
            yield return new BesideFramesWorkload("verify", TerrainBenchmarkFile.MakeConverted, Verify);
            yield return new BesideFramesWorkload("preview las", TerrainBenchmarkFile.Make, Preview);
            yield return new BesideFramesWorkload("preview laz",
                c => BenchmarkSamples.Find(c, BenchmarkSamples.LazLayered), Preview);
        }

        public void Prepare(WorkloadContext context)
        {
            m_path = m_find(context);
            m_points = context.Points;
            m_target = Path.Combine(context.ScratchFolder, Name + ".fastpoints");
        }

        public WorkloadResult Run()
        {
            if (m_path == null)
                return default;
            var result = new WorkloadResult { Points = s_modes.Length * m_points, ErrorUnit = "ms p99 wait" };
            var stages = new StageProgress[s_modes.Length];
            var times = new string[s_modes.Length];
            for (int i = 0; i < s_modes.Length; i++)
            {
                var mode = s_modes[i];
                stages[i] = new StageProgress();
                using var frames = new FrameLoop(mode.TickMs, Math.Max(1, JobsUtility.JobWorkerCount));
                m_runMs[i].Add(frames.Run(m_begin(this, stages[i], mode.InFlightMs), mode.FrameMs));
                stages[i].End();
                times[i] = frames.Frames == 0 ? "" : ", " + frames.Times;
                result.Error = Math.Max(result.Error, frames.Frames == 0 ? 0 : frames.WaitMs);
                Delete();
            }
            result.Note = string.Join("; ", s_modes.Select((m, i) => Text("{0} {1:0} ms ({2:0} %){3}", m.Name, Median(i),
                100 * Median(0) / Median(i), times[i]))) + "; stages in this order, ms:" + Stages(stages);
            return result;
        }

        public void Dispose() => Delete();

        void Delete()
        {
            if (Directory.Exists(m_target))
                Directory.Delete(m_target, true);
        }

        double Median(int mode) => m_runMs[mode].OrderBy(ms => ms).ElementAt(m_runMs[mode].Count / 2);

        static string Stages(StageProgress[] stages) => string.Concat(stages[0].Finished.Select((s, i) => " " + s.Name + " "
            + string.Join(", ", stages.Select(m => i < m.Finished.Count ? Text("{0:0}", 1000 * m.Finished[i].Seconds) : "-"))
            + ";")).TrimEnd(';');

        static string Text(string format, params object[] values) => string.Format(CultureInfo.InvariantCulture, format, values);

        static string Compressed(WorkloadContext context)
        {
            string las = TerrainBenchmarkFile.Make(context), laz = Path.ChangeExtension(las, ".laz");
            if (File.Exists(laz))
                return laz;
            using var reader = PointReaders.Open(las);
            JobCoroutine.RunToEnd(ExportCloud.Run(reader, laz, new ExportSettings(), _ => { }, null));
            return laz;
        }

        IEnumerator<JobStep> Convert(Sampler sampler, StageProgress progress, double inFlightMs)
        {
            var settings = new ConvertSettings
            {
                Sampler = sampler,
                Workers = JobsUtility.JobWorkerCount,
                InFlightMs = inFlightMs,
                Attributes = new[] { AttributeNames.Red, AttributeNames.Green, AttributeNames.Blue },
            };
            using var reader = PointReaders.Open(m_path);
            yield return JobStep.Of(ConvertCloud.Run(new[] { reader }, m_target, settings, r => { }, progress));
        }

        static IEnumerator<JobStep> Verify(BesideFramesWorkload workload, StageProgress progress, double inFlightMs)
        {
            var result = new VerifyResult();
            yield return JobStep.Of(VerifyCloud.Run(workload.m_path, Array.Empty<PointReader>(), result, progress));
            if (!result.Ok)
                throw new InvalidOperationException(result.Problems[0]);
        }

        static IEnumerator<JobStep> Preview(BesideFramesWorkload workload, StageProgress progress, double inFlightMs)
        {
            using (var reader = PointReaders.Open(workload.m_path))
            using (var preview = new PreviewPicture(reader, new PreviewOptions { Points = SourceFeed.PreviewPoints }))
                yield return JobStep.Of(preview.Run(progress));
        }
    }
}
