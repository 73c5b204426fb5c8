using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Samples short runs of evenly spaced points from all over a source of fixed stride: see <see cref="RunPlan"/> for
    /// which.</summary>
    /// <remarks>The time of the first reads decides between two plans (<see cref="ReadPace"/>), and the time of the first wave's
    /// reads decides which gaps between runs are read along.</remarks>
    sealed class RunWaveReader : WaveReader
    {
        /// <summary>Runs in one request: one of the most takes a worker about a millisecond, one of the fewest takes the main
        /// thread as long to begin as any other.</summary>
        const int MaxRunsPerRequest = 1536, MinRunsPerRequest = 16;

        /// <summary>Runs in one slice of planning them: about 2 ms of managed code.</summary>
        const int RunsPerSlice = 1 << 14;

        /// <summary>Bytes of a slot's buffer, of which only what is read takes memory.</summary>
        const int SlotBytes = 2 << 20;

        readonly int m_wanted;
        readonly uint m_seed;
        RunPlan m_plan;
        ReadPace m_pace;
        RunRead[] m_reads;
        NativeArray<int> m_ranks;
        NativeReference<int> m_nextPlace;
        NativeList<PointRun> m_runs;

        /// <summary>Those of the wave after this one, up to <see cref="m_plannedEnd"/>: found while this one is read.</summary>
        NativeList<PointRun> m_nextRuns;
        SlotRing m_ring;
        StageProgress m_progress;
        bool m_isFirstWave = true;
        int m_endRank;
        int m_plannedEnd;
        int m_gapBytes;
        long m_segments;
        long m_waveBegun;
        long m_waveEnded;

        public RunWaveReader(PointReader reader, int wanted, uint seed)
            : this(reader, wanted, seed, new RunPlan(reader.PointCount, wanted, reader.Info.RecordBytes, seed)) { }

        RunWaveReader(PointReader reader, int wanted, uint seed, RunPlan plan)
            : base(reader, plan.PlaceCount,
                plan.RunCount + " runs of evenly spaced points, one in each stratum of the file, in waves")
        {
            m_wanted = wanted;
            m_seed = seed;
            m_plan = plan;
        }

        public override IEnumerator<JobStep> Read(int wanted, int next, int slots, StageProgress progress)
        {
            if (m_reads == null)
            {
                yield return JobStep.Of(Try());
                Allocate(slots < 1 ? m_pace.Slots : slots);
            }
            int end = m_plan.RunsFor(wanted);
            if (end == m_endRank)
                yield break;
            if (m_plannedEnd != end)
                yield return JobStep.Of(PlanWave(m_endRank, end));
            yield return Filling;
            Filling.Complete();
            (m_runs, m_nextRuns) = (m_nextRuns, m_runs);
            m_progress = progress;
            yield return JobStep.Of(BeginReads());
            int nextEnd = m_plan.RunsFor(next);
            if (nextEnd > end)
                yield return JobStep.Of(PlanWave(end, nextEnd));
            m_endRank = end;
            EndIndex = m_plan.PlaceOf(end);
        }

        /// <summary>Coroutine: reads the first runs of the usual plan, and changes to the other one if that is
        /// slow.</summary>
        IEnumerator<JobStep> Try()
        {
            m_gapBytes = m_pace.GapBytes(0);
            if (m_plan.RunCount < ReadPace.TrialReads || m_plan.PlaceCount >= Reader.PointCount)
                yield break;
            m_reads = new RunRead[ReadPace.TrialReads];
            m_runs = new NativeList<PointRun>(Allocator.Persistent);
            for (int rank = 0, place = 0; rank < ReadPace.TrialReads; place++)
            {
                int stratum = m_plan.Order.StratumAt(place);
                if (stratum < 0)
                    continue;
                m_plan.RunOf(stratum, rank, out var run, out _);
                m_runs.Add(run);
                m_reads[rank] = ((RecordReader)Reader).CreateRunRead(Buffer.Points, 1,
                    m_plan.MaxSegmentPoints * Reader.Info.RecordBytes, Allocator.Persistent);
                m_reads[rank].Begin(m_runs.AsArray(), rank, 1, 0);
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
            m_pace = ReadPace.Of(quickest, Reader.PointCount * Reader.Info.RecordBytes);
            if (!m_pace.IsSlow)
                yield break;
            m_plan = new RunPlan(Reader.PointCount, m_wanted, Reader.Info.RecordBytes, m_seed, m_pace.PointsPerRun);
            Method = m_plan.RunCount + " long runs of evenly spaced points, as reads take long, one in each stratum of " +
                "the file, in waves";
        }

        void Allocate(int slots)
        {
            m_ranks = new NativeArray<int>(m_plan.RunCount, Allocator.Persistent);
            m_nextPlace = new NativeReference<int>(Allocator.Persistent);
            m_runs = new NativeList<PointRun>(MaxRunsPerRequest, Allocator.Persistent);
            m_nextRuns = new NativeList<PointRun>(MaxRunsPerRequest, Allocator.Persistent);
            m_reads = new RunRead[slots];
            m_ring = new SlotRing(slots);
        }

        /// <summary>Coroutine: schedules what finds the next wave's runs, in the file's order, and what comes of
        /// it.</summary>
        IEnumerator<JobStep> PlanWave(int firstRank, int endRank)
        {
            var runs = m_nextRuns;
            runs.Clear();
            m_plannedEnd = endRank;
            var planned = default(JobHandle);
            yield return JobStep.Of(Slices.Schedule(endRank - firstRank, RunsPerSlice, (first, end, after) => new RankStrataJob
            {
                Order = m_plan.Order,
                NextPlace = m_nextPlace,
                FirstRank = firstRank + first,
                EndRank = firstRank + end,
                Ranks = m_ranks,
            }.Schedule(after), 1, default, ranked => planned = ranked));
            yield return JobStep.Of(Slices.Schedule(m_ranks.Length, RunsPerSlice, (first, end, after) => new PlanWaveJob
            {
                Plan = m_plan,
                FirstRank = firstRank,
                Ranks = m_ranks,
                First = first,
                End = end,
                Runs = runs,
                Filled = Buffer.Filled,
            }.Schedule(after), 1, planned, all => Filling = JobHandle.CombineDependencies(Filling, all)));
            JobHandle.ScheduleBatchedJobs();
        }

        IEnumerator<JobStep> BeginReads()
        {
            var runs = m_runs.AsArray();
            int max = m_pace.RunsPerRequest(runs.Length, m_reads.Length, MinRunsPerRequest, MaxRunsPerRequest);
            int slotBytes = Math.Max(SlotBytes, m_plan.MaxSegmentPoints * Reader.Info.RecordBytes);
            m_waveBegun = m_waveEnded = ReadClock.Now;
            m_segments = 0;
            for (int next = 0; next < runs.Length;)
            {
                if (m_ring.IsFull)
                {
                    yield return m_reads[m_ring.Oldest].Decoded;
                    EndRead();
                    continue;
                }
                int slot = m_ring.Begin();
                var read = m_reads[slot] ??= ((RecordReader)Reader).CreateRunRead(Buffer.Points, MaxRunsPerRequest, slotBytes,
                    Allocator.Persistent);
                next += read.Begin(runs, next, max, m_gapBytes);
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
            // The first wave is measured, whose runs lie far apart: when gaps are read along, a segment takes longer for its
            // bytes.
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
            if (m_nextPlace.IsCreated)
                m_nextPlace.Dispose();
            if (m_runs.IsCreated)
                m_runs.Dispose();
            if (m_nextRuns.IsCreated)
                m_nextRuns.Dispose();
        }
    }

    /// <summary>Ranks the strata with the next runs, in an order of which every beginning is spread over the file.</summary>
    [BurstCompile]
    struct RankStrataJob : IJob
    {
        public SampleOrder Order;

        /// <summary>Position in the order where the last call stopped.</summary>
        public NativeReference<int> NextPlace;

        /// <summary>Number of runs that have a stratum.</summary>
        public int FirstRank;

        /// <summary>The same, plus those that get one now.</summary>
        public int EndRank;

        /// <summary>For each stratum, its run's rank + 1; 0 for those that were not reached.</summary>
        public NativeArray<int> Ranks;

        public void Execute()
        {
            int place = NextPlace.Value;
            for (int rank = FirstRank; rank < EndRank; place++)
            {
                int stratum = Order.StratumAt(place);
                if (stratum >= 0)
                    Ranks[stratum] = ++rank;
            }
            NextPlace.Value = place;
        }
    }

    /// <summary>Plans the runs of one wave, in the file's order, for the strata examined.</summary>
    [BurstCompile]
    struct PlanWaveJob : IJob
    {
        public RunPlan Plan;

        /// <summary>Number of runs in earlier waves.</summary>
        public int FirstRank;

        /// <summary>See <see cref="RankStrataJob.Ranks"/>.</summary>
        [ReadOnly] public NativeArray<int> Ranks;

        /// <summary>Range of the strata to examine.</summary>
        public int First;
        public int End;

        public NativeList<PointRun> Runs;

        /// <summary>One for each place of the sample; those of the runs become 1.</summary>
        public NativeArray<byte> Filled;

        public void Execute()
        {
            for (int stratum = First; stratum < End; stratum++)
            {
                int rank = Ranks[stratum] - 1;
                if (rank < FirstRank)
                    continue;
                bool isSplit = Plan.RunOf(stratum, rank, out var run, out var second);
                Add(run);
                if (isSplit)
                    Add(second);
            }
        }

        void Add(in PointRun run)
        {
            Runs.Add(run);
            for (int i = 0; i < run.Count; i++)
                Filled[run.Place + i] = 1;
        }
    }

    /// <summary>Chooses how a sample of short runs is read, by the time of a source's first reads.</summary>
    /// <remarks>If reads take long, as from a network or a disk that has to seek, fewer and longer runs make another, coarser
    /// sample of as many points. There are only these two plans, so that the sample is the same wherever the same plan was
    /// chosen.</remarks>
    internal readonly struct ReadPace
    {
        /// <summary>Number of trial reads, of which the quickest counts: anything may delay the others.</summary>
        public const int TrialReads = 4;

        /// <summary>Duration of a slow read: a seek of a disk takes four times as long, a solid state disk a tenth.</summary>
        const double SlowSeconds = 0.002;

        /// <summary>A smaller source is quickly read as a whole.</summary>
        const long MinSlowBytes = 64L << 20;

        const int PointsPerShortRun = 16, PointsPerLongRun = 128;

        /// <summary>Requests in flight: enough to keep a worker busy from frame to frame, and so that slow ones take as long
        /// as one.</summary>
        const int DefaultSlots = 40, SlowSlots = 48;

        /// <summary>Bytes that a slow disk reads in a second after seeking: a gap that takes less time than another read is read
        /// along.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10, MaxSlowGapBytes = 1 << 20;

        public readonly bool IsSlow;

        ReadPace(bool isSlow) => IsSlow = isSlow;

        /// <param name="quickestSeconds">The quickest of the first reads.</param>
        /// <param name="bytes">Bytes of the source's records.</param>
        public static ReadPace Of(double quickestSeconds, long bytes) =>
            new ReadPace(quickestSeconds >= SlowSeconds && bytes >= MinSlowBytes);

        public int PointsPerRun => IsSlow ? PointsPerLongRun : PointsPerShortRun;

        public int Slots => IsSlow ? SlowSlots : DefaultSlots;

        /// <summary>Number of runs in one request, if there are so many in all: so few that all are in flight at once, and half
        /// as many where they are slow, since slow requests must not wait for each other.</summary>
        public int RunsPerRequest(int runs, int slots, int min, int max) =>
            Math.Max(IsSlow ? 1 : min, Math.Min(max, IsSlow ? runs / (2 * slots) : (runs + slots - 1) / slots));

        /// <summary>The largest gap that is read along.</summary>
        /// <param name="secondsPerRead">The time of reads that lie far apart, with several in flight.</param>
        public int GapBytes(double secondsPerRead) => (int)Math.Max(MinGapBytes,
            Math.Min(IsSlow ? MaxSlowGapBytes : MaxGapBytes, secondsPerRead * BytesPerSecondOfGaps));
    }
}
