using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Takes a sample of a source by reading little of it, in waves, coarse to fine, each a prefix of the next one and
    /// spread over all of the source. The time it takes depends on the points wanted, hardly on the source's size.</summary>
    /// <remarks>The sample is the same for the same source, seed and number of points, on any number of threads and slots and any
    /// disk. All members belong to the thread of the coroutine.</remarks>
    internal sealed class PreviewWaveSampler : IDisposable
    {
        /// <summary>Points at which a wave ends; the last one ends with the sample.</summary>
        static readonly int[] s_waves = { 2_000, 20_000, 200_000, 1_000_000, 4_000_000 };

        /// <summary>A wave this close to the end continues to it: another one would show hardly more, and may decode
        /// all prefixes again.</summary>
        const double MinShareOfLast = 0.75;

        readonly PointReader m_reader;
        readonly PreviewWaveReader m_reads;
        readonly SampleBuffer m_buffer;
        readonly Stopwatch m_watch = new Stopwatch();

        /// <param name="reader">A reader whose blocks are known.</param>
        /// <param name="wanted">Number of points, limited to <see cref="PreviewSample.MaxPoints"/>.</param>
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public PreviewWaveSampler(PointReader reader, int wanted, uint seed)
        {
            m_reader = reader;
            wanted = Math.Max(0, Math.Min(wanted, PreviewSample.MaxPoints(SampleSchema.Of(reader.Info))));
            m_reads = reader is RecordReader
                ? (PreviewWaveReader)new RangeWaveReader(reader, wanted, seed)
                : new PrefixWaveReader(reader, wanted, seed);
            m_buffer = m_reads.Buffer;
            Sample = m_buffer.CreateSample();
            Sample.Method = m_reads.Method;
        }

        /// <summary>Raised on the coroutine's thread after each wave, which is a prefix of <see cref="Sample"/> that can be drawn
        /// from then on.</summary>
        public event Action<PreviewSample.Wave> WaveReady;

        public PreviewSample Sample { get; private set; }

        /// <summary>Coroutine.</summary>
        /// <param name="slots">Reads in flight; 0 for a default.</param>
        public IEnumerator<JobStep> Run(int slots, StageProgress progress)
        {
            m_watch.Restart();
            try
            {
                for (int wave = 0; m_reads.EndIndex < m_buffer.EntryCount; wave++)
                {
                    int first = m_reads.EndIndex;
                    int wanted = EntriesOf(wave);
                    bool isLast = wanted == m_buffer.EntryCount;
                    yield return JobStep.Of(m_reads.Read(wanted, isLast ? 0 : EntriesOf(wave + 1), slots, progress));
                    if (m_reads.EndIndex > first)
                    {
                        yield return JobStep.Of(m_buffer.Compact(first, m_reads.EndIndex, m_reads.Filling));
                        m_reads.EndReads();
                        RaiseWave();
                        m_reads.Report(progress);
                        // The wave belongs to the code that steps the work until the next step.
                        yield return default;
                    }
                    if (isLast)
                        break;
                }
            }
            finally
            {
                m_reads.Free();
            }
        }

        int EntriesOf(int wave) => wave >= s_waves.Length || s_waves[wave] >= MinShareOfLast * m_buffer.EntryCount
            ? m_buffer.EntryCount
            : s_waves[wave];

        void RaiseWave()
        {
            m_buffer.UpdateSample(Sample);
            Sample.Method = m_reads.Method;
            Sample.BytesRead = m_reads.BytesRead;
            Sample.PointsInSource = m_reader.PointCount;
            WaveReady?.Invoke(new PreviewSample.Wave
            {
                Points = Sample.Count,
                Seconds = m_watch.Elapsed.TotalSeconds,
                BytesRead = m_reads.BytesRead,
            });
        }

        /// <summary>Hands the sample over, once; null after that.</summary>
        public PreviewSample TakeSample()
        {
            var sample = Sample;
            Sample = null;
            return sample;
        }

        public void Dispose()
        {
            m_reads.Free();
            m_buffer.Dispose();
            Sample?.Dispose();
            Sample = null;
        }
    }
}
