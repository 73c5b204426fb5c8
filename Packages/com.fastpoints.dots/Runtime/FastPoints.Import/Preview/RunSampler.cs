using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Short runs of evenly spaced points from all over a source of fixed stride: see <see cref="RunPlan"/> for
    /// which.</summary>
    /// <remarks>How long the first wave's reads take only decides which gaps between runs are read along.</remarks>
    sealed class RunSampler : PreviewSampler
    {
        /// <summary>Requests in flight: enough for a solid state disk to work at depth.</summary>
        const int DefaultSlots = 8;

        /// <summary>Runs of one request at most: about a millisecond.</summary>
        const int MaxRunsPerRequest = 256;

        const int MinRunsPerRequest = 4;

        /// <summary>Bytes of a slot's buffer.</summary>
        const int SlotBytes = 2 << 20;

        /// <summary>What a slow disk reads in a second once it is there: a gap that takes less time than another read is
        /// read.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10;

        readonly RunPlan m_plan;
        RunRead[] m_reads;
        NativeArray<int> m_ranks;
        NativeReference<int> m_nextPlace;
        NativeList<PointRun> m_runs;
        int m_endRank;
        int m_gapBytes = MinGapBytes;

        public RunSampler(PointReader reader, int wanted, uint seed)
            : this(reader, new RunPlan(reader.PointCount, wanted, reader.Info.RecordBytes, seed))
        {
        }

        RunSampler(PointReader reader, RunPlan plan)
            : base(reader, plan.PlaceCount, plan.RunCount + " runs of evenly spaced points, one in each stratum of the file, in waves")
        {
            m_plan = plan;
        }

        private protected override IEnumerator<JobHandle> Read(int wanted, int slots, StageProgress progress)
        {
            if (m_reads == null)
                Allocate(slots < 1 ? DefaultSlots : slots);
            int end = m_plan.RunsFor(wanted);
            if (end == m_endRank)
                yield break;
            var planned = PlanWave(m_endRank, end);
            try
            {
                yield return planned;
            }
            finally
            {
                planned.Complete();
            }
            using (var reading = ReadRuns(progress))
                while (reading.MoveNext())
                    yield return reading.Current;
            m_endRank = end;
            EndPlace = m_plan.PlaceOf(end);
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

        JobHandle PlanWave(int firstRank, int endRank)
        {
            var planned = new PlanWaveJob
            {
                Plan = m_plan,
                NextPlace = m_nextPlace,
                FirstRank = firstRank,
                EndRank = endRank,
                Ranks = m_ranks,
                Runs = m_runs,
                Filled = Buffer.Filled,
            }.Schedule();
            JobHandle.ScheduleBatchedJobs();
            return planned;
        }

        /// <summary>Brings the planned runs into their places.</summary>
        IEnumerator<JobHandle> ReadRuns(StageProgress progress)
        {
            var runs = m_runs.AsArray();
            int slots = m_reads.Length;
            int most = Math.Max(MinRunsPerRequest, Math.Min(MaxRunsPerRequest, runs.Length / (2 * slots)));
            bool isFirstWave = m_endRank == 0;
            long stretches = 0;
            double begun = Seconds;
            int next = 0;
            long request = 0, completed = 0;
            while (next < runs.Length || completed < request)
            {
                if (request - completed == slots || next == runs.Length)
                {
                    var oldest = m_reads[completed++ % slots];
                    yield return oldest.Decoded;
                    oldest.Complete();
                    BytesRead += oldest.BytesRead;
                    stretches += oldest.Stretches;
                    Report(progress);
                    continue;
                }
                next += m_reads[request++ % slots].Begin(runs, next, most, m_gapBytes);
                JobHandle.ScheduleBatchedJobs();
            }
            // From the first wave, whose runs lie far apart: with gaps read along a stretch takes longer for its bytes.
            if (isFirstWave)
                m_gapBytes = (int)Math.Max(MinGapBytes,
                    Math.Min(MaxGapBytes, (Seconds - begun) / stretches * BytesPerSecondOfGaps));
        }

        private protected override JobHandle ListRuns(NativeList<SampleRun> runs) => new ListRunsJob
        {
            Plan = m_plan,
            Ranks = m_ranks,
            RunCount = m_endRank,
            PointsInSource = Reader.PointCount,
            Runs = runs,
        }.Schedule();

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
}
