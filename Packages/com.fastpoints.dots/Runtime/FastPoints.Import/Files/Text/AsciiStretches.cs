using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.IO.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>
    /// Lines that are found by jumping into a text file: of each of <see cref="Count"/> equal parts of its bytes one stretch at a
    /// hashed place, from its first line end on. What it takes does not depend on the file's size.
    /// </summary>
    /// <remarks>
    /// Bytes are no points: where lines are long, fewer of them start in a stretch. Each line has the same chance nevertheless:
    /// one that starts at byte b is found by the stretches that begin at most b - 1 and end behind b, which are as many for a
    /// long line as for a short one, and whatever stands before it. Only all lines of a stretch are fair; a fixed number of
    /// each would prefer lines among long ones.
    /// </remarks>
    sealed class AsciiStretches : IDisposable
    {
        public const int Count = 2048;
        public const int StretchBytes = 16 << 10;

        /// <summary>Of a smaller file all lines are counted about as soon.</summary>
        public const long LeastBytes = 2L * Count * StretchBytes;

        const int Slots = 16;

        readonly long m_offset;
        readonly long m_bytes;
        readonly NativeFileRead[] m_reads = new NativeFileRead[Slots];
        readonly NativeReference<AsciiRowCount>[] m_rows = new NativeReference<AsciiRowCount>[Slots];
        readonly JobHandle[] m_counted = new JobHandle[Slots];
        readonly List<PlyBlock> m_blocks = new List<PlyBlock>();
        long m_points;
        long m_lastRows = -1;
        double m_squaresOfDifferences;

        /// <param name="offset">Where the lines start; they go on to the file's end.</param>
        public AsciiStretches(string path, FileHandle file, long fileBytes, long offset)
        {
            m_offset = offset;
            m_bytes = fileBytes - offset;
            for (int i = 0; i < Slots; i++)
            {
                m_reads[i] = new NativeFileRead(path, file, StretchBytes, Allocator.Persistent);
                m_rows[i] = new NativeReference<AsciiRowCount>(Allocator.Persistent);
            }
        }

        /// <summary>Stretches with lines, and all that start in each.</summary>
        public PlyBlock[] TakeBlocks() => m_blocks.ToArray();

        /// <summary>Lines of the whole file. The standard error is by the differences of neighbouring stretches, as each part
        /// has one stretch alone (Wolter, "Introduction to variance estimation", 2007, 8.2).</summary>
        public PointEstimate Estimate
        {
            get
            {
                double parts = m_bytes / (double)Count / (StretchBytes - 1);
                return new PointEstimate(parts * m_points, parts * Math.Sqrt(m_squaresOfDifferences / 2));
            }
        }

        /// <summary>Work for a pump, once.</summary>
        public IEnumerator<JobHandle> Run()
        {
            for (int i = 0; i < Count + Slots; i++)
            {
                int slot = i % Slots;
                if (i >= Slots)
                {
                    yield return m_counted[slot];
                    Take(slot);
                }
                if (i >= Count)
                    continue;
                var read = m_reads[slot].Begin(PlaceOf(i), StretchBytes);
                m_counted[slot] = new CountAsciiRowsJob
                {
                    Input = m_reads[slot].Buffer,
                    Bytes = StretchBytes,
                    Result = m_rows[slot],
                }.Schedule(read);
                JobHandle.ScheduleBatchedJobs();
            }
        }

        /// <summary>By the finaliser of SplitMix64.</summary>
        long PlaceOf(int part)
        {
            long first = m_bytes / Count * part, places = m_bytes / Count - StretchBytes + 1;
            ulong hash = (ulong)(part + 1) * 0x9E3779B97F4A7C15UL;
            hash = (hash ^ hash >> 30) * 0xBF58476D1CE4E5B9UL;
            hash = (hash ^ hash >> 27) * 0x94D049BB133111EBUL;
            return m_offset + first + (long)((hash ^ hash >> 31) % (ulong)places);
        }

        void Take(int slot)
        {
            m_counted[slot].Complete();
            m_reads[slot].End();
            int rows = m_rows[slot].Value.RowsBehindFirstEnd;
            if (m_lastRows >= 0)
                m_squaresOfDifferences += (rows - m_lastRows) * (double)(rows - m_lastRows);
            m_lastRows = rows;
            if (rows == 0)
                return;
            m_blocks.Add(new PlyBlock
            {
                OffsetBytes = m_reads[slot].Offset,
                Bytes = StretchBytes,
                FirstPoint = m_points,
                Points = rows,
                StartsInRow = true,
            });
            m_points += rows;
        }

        public void Dispose()
        {
            for (int i = 0; i < Slots; i++)
            {
                m_counted[i].Complete();
                m_reads[i].Dispose();
                m_rows[i].Dispose();
            }
        }
    }
}
