using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Reads every block of a source once, all of them deeper from wave to wave (<see cref="RefiningPlan"/>), and offers
    /// a sample to draw at a fifth, at a half and at the end, when it equals that of <see cref="FileOrderSampler"/> point for
    /// point.</summary>
    /// <remarks>Until then the sample has those of its points that were reached, and instead of the others the first point of
    /// each cell that would be empty although points in it were read (spatial thinning). It is the same for any number of threads
    /// and slots. All members belong to the coroutine's thread; disposing the work stops at once and leaves the last wave's
    /// sample.</remarks>
    internal sealed class RefiningSampler : IThrottledConsumer, IDisposable
    {
        /// <summary>Shares of the points at which a wave ends. Each costs as much as a twentieth of decoding some million points,
        /// for keeping states and composing the sample: one more, at a fifteenth, delayed all others.</summary>
        static readonly double[] s_shares = { 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1 };

        /// <summary>From this share on, waves always come. Before it they come only if blocks are read whole, and after this many
        /// points, whose decoding takes half a second.</summary>
        const double FirstCertainShare = 0.2;
        const long MinPointsOfEarlierWaves = 2_000_000;

        /// <summary>A first sample of this many points is always worth its time; one in this many if there are too many blocks to
        /// reach together.</summary>
        const int MinFirstSamplePoints = 20_000, PointsPerFirstSamplePoint = 25;

        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly SampleStrata m_strata;
        readonly BoundsGeo m_bounds;
        readonly uint m_seed;
        readonly List<PreviewSample.Wave> m_waves = new List<PreviewSample.Wave>();
        readonly Stopwatch m_watch = new Stopwatch();
        SampleBuffer m_buffer;
        RefiningPlan m_plan;
        DecoderState[] m_stateOfBlock;
        readonly Stack<DecoderState> m_freeStates = new Stack<DecoderState>();
        readonly List<NativeArray<PointColumn>> m_columnsOfSlot = new List<NativeArray<PointColumn>>();
        ReadSlots m_slots;
        PlaceholderPoints m_placeholders;
        StageProgress m_progress;
        readonly PreviewSample m_firstSample;
        long m_pointsRead;
        long m_bytesRead;
        int m_rangesRead;
        bool m_isLastWave;

        /// <param name="reader">A reader whose blocks are known.</param>
        /// <param name="wanted">Number of points, limited to <see cref="PreviewSample.MaxPoints"/>.</param>
        /// <param name="firstSample">A first sample, shown where nothing else has been reached; the caller owns it and keeps it
        /// until the first wave.</param>
        /// <param name="bounds">The bounds of nearly all points, by that sample.</param>
        /// <exception cref="PointCloudException">The source has no positions.</exception>
        public RefiningSampler(PointReader reader, int wanted, uint seed, PreviewSample firstSample, BoundsGeo bounds)
        {
            m_firstSample = firstSample;
            m_reader = reader;
            m_seed = seed;
            m_schema = SampleSchema.Of(reader.Info);
            m_strata = new SampleStrata(reader.PointCount, Math.Min(wanted, PreviewSample.MaxPoints(m_schema)), seed);
            m_bounds = bounds;
        }

        /// <summary>Points of the first sample before this one: what it decodes is decoded again.</summary>
        public static int FirstSamplePoints(PointReader reader, int wanted) => (int)Math.Min(wanted,
            reader.BlockCount <= RefiningPlan.MaxSlicedBlocks ? MinFirstSamplePoints
                : Math.Max(MinFirstSamplePoints, reader.PointCount / PointsPerFirstSamplePoint));

        public event Action<PreviewSample.Wave> WaveReady;

        public IReadOnlyList<PreviewSample.Wave> Waves => m_waves;

        /// <summary>The last wave's sample until the next one replaces and disposes it; null before the first.</summary>
        public PreviewSample Sample { get; private set; }

        public bool IsPaused { get; set; } // While set, no more reads begin, so that other work can use the machine.

        bool IThrottledConsumer.IsReady => !IsPaused;

        /// <summary>Coroutine, once.</summary>
        /// <param name="slots">Blocks in flight; 0 for what <see cref="PreviewWaveReader.LimitFor"/> says.</param>
        public IEnumerator<JobStep> Run(int slots, StageProgress progress)
        {
            m_watch.Restart();
            try
            {
                Allocate(slots);
                if (!m_plan.IsSliced && m_firstSample != null)
                    yield return JobStep.Of(m_placeholders.Append(m_firstSample.Points, m_firstSample.Count));
                foreach (double share in s_shares)
                {
                    if (share < FirstCertainShare && (m_plan.IsSliced || share * m_reader.PointCount < MinPointsOfEarlierWaves))
                        continue;
                    // A wave never shows less than the one before.
                    if (share < 1 && m_plan.IsSliced && m_firstSample != null && share * m_strata.Count < m_firstSample.Count)
                        continue;
                    m_isLastWave = share == 1;
                    m_progress = progress;
                    for (var next = NextRanges(share); next.Count > 0; next = NextRanges(share))
                    {
                        var ranges = next;
                        yield return JobStep.Of(m_slots.Run(this, ScanRanges.Of(m_reader, ranges, 0),
                            (read, n) => Begin(read, ranges[n]), null));
                        while (!m_isLastWave && m_placeholders.AreTooMany)
                            yield return JobStep.Of(m_placeholders.Coarsen(m_buffer));
                    }
                    if (m_isLastWave)
                        yield return JobStep.Of(m_slots.Free());
                    yield return JobStep.Of(m_isLastWave ? ComposeLast() : Compose());
                    RaiseWave();
                    // The wave belongs to the code that steps the work until the next step.
                    yield return default;
                }
            }
            finally
            {
                Free();
            }
        }

        void Allocate(int slots)
        {
            m_buffer = new SampleBuffer(m_schema, m_reader.Info.Transform, m_strata.Count);
            m_slots = new ReadSlots(m_reader, m_schema, m_reader.MaxPointsPerBlock,
                PreviewWaveReader.LimitFor(m_reader, m_schema, slots, SourceScan.SlotsFor(m_reader, m_schema)), 0);
            // Of a remote block it is not known ahead what a slice needs.
            bool canSlice = m_reader.BlockCount <= RefiningPlan.MaxSlicedBlocks && !m_reader.IsRemote &&
                m_slots.TryEnableStates();
            m_plan = new RefiningPlan(m_reader, canSlice, m_seed);
            m_stateOfBlock = m_plan.IsSliced ? new DecoderState[m_reader.BlockCount] : null;
            m_placeholders = new PlaceholderPoints(m_schema, m_reader.Info.Transform, m_strata.Count, m_bounds);
        }

        /// <summary>A round of the wave, after which placeholders can be thinned. In the last wave there are none: it is one
        /// round, since reads run out at the end of each.</summary>
        List<BlockRange> NextRanges(double share)
        {
            var ranges = m_plan.Next(share);
            for (var more = ranges; m_isLastWave && more.Count > 0; ranges.AddRange(more))
                more = m_plan.Next(share);
            return ranges;
        }

        void Begin(BlockRead read, BlockRange range)
        {
            if (!m_plan.IsSliced)
            {
                read.Begin(range);
                return;
            }
            var from = m_stateOfBlock[range.Block];
            read.Begin(range, from);
            if (from == null)
                return;
            m_freeStates.Push(from);
            m_stateOfBlock[range.Block] = null;
        }

        JobHandle IBlockConsumer.Schedule(BlockRead read, int slot, JobHandle decoded)
        {
            if (m_strata.Count == 0)
                return decoded;
            while (m_columnsOfSlot.Count <= slot)
                m_columnsOfSlot.Add(SampleBuffer.ColumnsOf(read.Points));
            var chosen = m_buffer.Schedule(read, m_columnsOfSlot[slot], m_strata, decoded);
            // The final sample has no placeholders.
            return m_isLastWave ? chosen : JobHandle.CombineDependencies(chosen, m_placeholders.ScheduleAppend(read,
                m_columnsOfSlot[slot], m_strata, decoded));
        }

        void IBlockConsumer.Completed(BlockRead read, int slot)
        {
            int block = read.Range.Block;
            m_pointsRead += read.Points.Count;
            m_rangesRead++;
            m_bytesRead += m_reader.BytesOfRange(read.Range) - (read.Range.First == 0 ? 0
                : m_reader.BytesOfRange(new BlockRange(block, 0, read.Range.First)));
            m_plan.EndIfShort(read.Range, read.Points.Count);
            if (m_plan.IsSliced && !m_plan.IsTaken(block))
                m_stateOfBlock[block] = read.KeepState(m_freeStates.Count > 0 ? m_freeStates.Pop() : null);
            m_progress?.Report(m_pointsRead / (double)Math.Max(1, m_reader.PointCount), m_pointsRead, m_bytesRead);
        }

        IEnumerator<JobStep> Compose()
        {
            // A point of the first sample may have been reached again.
            if (!m_plan.IsSliced)
                yield return JobStep.Of(m_placeholders.Thin(m_buffer));
            // Consecutive points are chosen from at most as many strata as they span, plus one at either end.
            long own = m_pointsRead * m_strata.Count / Math.Max(1, m_reader.PointCount) + 2L * m_rangesRead;
            using var composed = new SampleBuffer(m_schema, m_reader.Info.Transform,
                (int)Math.Min(m_strata.Count, own + m_placeholders.Count));
            yield return JobStep.Of(composed.Append(m_buffer, 0, m_strata.Count));
            int placeholders = Math.Min(m_placeholders.Count, composed.EntryCount - composed.ExaminedCount);
            yield return JobStep.Of(composed.Append(m_placeholders.Points, 0, placeholders));
            Replace(composed.CreateSample());
            Sample.PointsInSource = m_reader.PointCount;
            Sample.PlaceholderCount = placeholders;
            Sample.Method = "points of a full scan as far as it has come, and others where a region would be bare";
        }

        IEnumerator<JobStep> ComposeLast()
        {
            yield return JobStep.Of(m_buffer.Compact(0, m_buffer.EntryCount));
            Replace(m_buffer.CreateSample());
            Sample.PointsInSource = m_pointsRead;
            Sample.IsFullScan = true;
            Sample.Method = "full scan, one point of each stratum";
        }

        void Replace(PreviewSample sample)
        {
            Sample?.Dispose();
            Sample = sample;
            Sample.BytesRead = m_bytesRead;
        }

        void RaiseWave()
        {
            double seconds = m_watch.Elapsed.TotalSeconds;
            var wave = new PreviewSample.Wave { Points = Sample.Count, Seconds = seconds, BytesRead = m_bytesRead };
            m_waves.Add(wave);
            WaveReady?.Invoke(wave);
        }

        /// <summary>Hands over the last wave's sample, once; null if there is none.</summary>
        public PreviewSample TakeSample()
        {
            var sample = Sample;
            Sample = null;
            return sample;
        }

        /// <summary>Frees everything except the last wave's sample and awaits jobs in flight. May be called twice.</summary>
        void Free()
        {
            m_slots?.Dispose();
            m_slots = null;
            foreach (var columns in m_columnsOfSlot)
                columns.Dispose();
            m_columnsOfSlot.Clear();
            for (int i = 0; m_stateOfBlock != null && i < m_stateOfBlock.Length; i++)
                m_stateOfBlock[i]?.Dispose();
            m_stateOfBlock = null;
            while (m_freeStates.Count > 0)
                m_freeStates.Pop().Dispose();
            m_buffer?.Dispose();
            m_buffer = null;
            m_placeholders?.Dispose();
            m_placeholders = null;
        }

        public void Dispose()
        {
            Free();
            Sample?.Dispose();
            Sample = null;
        }
    }
}
