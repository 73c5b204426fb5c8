using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using FastPoints.Points;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>
    /// A sample that reads little: short runs of consecutive points, one at a hashed place in each stratum of the file, several
    /// reads in flight. The time it takes depends on the points wanted, not on the file's size.
    /// </summary>
    /// <remarks>
    /// For sources of a fixed stride, of more than 8 million points, where less than an eighth is wanted; others get a
    /// <see cref="UniformSampler"/>, and <see cref="PreviewSample.Method"/> says so. Points of one run are neighbours in the file
    /// and so, mostly, in space: the sample is coarser than a uniform one of as many points.
    /// </remarks>
    public sealed class StridedSampler : IDisposable
    {
        /// <summary>Points of a run: the shortest that fills a few pages of a file, the longest that still scatters.</summary>
        const int MinRunLength = 64, MaxRunLength = 256;

        /// <summary>Runs that are wanted before they grow longer than the shortest.</summary>
        const int UsualRuns = 16384;

        /// <summary>Reads in flight: enough for a solid state disk to work at depth.</summary>
        const int DefaultSlots = 16;

        /// <summary>A larger share of the file than one in so many is sooner read from end to end.</summary>
        const int LeastShare = 8;

        /// <summary>So few points are as soon scanned as picked out, and more evenly.</summary>
        const long FewPoints = 8_000_000;

        readonly PointReader m_reader;
        readonly PointSchema m_schema;
        readonly int m_wanted;
        readonly uint m_seed;
        readonly bool m_always;
        SampleBuffer m_buffer;
        BlockRead[] m_reads;
        JobHandle[] m_copied;
        NativeArray<PointColumn>[] m_columnsOfSlot;
        long m_bytesRead;
        PreviewSample m_sample;

        /// <param name="reader">Its blocks must be known.</param>
        /// <param name="wanted">Points; no more than <see cref="PreviewSample.MaxPoints"/> are taken.</param>
        /// <param name="always">Runs even where a scan would be as quick.</param>
        public StridedSampler(PointReader reader, int wanted, uint seed, bool always = false)
        {
            m_reader = reader;
            m_schema = SampleSchema.Of(reader.Info);
            m_wanted = Math.Max(0, Math.Min(wanted, PreviewSample.MaxPoints(m_schema)));
            m_seed = seed;
            m_always = always;
        }

        /// <summary>Work for a pump; afterwards <see cref="TakeSample"/>.</summary>
        /// <param name="slots">Reads in flight; 0 for a default.</param>
        public IEnumerator<JobHandle> Run(int slots, StageProgress progress)
        {
            string instead = !m_reader.HasFixedStride ? "its records have no fixed stride"
                : m_reader.PointCount < (long)m_wanted * LeastShare ? "most of it is wanted"
                : m_reader.PointCount < FewPoints && !m_always ? "it is small"
                : null;
            if (instead != null || m_wanted == 0)
            {
                using (var uniform = new UniformSampler(m_reader, m_wanted, m_seed))
                {
                    using (var scan = uniform.Run(slots, progress))
                        while (scan.MoveNext())
                            yield return scan.Current;
                    m_sample = uniform.TakeSample();
                }
                if (instead != null)
                    m_sample.Method += " (" + instead + ")";
                yield break;
            }

            slots = slots < 1 ? DefaultSlots : slots;
            try
            {
                using (var runs = CopyRuns(slots, progress))
                    while (runs.MoveNext())
                        yield return runs.Current;
                using (var close = m_buffer.Close(m_reader.Info.Transform))
                    while (close.MoveNext())
                        yield return close.Current;
                m_sample = m_buffer.TakeSample(m_reader.Info.Transform);
                m_sample.PointsInSource = m_reader.PointCount;
                m_sample.BytesRead = m_bytesRead;
                m_sample.Method = RunCount(m_wanted) + " runs of consecutive points, one in each stratum of the file";
            }
            finally
            {
                m_buffer?.Dispose();
            }
        }

        /// <summary>As many runs as it takes for none to be longer than the longest, none shorter than the shortest.</summary>
        static int RunCount(int wanted)
        {
            int length = Math.Min(MaxRunLength, Math.Max(MinRunLength, (wanted + UsualRuns - 1) / UsualRuns));
            return (wanted + length - 1) / length;
        }

        IEnumerator<JobHandle> CopyRuns(int slots, StageProgress progress)
        {
            int runs = RunCount(m_wanted);
            var strata = new SampleStrata(m_reader.PointCount, runs, m_seed);
            var places = new SampleStrata(m_wanted, runs, m_seed);
            m_reads = new BlockRead[slots];
            m_copied = new JobHandle[slots];
            m_columnsOfSlot = new NativeArray<PointColumn>[slots];
            try
            {
                m_buffer = new SampleBuffer(m_schema, m_wanted);
                for (int i = 0; i < slots; i++)
                {
                    m_reads[i] = m_reader.CreateRead(m_schema, Math.Min(MaxRunLength, m_reader.MaxPointsPerBlock),
                        Allocator.Persistent);
                    m_columnsOfSlot[i] = SampleBuffer.ColumnsOf(m_reads[i].Points);
                }
                long piece = 0;
                for (int run = 0; run < runs; run++)
                {
                    int place = (int)places.FirstOf(run);
                    int length = (int)places.FirstOf(run + 1) - place;
                    long point = strata.ChosenRun(run, length);
                    while (length > 0)
                    {
                        int slot = (int)(piece++ % slots);
                        if (piece > slots)
                        {
                            yield return m_copied[slot];
                            Complete(slot);
                        }
                        int block = BlockOf(point);
                        int first = (int)(point - m_reader.FirstPointOfBlock(block));
                        int count = Math.Min(length, m_reader.PointsInBlock(block) - first);
                        Begin(slot, new BlockRange(block, first, count), place);
                        point += count;
                        place += count;
                        length -= count;
                    }
                    progress?.Report((run + 1) / (double)runs, place, m_bytesRead);
                }
                for (long left = Math.Max(0, piece - slots); left < piece; left++)
                {
                    int slot = (int)(left % slots);
                    yield return m_copied[slot];
                    Complete(slot);
                }
                progress?.Report(1, m_wanted, m_bytesRead);
            }
            finally
            {
                for (int i = 0; i < slots; i++)
                {
                    m_copied[i].Complete();
                    m_reads[i]?.Dispose();
                    if (m_columnsOfSlot[i].IsCreated)
                        m_columnsOfSlot[i].Dispose();
                }
            }
        }

        void Begin(int slot, BlockRange range, int place)
        {
            var read = m_reads[slot];
            read.Begin(range);
            m_copied[slot] = new CopyRunJob
            {
                Run = read.Points.Bytes,
                ColumnsOfRun = m_columnsOfSlot[slot],
                Result = read.Result,
                ColumnsOfSample = m_buffer.Columns,
                FirstPlace = place,
                Sample = m_buffer.Points.Bytes,
                Filled = m_buffer.Filled,
            }.Schedule(read.Decoded);
            JobHandle.ScheduleBatchedJobs();
        }

        void Complete(int slot)
        {
            m_copied[slot].Complete();
            m_reads[slot].Complete();
            m_bytesRead += m_reader.BytesOfRange(m_reads[slot].Range);
        }

        /// <summary>The block that a point lies in.</summary>
        int BlockOf(long point)
        {
            int low = 0, high = m_reader.BlockCount - 1;
            while (low < high)
            {
                int middle = (int)(((long)low + high + 1) / 2);
                if (m_reader.FirstPointOfBlock(middle) <= point)
                    low = middle;
                else
                    high = middle - 1;
            }
            return low;
        }

        /// <summary>Hands the sample over, once; null before the work has ended.</summary>
        public PreviewSample TakeSample()
        {
            var sample = m_sample;
            m_sample = null;
            return sample;
        }

        public void Dispose()
        {
            m_sample?.Dispose();
            m_sample = null;
        }
    }
}
