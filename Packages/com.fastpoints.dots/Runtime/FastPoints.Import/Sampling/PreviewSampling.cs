using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using FastPoints.Drawing;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Takes the sample of a preview from an open source: it finds the blocks if necessary, and if that takes a pass
    /// over the whole file, waves from prefixes come before. Owns the sample.</summary>
    public sealed class PreviewSampling : IDisposable
    {
        /// <summary>Stages that read all of a source: other work that reads it can run first.</summary>
        public const string FindBlocksStage = "find blocks", RefineStage = "refine";

        readonly PointReader m_reader;
        readonly SampleOptions m_options;
        readonly List<PreviewSample.Wave> m_waves = new List<PreviewSample.Wave>();
        readonly Stopwatch m_watch = new Stopwatch();
        readonly (long Bytes, DateTime WrittenUtc) m_fileBefore;

        public PreviewSampling(PointReader reader, SampleOptions options)
        {
            m_reader = reader;
            m_options = options;
            m_fileBefore = FileNow();
        }

        /// <summary>Raised on the coroutine's thread when there is a sample to draw, coarse to fine. This object owns it, and it
        /// belongs to the wave only until the work's next step.</summary>
        public event Action<PreviewSample, PreviewSample.Wave> WaveReady;

        bool IsQuick => m_options.Quick || m_reader.TakesFewRanges;

        public PreviewSample Sample { get; private set; }

        /// <summary>When each sample was ready, coarse to fine; the last one is <see cref="Sample"/>.</summary>
        public IReadOnlyList<PreviewSample.Wave> Waves => m_waves;

        /// <summary>Coroutine, with the stages <c>sample</c>, <see cref="FindBlocksStage"/> and
        /// <see cref="RefineStage"/>.</summary>
        /// <exception cref="PointCloudException">The source cannot be read.</exception>
        public IEnumerator<JobStep> Run(StageProgress progress)
        {
            m_watch.Restart();
            if (m_reader is IPrefixSource { HasPrefixes: true } && !m_options.Exact)
            {
                yield return JobStep.Of(TakePrefixes(progress));
                if (!IsQuick && Sample.IsOfPrefix)
                    DisposeSample();
            }
            if (Sample == null || !IsQuick && !Sample.HasAllPoints)
            {
                yield return JobStep.Of(IndexBlocks(progress));
                progress?.Begin("sample");
                yield return JobStep.Of(m_options.Exact ? Scan(progress) : TakeWaves(progress));
            }

            WarnIfChanged();
            progress?.End();
        }

        (long Bytes, DateTime WrittenUtc) FileNow()
        {
            var file = m_reader.Info.Path == null || m_reader.IsRemote ? null : new FileInfo(m_reader.Info.Path);
            return file != null && file.Exists ? (file.Length, file.LastWriteTimeUtc) : default;
        }

        /// <summary>A header and points of different files give nonsense, which is shown all the same.</summary>
        void WarnIfChanged()
        {
            var now = FileNow();
            if (now.Equals(m_fileBefore))
                return;
            m_reader.Info.Warn(0, "the file was changed while it was read (" + m_fileBefore.Bytes.ToString("N0",
                CultureInfo.InvariantCulture) + " bytes before, " + now.Bytes.ToString("N0", CultureInfo.InvariantCulture)
                + " now): the sample may be of neither state");
        }

        /// <summary>Whether a first sample consists of prefixes of blocks alone, which are ready soon and leave most of the
        /// cloud's cells empty: whole blocks replace them.</summary>
        public static bool Refines(PointReader reader) => !(reader is RecordReader) && reader.Tree == null;

        IEnumerator<JobStep> Scan(StageProgress progress)
        {
            using (var uniform = new FileOrderSampler(m_reader, m_options.Points, m_options.Seed))
            {
                yield return JobStep.Of(uniform.Run(0, progress));
                Sample = uniform.TakeSample();
            }
            var wave = new PreviewSample.Wave { Points = Sample.Count, BytesRead = Sample.BytesRead };
            Add(Sample, wave, m_watch.Elapsed.TotalSeconds, 0);
            yield return default;
        }

        IEnumerator<JobStep> TakeWaves(StageProgress progress)
        {
            bool refines = !IsQuick && Refines(m_reader);
            int wanted = refines ? RefiningSampler.FirstSamplePoints(m_reader, m_options.Points) : m_options.Points;
            if (Sample == null)
                yield return JobStep.Of(SampleWaves(wanted, progress));
            if (!refines || Sample.HasAllPoints)
                yield break;
            var ranges = new DisplayRanges { Units = m_reader.Info.Crs.Units };
            yield return JobStep.Of(ranges.Measure(Sample.Points, Sample.Transform, UpAxis.Z));
            double before = m_watch.Elapsed.TotalSeconds;
            long bytesBefore = m_waves[m_waves.Count - 1].BytesRead;
            progress?.Begin(RefineStage);
            using var sampler = new RefiningSampler(m_reader, m_options.Points, m_options.Seed, Sample, ranges.Robust);
            sampler.WaveReady += wave => Add(sampler.Sample, wave, before, bytesBefore);
            yield return JobStep.Of(sampler.Run(0, progress));
            Sample.Dispose();
            Sample = sampler.TakeSample();
        }

        IEnumerator<JobStep> SampleWaves(int wanted, StageProgress progress)
        {
            double before = m_watch.Elapsed.TotalSeconds;
            long bytesBefore = m_waves.Count == 0 ? 0 : m_waves[m_waves.Count - 1].BytesRead;
            using var sampler = new PreviewWaveSampler(m_reader, wanted, m_options.Seed);
            sampler.WaveReady += wave => Add(sampler.Sample, wave, before, bytesBefore);
            yield return JobStep.Of(sampler.Run(0, progress));
            Sample = sampler.TakeSample();
        }

        void Add(PreviewSample sample, PreviewSample.Wave wave, double secondsBefore, long bytesBefore)
        {
            wave.Seconds += secondsBefore;
            wave.BytesRead += bytesBefore;
            m_waves.Add(wave);
            WaveReady?.Invoke(sample, wave);
        }

        /// <summary>Takes a sample of what can be read before the blocks are found, which takes a pass over the whole file: of
        /// its beginning, or spread all over it.</summary>
        IEnumerator<JobStep> TakePrefixes(StageProgress progress)
        {
            progress?.Begin("sample");
            // A sampler searches for as many spread prefixes as a wave needs.
            yield return JobStep.Of(((IPrefixSource)m_reader).FindPrefixes(1));
            yield return JobStep.Of(SampleWaves(m_options.Points, progress));
            var estimate = ((IPrefixSource)m_reader).EstimatedPoints;
            Sample.PointsInSource = (long)Math.Min(Math.Round(estimate.Points), 1L << 62);
            Sample.IsOfPrefix = !Sample.HasAllPoints && !(m_reader is LineReader);
            if (m_reader is LineReader)
            {
                Sample.Method = "lines of stretches all over the file";
                if (IsQuick && estimate.StandardError > 0)
                    m_reader.Info.Warn(0, "the lines were not counted: "
                        + estimate.Points.ToString("N0", CultureInfo.InvariantCulture)
                        + " is an estimate with a standard error of "
                        + estimate.StandardError.ToString("N0", CultureInfo.InvariantCulture));
            }
            if (!Sample.IsOfPrefix)
                yield break;
            Sample.Method = "the file's beginning alone";
            if (IsQuick)
                m_reader.Info.Warn(0, "where the points lie is not known before all are decoded: the sample is of the file's "
                    + "beginning alone, " + (100 * Sample.Fraction).ToString("0.##", CultureInfo.InvariantCulture)
                    + " % of the points, and shows nothing of the rest");
        }

        IEnumerator<JobStep> IndexBlocks(StageProgress progress)
        {
            if (m_reader.BlocksAreKnown)
                yield break;
            progress?.Begin(FindBlocksStage);
            yield return JobStep.Of(m_reader.IndexBlocks());
        }

        void DisposeSample()
        {
            Sample?.Dispose();
            Sample = null;
        }

        public void Dispose() => DisposeSample();
    }

    /// <summary>Options of a <see cref="PreviewSampling"/>.</summary>
    public class SampleOptions
    {
        /// <summary>Number of points in the sample.</summary>
        public int Points = 1_000_000;

        public uint Seed = 1;

        /// <summary>Whether to choose from a scan of all points instead of short ranges.</summary>
        public bool Exact;

        /// <summary>Whether to stop at the sample that reads little, even if it consists of prefixes of blocks, or of the file's
        /// prefix.</summary>
        public bool Quick;
    }
}
