using System;
using System.Collections.Generic;
using System.Diagnostics;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>
    /// A sample of a source of fixed stride that reads little and arrives in waves, coarse to fine, each the beginning of the next
    /// one and spread over all of the file. The time it takes depends on the points wanted, not on the file's size.
    /// </summary>
    /// <remarks>
    /// The sample is the same for any number of threads and slots and on any disk: what is measured on the way (how long a read takes)
    /// only decides which gaps between runs are read along. See <see cref="RunPlan"/> for which points are taken.
    /// </remarks>
    public sealed class WaveSampler : IDisposable
    {
        /// <summary>Requests in flight: enough for a solid state disk to work at depth.</summary>
        const int DefaultSlots = 8;

        /// <summary>Runs of one request at most: about a millisecond.</summary>
        const int MaxRunsPerRequest = 256;

        const int MinRunsPerRequest = 4;

        /// <summary>Bytes of a slot's buffer.</summary>
        const int SlotBytes = 2 << 20;

        /// <summary>What a slow disk reads in a second once it is there: a gap that takes less time than another read is read.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10;

        /// <summary>Points at which a wave ends; the last one ends with the sample.</summary>
        static readonly int[] s_waves = { 2_000, 20_000, 200_000, 1_000_000, 4_000_000 };

        readonly PointReader m_reader;
        readonly RunPlan m_plan;
        readonly List<SampleWave> m_waves = new List<SampleWave>();
        readonly Stopwatch m_watch = new Stopwatch();
        SampleBuffer m_buffer;
        RunRead[] m_reads;
        NativeArray<int> m_ranks;
        NativeReference<int> m_nextPlace;
        NativeList<PointRun> m_runs;
        PreviewSample m_sample;
        long m_bytesRead;
        long m_stretches;
        double m_readSeconds;

        /// <param name="reader">One that <see cref="CanSample"/>; its blocks are known.</param>
        /// <param name="wanted">Points; no more than <see cref="PreviewSample.MaxPoints"/> are taken.</param>
        public WaveSampler(PointReader reader, int wanted, uint seed)
        {
            m_reader = reader;
            var schema = SampleSchema.Of(reader.Info);
            m_plan = new RunPlan(reader.PointCount, Math.Min(wanted, PreviewSample.MaxPoints(schema)), reader.Info.RecordBytes,
                seed);
            m_buffer = new SampleBuffer(schema, m_plan.PlaceCount);
            m_sample = m_buffer.ShareSample(reader.Info.Transform);
            m_sample.PointsInSource = reader.PointCount;
            m_sample.Method = m_plan.RunCount + " runs of evenly spaced points, one in each stratum of the file, in waves";
        }

        /// <summary>Raised on the pump's thread after each wave: <see cref="Sample"/> can be drawn until the handler
        /// returns, or later as far as the wave goes.</summary>
        public event Action<SampleWave> WaveReady;

        /// <summary>The waves that are there.</summary>
        public IReadOnlyList<SampleWave> Waves => m_waves;

        /// <summary>The sample so far.</summary>
        public PreviewSample Sample => m_sample;

        /// <summary>Whether the source can be sampled so: its records have one length, and are found without a scan.</summary>
        public static bool CanSample(PointReader reader) => reader.HasFixedStride && reader.BlocksAreKnown && reader.HasRunReads;

        /// <summary>Work for a pump.</summary>
        /// <param name="slots">Requests in flight; 0 for a default.</param>
        public IEnumerator<JobHandle> Run(int slots, StageProgress progress)
        {
            m_watch.Restart();
            if (m_plan.PlaceCount == 0)
                yield break;
            slots = slots < 1 ? DefaultSlots : slots;
            m_ranks = new NativeArray<int>(m_plan.RunCount, Allocator.Persistent);
            m_nextPlace = new NativeReference<int>(Allocator.Persistent);
            m_runs = new NativeList<PointRun>(MaxRunsPerRequest, Allocator.Persistent);
            m_reads = new RunRead[slots];
            int slotBytes = Math.Max(SlotBytes, m_plan.MaxStretchPoints * m_reader.Info.RecordBytes);
            try
            {
                for (int i = 0; i < slots; i++)
                    m_reads[i] = m_reader.CreateRunRead(m_buffer.Points, MaxRunsPerRequest, slotBytes, Allocator.Persistent);

                int rank = 0;
                for (int wave = 0; rank < m_plan.RunCount; wave++)
                {
                    int end = m_plan.RunsFor(wave < s_waves.Length ? s_waves[wave] : m_plan.PlaceCount);
                    if (end == rank)
                        continue;
                    var planned = PlanWave(rank, end);
                    try
                    {
                        yield return planned;
                    }
                    finally
                    {
                        planned.Complete();
                    }
                    using (var reading = ReadWave(progress))
                        while (reading.MoveNext())
                            yield return reading.Current;
                    using (var closing = CloseWave(m_plan.PlaceOf(rank), m_plan.PlaceOf(end)))
                        while (closing.MoveNext())
                            yield return closing.Current;
                    rank = end;
                    progress?.Report(rank / (double)m_plan.RunCount, m_sample.Count, m_bytesRead);
                }
            }
            finally
            {
                Free();
            }
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
                Filled = m_buffer.Filled,
            }.Schedule();
            JobHandle.ScheduleBatchedJobs();
            return planned;
        }

        /// <summary>Brings the planned runs into their places.</summary>
        IEnumerator<JobHandle> ReadWave(StageProgress progress)
        {
            var runs = m_runs.AsArray();
            int slots = m_reads.Length;
            int most = Math.Max(MinRunsPerRequest, Math.Min(MaxRunsPerRequest, runs.Length / (2 * slots)));
            double begun = m_watch.Elapsed.TotalSeconds;
            int next = 0;
            long request = 0, completed = 0;
            while (next < runs.Length || completed < request)
            {
                int slot = (int)(request % slots);
                if (request - completed == slots || next == runs.Length)
                {
                    slot = (int)(completed % slots);
                    yield return m_reads[slot].Decoded;
                    m_reads[slot].Complete();
                    m_bytesRead += m_reads[slot].BytesRead;
                    m_stretches += m_reads[slot].Stretches;
                    completed++;
                    progress?.Report(m_sample.Count / (double)m_plan.PlaceCount, m_sample.Count, m_bytesRead);
                    continue;
                }
                double perStretch = m_stretches == 0 ? 0
                    : (m_readSeconds + m_watch.Elapsed.TotalSeconds - begun) / m_stretches;
                int gap = (int)Math.Max(MinGapBytes, Math.Min(MaxGapBytes, perStretch * BytesPerSecondOfGaps));
                next += m_reads[slot].Begin(runs, next, most, gap);
                request++;
                JobHandle.ScheduleBatchedJobs();
            }
            m_readSeconds += m_watch.Elapsed.TotalSeconds - begun;
        }

        /// <summary>Leaves out what has no finite position, and hands the wave over.</summary>
        IEnumerator<JobHandle> CloseWave(int firstPlace, int endPlace)
        {
            using (var closing = m_buffer.Close(m_reader.Info.Transform, firstPlace, endPlace))
                while (closing.MoveNext())
                    yield return closing.Current;
            m_buffer.Measure(m_sample);
            m_sample.BytesRead = m_bytesRead;
            var wave = new SampleWave { Points = m_sample.Count, Seconds = m_watch.Elapsed.TotalSeconds, BytesRead = m_bytesRead };
            m_waves.Add(wave);
            WaveReady?.Invoke(wave);
        }

        /// <summary>Hands the sample over, once.</summary>
        public PreviewSample TakeSample()
        {
            var sample = m_sample;
            m_sample = null;
            return sample;
        }

        public void Dispose()
        {
            Free();
            m_buffer?.Dispose();
            m_buffer = null;
            m_sample?.Dispose();
            m_sample = null;
        }

        void Free()
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
