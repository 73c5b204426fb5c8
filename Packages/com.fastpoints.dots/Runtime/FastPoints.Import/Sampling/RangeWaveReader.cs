using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Samples short ranges of evenly spaced points from all over a source of fixed stride: see <see cref="RangePlan"/>
    /// for which.</summary>
    /// <remarks>The time of the first reads decides between two plans (<see cref="ReadStrategy"/>), and the time of the first
    /// wave's reads decides which gaps between ranges are read along.</remarks>
    sealed class RangeWaveReader : PreviewWaveReader
    {
        /// <summary>Ranges in one request: the most take a worker about a millisecond; the fewest take the main thread
        /// as long to begin as any others.</summary>
        const int MaxRangesPerRequest = 1536, MinRangesPerRequest = 16;
        const int RemoteSlots = 8, RangesPerFetch = 128; // Of a remote file: what is fetched waits elsewhere.
        const int RangesPerSlice = 1 << 14; // Ranges in one slice of planning them: about 2 ms of managed code.
        const int SlotBytes = 2 << 20; // Bytes of a slot's buffer; only pages that are read take memory.

        readonly int m_wanted;
        readonly uint m_seed;
        RangePlan m_plan;
        ReadStrategy m_pace;
        StridedRead[] m_reads;
        NativeArray<int> m_ranks;
        NativeReference<int> m_nextIndex;
        NativeList<StridedRange> m_ranges;
        NativeList<StridedRange> m_nextRanges; // Ranges of the next wave, up to m_plannedEnd: planned while this one is read.
        SlotRing m_ring;
        StageProgress m_progress;
        bool m_isFirstWave = true;
        int m_endRank;
        int m_plannedEnd;
        int m_gapBytes;
        long m_segments;
        long m_waveBegun;
        long m_waveEnded;

        public RangeWaveReader(PointReader reader, int wanted, uint seed)
            : this(reader, wanted, seed, reader.TakesFewRanges ? RangePlan.OfRemote(reader.PointCount, wanted, seed)
                : new RangePlan(reader.PointCount, wanted, reader.Info.RecordBytes, seed))
        {
        }

        RangeWaveReader(PointReader reader, int wanted, uint seed, RangePlan plan)
            : base(reader, plan.EntryCount,
                plan.RangeCount + " runs of evenly spaced points, one in each stratum of the file, in waves")
        {
            m_wanted = wanted;
            m_seed = seed;
            m_plan = plan;
        }

        public override IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress)
        {
            if (m_reads == null)
            {
                yield return JobStep.Of(ChoosePlan());
                Allocate(slots > 0 ? slots : Reader.IsRemote ? RemoteSlots : m_pace.Slots);
            }
            int end = m_plan.RangesFor(wanted);
            if (end == m_endRank)
                yield break;
            if (m_plannedEnd != end)
                yield return JobStep.Of(PlanWave(m_endRank, end));
            yield return Filling;
            Filling.Complete();
            (m_ranges, m_nextRanges) = (m_nextRanges, m_ranges);
            m_progress = progress;
            yield return JobStep.Of(BeginReads());
            int nextEnd = m_plan.RangesFor(next);
            if (nextEnd > end)
                yield return JobStep.Of(PlanWave(end, nextEnd));
            m_endRank = end;
            EndIndex = m_plan.FirstEntryOf(end);
        }

        /// <summary>Coroutine: reads the first ranges of the usual plan, and changes to the other one if that is
        /// slow.</summary>
        IEnumerator<JobStep> ChoosePlan()
        {
            m_gapBytes = m_pace.GapBytes(0);
            if (Reader.IsRemote || m_plan.RangeCount < ReadStrategy.TrialReads || m_plan.EntryCount >= Reader.PointCount)
                yield break;
            m_reads = new StridedRead[ReadStrategy.TrialReads];
            m_ranges = new NativeList<StridedRange>(Allocator.Persistent);
            for (int rank = 0, index = 0; rank < ReadStrategy.TrialReads; index++)
            {
                int stratum = m_plan.Order.StratumAt(index);
                if (stratum < 0)
                    continue;
                m_plan.RangeOf(stratum, rank, out var range, out _);
                m_ranges.Add(range);
                m_reads[rank] = ((RecordReader)Reader).CreateStridedRead(Buffer.Points, 1,
                    m_plan.MaxSegmentPoints * Reader.Info.RecordBytes, Allocator.Persistent);
                m_reads[rank].Begin(m_ranges.AsArray(), rank, 1, 0);
                rank++;
            }
            JobHandle.ScheduleBatchedJobs();
            double quickest = double.PositiveInfinity;
            foreach (var read in m_reads)
            {
                yield return read.Decoded;
                read.Complete();
                BytesRead += read.BytesRead;
                quickest = Math.Min(quickest, ReadClock.Seconds(read.Begun, read.Ended));
            }
            Free();
            m_pace = ReadStrategy.Of(quickest, Reader.PointCount * Reader.Info.RecordBytes);
            if (!m_pace.IsSlow)
                yield break;
            m_plan = new RangePlan(Reader.PointCount, m_wanted, Reader.Info.RecordBytes, m_seed, m_pace.PointsPerRange);
            Method = m_plan.RangeCount + " long runs of evenly spaced points, as reads take long, one in each stratum of " +
                "the file, in waves";
        }

        void Allocate(int slots)
        {
            m_ranks = new NativeArray<int>(m_plan.RangeCount, Allocator.Persistent);
            m_nextIndex = new NativeReference<int>(Allocator.Persistent);
            m_ranges = new NativeList<StridedRange>(MaxRangesPerRequest, Allocator.Persistent);
            m_nextRanges = new NativeList<StridedRange>(MaxRangesPerRequest, Allocator.Persistent);
            m_reads = new StridedRead[slots];
            m_ring = new SlotRing(slots);
        }

        /// <summary>Coroutine: schedules the jobs that plan the next wave's ranges, in the file's order, and what depends on
        /// it.</summary>
        IEnumerator<JobStep> PlanWave(int firstRank, int endRank)
        {
            var ranges = m_nextRanges;
            ranges.Clear();
            m_plannedEnd = endRank;
            var planned = default(JobHandle);
            yield return JobStep.Of(Slices.Schedule(endRank - firstRank, RangesPerSlice, (first, end, after) => new RankStrataJob
            {
                Order = m_plan.Order,
                NextIndex = m_nextIndex,
                FirstRank = firstRank + first,
                EndRank = firstRank + end,
                Ranks = m_ranks,
            }.Schedule(after), 1, default, ranked => planned = ranked));
            yield return JobStep.Of(Slices.Schedule(m_ranks.Length, RangesPerSlice, (first, end, after) => new PlanWaveJob
            {
                Plan = m_plan,
                FirstRank = firstRank,
                Ranks = m_ranks,
                First = first,
                End = end,
                Ranges = ranges,
                Filled = Buffer.Filled,
            }.Schedule(after), 1, planned, all => Filling = JobHandle.CombineDependencies(Filling, all)));
            JobHandle.ScheduleBatchedJobs();
        }

        IEnumerator<JobStep> BeginReads()
        {
            var ranges = m_ranges.AsArray();
            int max = !Reader.IsRemote
                ? m_pace.RangesPerRequest(ranges.Length, m_reads.Length, MinRangesPerRequest, MaxRangesPerRequest)
                : Reader.TakesFewRanges ? 1 : RangesPerFetch;
            int slotBytes = Math.Max(SlotBytes, m_plan.MaxSegmentPoints * Reader.Info.RecordBytes * (Reader.IsRemote ? max : 1));
            using var window = ((RecordReader)Reader).WindowOf(ranges, max);
            m_waveBegun = m_waveEnded = ReadClock.Now;
            m_segments = 0;
            for (int next = 0; next < ranges.Length;)
            {
                if (m_ring.IsFull)
                {
                    yield return m_reads[m_ring.Oldest].Decoded;
                    EndRead();
                    continue;
                }
                while (window != null && !window.TryPrepareNext())
                    yield return default;
                int slot = m_ring.Begin();
                var read = m_reads[slot] ??= ((RecordReader)Reader).CreateStridedRead(Buffer.Points, MaxRangesPerRequest,
                    slotBytes, Allocator.Persistent);
                read.Fetched = window?.Take();
                next += read.Begin(ranges, next, max, m_gapBytes);
                Filling = JobHandle.CombineDependencies(Filling, read.Decoded);
                JobHandle.ScheduleBatchedJobs();
                // The coroutine checks its budget.
                yield return default;
            }
        }

        void EndRead()
        {
            var oldest = m_reads[m_ring.Oldest];
            oldest.Complete();
            m_ring.End();
            BytesRead += oldest.BytesRead;
            m_segments += oldest.Segments;
            m_waveEnded = Math.Max(m_waveEnded, oldest.Ended);
            Report(m_progress);
        }

        public override void EndReads()
        {
            base.EndReads();
            while (!m_ring.IsEmpty)
                EndRead();
            // Only the first wave is measured, whose ranges lie far apart: with gaps read along, a segment's time
            // includes theirs.
            if (m_isFirstWave)
                m_gapBytes = m_pace.GapBytes(ReadClock.Seconds(m_waveBegun, m_waveEnded) / m_segments);
            m_isFirstWave = false;
        }

        public override void Free()
        {
            Filling.Complete();
            if (m_reads != null)
                foreach (var read in m_reads)
                    read?.Dispose();
            m_reads = null;
            if (m_ranks.IsCreated)
                m_ranks.Dispose();
            if (m_nextIndex.IsCreated)
                m_nextIndex.Dispose();
            if (m_ranges.IsCreated)
                m_ranges.Dispose();
            if (m_nextRanges.IsCreated)
                m_nextRanges.Dispose();
        }
    }

    /// <summary>Ranks the strata with the next ranges, in an order whose every prefix is spread over the file.</summary>
    [BurstCompile]
    struct RankStrataJob : IJob
    {
        public SampleOrder Order;
        public NativeReference<int> NextIndex; // Position in the order where the last call stopped.
        public int FirstRank; // Number of ranges that have a stratum.
        public int EndRank; // The same, plus those that get one now.
        public NativeArray<int> Ranks; // For each stratum, its range's rank + 1; 0 for strata without one.

        public void Execute()
        {
            int index = NextIndex.Value;
            for (int rank = FirstRank; rank < EndRank; index++)
            {
                int stratum = Order.StratumAt(index);
                if (stratum >= 0)
                    Ranks[stratum] = ++rank;
            }
            NextIndex.Value = index;
        }
    }

    [BurstCompile]
    struct PlanWaveJob : IJob
    {
        public RangePlan Plan;
        public int FirstRank; // Number of ranges in earlier waves.

        [ReadOnly] public NativeArray<int> Ranks;

        public int First;
        public int End;

        public NativeList<StridedRange> Ranges;
        public NativeArray<byte> Filled; // By entry of the sample; those of the ranges become 1.

        public void Execute()
        {
            for (int stratum = First; stratum < End; stratum++)
            {
                int rank = Ranks[stratum] - 1;
                if (rank < FirstRank)
                    continue;
                bool isSplit = Plan.RangeOf(stratum, rank, out var range, out var second);
                Add(range);
                if (isSplit)
                    Add(second);
            }
        }

        void Add(in StridedRange range)
        {
            Ranges.Add(range);
            for (int i = 0; i < range.Count; i++)
                Filled[range.FirstInSample + i] = 1;
        }
    }

    /// <summary>Chooses how a sample of short ranges is read, by the time of a source's first reads.</summary>
    /// <remarks>If reads take long, as from a network or a disk that has to seek, fewer and longer ranges make another, coarser
    /// sample of as many points. There are only these two plans, so that the sample is the same wherever the same plan was
    /// chosen.</remarks>
    internal readonly struct ReadStrategy
    {
        public const int TrialReads = 4; // Number of trial reads, of which the fastest counts.

        /// <summary>Duration of a slow read: a seek of a disk takes four times as long, a solid state disk a tenth.</summary>
        const double SlowSeconds = 0.002;
        const long MinSlowBytes = 64L << 20; // A smaller source is quickly read as a whole.

        const int PointsPerShortRange = 16, PointsPerLongRange = 128;

        /// <summary>Requests in flight: enough to keep a worker busy from frame to frame, and so that slow ones take as long
        /// as one.</summary>
        const int DefaultSlots = 40, SlowSlots = 48;

        /// <summary>Bytes that a slow disk reads in a second after seeking: a gap that takes less time than another read is read
        /// along.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10, MaxSlowGapBytes = 1 << 20;

        public readonly bool IsSlow;

        ReadStrategy(bool isSlow) => IsSlow = isSlow;

        /// <param name="quickestSeconds">The quickest of the first reads.</param>
        /// <param name="bytes">Bytes of the source's records.</param>
        public static ReadStrategy Of(double quickestSeconds, long bytes) =>
            new ReadStrategy(quickestSeconds >= SlowSeconds && bytes >= MinSlowBytes);

        public int PointsPerRange => IsSlow ? PointsPerLongRange : PointsPerShortRange;

        public int Slots => IsSlow ? SlowSlots : DefaultSlots;

        /// <summary>Number of ranges in one request, of this many in all: so few that all are in flight at once, and half
        /// as many where they are slow, since slow requests must not wait for each other.</summary>
        public int RangesPerRequest(int ranges, int slots, int min, int max) =>
            Math.Max(IsSlow ? 1 : min, Math.Min(max, IsSlow ? ranges / (2 * slots) : (ranges + slots - 1) / slots));

        /// <summary>The largest gap that is read along.</summary>
        /// <param name="secondsPerRead">The time of reads that lie far apart, with several in flight.</param>
        public int GapBytes(double secondsPerRead) => (int)Math.Max(MinGapBytes,
            Math.Min(IsSlow ? MaxSlowGapBytes : MaxGapBytes, secondsPerRead * BytesPerSecondOfGaps));
    }
}
