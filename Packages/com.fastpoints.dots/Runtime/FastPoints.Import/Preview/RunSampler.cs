using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Samples short runs of evenly spaced points from all over a source of fixed stride: see <see cref="RunPlan"/> for
    /// which.</summary>
    /// <remarks>The time of the first reads decides between two plans (<see cref="ReadPace"/>), and the time of the first wave's
    /// reads decides which gaps between runs are read along.</remarks>
    sealed class RunSampler : PreviewSampler
    {
        /// <summary>Runs in one request: one of the most takes a worker about a millisecond, one of the fewest takes the main
        /// thread as long to begin as any other.</summary>
        const int MaxRunsPerRequest = 1024, MinRunsPerRequest = 16;

        /// <summary>Runs in one slice of planning and listing them: about 2 ms of managed code.</summary>
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
        int m_endRank;
        int m_gapBytes;

        public RunSampler(PointReader reader, int wanted, uint seed)
            : this(reader, wanted, seed, new RunPlan(reader.PointCount, wanted, reader.Info.RecordBytes, seed)) { }

        RunSampler(PointReader reader, int wanted, uint seed, RunPlan plan)
            : base(reader, plan.PlaceCount,
                plan.RunCount + " runs of evenly spaced points, one in each stratum of the file, in waves")
        {
            m_wanted = wanted;
            m_seed = seed;
            m_plan = plan;
        }

        private protected override IEnumerator<Work> Read(int wanted, int slots, StageProgress progress)
        {
            if (m_reads == null)
            {
                yield return Work.Of(Try());
                Allocate(slots < 1 ? m_pace.Slots : slots);
            }
            int end = m_plan.RunsFor(wanted);
            if (end == m_endRank)
                yield break;
            yield return Work.Of(PlanWave(m_endRank, end));
            yield return Work.Of(ReadRuns(progress));
            m_endRank = end;
            EndPlace = m_plan.PlaceOf(end);
        }

        /// <summary>Work for a pump: reads the first runs of the usual plan, and changes to the other one if that is
        /// slow.</summary>
        IEnumerator<Work> Try()
        {
            m_gapBytes = m_pace.GapBytes(0);
            if (m_plan.RunCount < ReadPace.Tries || m_plan.PlaceCount >= Reader.PointCount)
                yield break;
            m_reads = new RunRead[ReadPace.Tries];
            m_runs = new NativeList<PointRun>(Allocator.Persistent);
            for (int rank = 0, place = 0; rank < ReadPace.Tries; place++)
            {
                int stratum = m_plan.Order.StratumAt(place);
                if (stratum < 0)
                    continue;
                m_plan.RunOf(stratum, rank, out var run, out _);
                m_runs.Add(run);
                m_reads[rank] = Reader.CreateRunRead(Buffer.Points, 1, m_plan.MaxStretchPoints * Reader.Info.RecordBytes,
                    Allocator.Persistent);
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
            Sample.Method = m_plan.RunCount + " long runs of evenly spaced points, as reads take long, one in each stratum of " +
                "the file, in waves";
        }

        void Allocate(int slots)
        {
            m_ranks = new NativeArray<int>(m_plan.RunCount, Allocator.Persistent);
            m_nextPlace = new NativeReference<int>(Allocator.Persistent);
            m_runs = new NativeList<PointRun>(MaxRunsPerRequest, Allocator.Persistent);
            m_reads = new RunRead[slots];
            int slotBytes = Math.Max(SlotBytes, m_plan.MaxStretchPoints * Reader.Info.RecordBytes);
            for (int i = 0; i < slots; i++)
                m_reads[i] = Reader.CreateRunRead(Buffer.Points, MaxRunsPerRequest, slotBytes, Allocator.Persistent);
        }

        /// <summary>Work for a pump: finds the wave's runs, in the file's order.</summary>
        IEnumerator<Work> PlanWave(int firstRank, int endRank)
        {
            m_runs.Clear();
            yield return Work.Of(Slices.Run(firstRank, endRank, RunsPerSlice, (first, end, after) => new RankStrataJob
            {
                Order = m_plan.Order,
                NextPlace = m_nextPlace,
                FirstRank = first,
                EndRank = end,
                Ranks = m_ranks,
            }.Schedule(after)));
            yield return Work.Of(Slices.Run(0, m_ranks.Length, RunsPerSlice, (first, end, after) => new PlanWaveJob
            {
                Plan = m_plan,
                FirstRank = firstRank,
                Ranks = m_ranks,
                First = first,
                End = end,
                Runs = m_runs,
                Filled = Buffer.Filled,
            }.Schedule(after)));
        }

        /// <summary>Reads the planned runs into their places.</summary>
        IEnumerator<Work> ReadRuns(StageProgress progress)
        {
            var runs = m_runs.AsArray();
            var ring = new SlotRing(m_reads.Length);
            int most = m_pace.RunsPerRequest(runs.Length, m_reads.Length, MinRunsPerRequest, MaxRunsPerRequest);
            bool isFirstWave = m_endRank == 0;
            long stretches = 0, begun = ReadClock.Now, ended = begun;
            int next = 0;
            while (next < runs.Length || !ring.IsEmpty)
            {
                if (ring.IsFull || next == runs.Length)
                {
                    var oldest = m_reads[ring.Oldest];
                    yield return oldest.Decoded;
                    oldest.Complete();
                    ring.End();
                    BytesRead += oldest.BytesRead;
                    stretches += oldest.Stretches;
                    ended = Math.Max(ended, oldest.Ended);
                    Report(progress);
                    continue;
                }
                next += m_reads[ring.Begin()].Begin(runs, next, most, m_gapBytes);
                JobHandle.ScheduleBatchedJobs();
            }
            // This measures the first wave, whose runs lie far apart: when gaps are read along, a stretch takes longer for its
            // bytes.
            if (isFirstWave)
                m_gapBytes = m_pace.GapBytes(ReadClock.Seconds(begun, ended) / stretches);
        }

        private protected override IEnumerator<Work> ListRuns(NativeList<SampleRun> runs)
        {
            runs.Capacity = Math.Max(runs.Capacity, m_endRank);
            return Slices.Run(0, m_ranks.Length, RunsPerSlice, (first, end, after) => new ListRunsJob
            {
                Plan = m_plan,
                Ranks = m_ranks,
                First = first,
                End = end,
                RunCount = m_endRank,
                PointsInSource = Reader.PointCount,
                Runs = runs,
            }.Schedule(after));
        }

        private protected override void Free()
        {
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
}
