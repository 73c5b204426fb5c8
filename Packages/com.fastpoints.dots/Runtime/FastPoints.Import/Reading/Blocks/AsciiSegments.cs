using System;
using System.Collections.Generic;
using Unity.Jobs;

namespace FastPoints.Reading
{
    /// <summary>Finds lines by jumping into a text file: in each of <see cref="Count"/> equal parts of its bytes, one segment at
    /// a hashed position, from its first line end on. The parts come in an order whose every prefix is spread over the file,
    /// and some can be read before others: the cost depends only on how many are wanted.</summary>
    /// <remarks>Bytes are not points: fewer long lines than short ones start in a segment. Each line nevertheless has the same
    /// chance: one that starts at byte b is found by the segments that begin at most at b - 1 and end behind b, and there are as
    /// many of these for a long line as for a short one, whatever precedes it. This is only fair with all lines of a segment; a
    /// fixed number of each would prefer lines among long ones.</remarks>
    sealed class AsciiSegments
    {
        public const int Count = 2048;
        public const int SegmentBytes = 16 << 10;
        public const long MinBytes = 2L * Count * SegmentBytes; // In a smaller file, counting all lines is about as fast.
        const int Slots = 32; // If each takes long, together they take as long as one.

        const uint OrderSeed = 1;

        readonly SourceHandle m_file;
        readonly long m_offset;
        readonly long m_bytes;
        readonly List<SegmentBlock> m_blocks = new List<SegmentBlock>();
        readonly int[] m_rowsOfPart = new int[Count];
        long m_points;
        int m_found;

        public AsciiSegments(SourceHandle file, long fileBytes, long offset)
        {
            m_file = file;
            m_offset = offset;
            m_bytes = fileBytes - offset;
            for (int part = 0; part < Count; part++)
                m_rowsOfPart[part] = -1;
        }

        public SegmentBlock[] Blocks => m_blocks.ToArray();

        // The standard error comes from the differences of neighbouring segments, since each part has a single segment (Wolter,
        // "Introduction to variance estimation", 2007, 8.2).
        public PointEstimate Estimate
        {
            get
            {
                double squares = 0;
                int last = -1;
                foreach (int rows in m_rowsOfPart)
                {
                    if (rows < 0)
                        continue;
                    if (last >= 0)
                        squares += (rows - last) * (double)(rows - last);
                    last = rows;
                }
                double weight = m_bytes / (double)Math.Max(1, m_found) / (SegmentBytes - 1);
                return new PointEstimate(weight * m_points, weight * Math.Sqrt(squares / 2));
            }
        }

        public IEnumerator<JobStep> Find(int count)
        {
            int first = m_found, wanted = Math.Min(Count, count) - first;
            if (wanted <= 0)
                yield break;
            var order = new SampleOrder(Count, OrderSeed);
            var slots = new AsciiSlot[Math.Min(Slots, wanted)];
            var parts = new int[slots.Length];
            using var window = !m_file.IsRemote ? null : new FetchWindow(0, wanted, (i, pieces) => pieces.Add(new FilePiece
            {
                Path = m_file.Path,
                OffsetBytes = OffsetOf(order.StratumAt(first + i)),
                LengthBytes = SegmentBytes,
            }));
            try
            {
                for (int i = 0; i < slots.Length; i++)
                    slots[i] = new AsciiSlot(SegmentBytes);
                yield return JobStep.Of(SlotRing.Run(slots.Length, wanted, (slot, i) =>
                {
                    parts[slot] = order.StratumAt(first + i);
                    var counted = slots[slot].Begin(m_file, OffsetOf(parts[slot]), SegmentBytes, window?.Take());
                    JobHandle.ScheduleBatchedJobs();
                    return counted;
                }, slot => AddBlock(slots[slot], parts[slot]), window));
            }
            finally
            {
                foreach (var slot in slots)
                    slot?.Dispose();
            }
        }

        // The finaliser of SplitMix64.
        long OffsetOf(int part)
        {
            long first = m_bytes / Count * part, count = m_bytes / Count - SegmentBytes + 1;
            ulong hash = (ulong)(part + 1) * 0x9E3779B97F4A7C15UL;
            hash = (hash ^ hash >> 30) * 0xBF58476D1CE4E5B9UL;
            hash = (hash ^ hash >> 27) * 0x94D049BB133111EBUL;
            return m_offset + first + (long)((hash ^ hash >> 31) % (ulong)count);
        }

        void AddBlock(AsciiSlot slot, int part)
        {
            int rows = slot.End().RowsAfterFirstEnd;
            m_found++;
            m_rowsOfPart[part] = rows;
            if (rows == 0)
                return;
            m_blocks.Add(new SegmentBlock
            {
                OffsetBytes = slot.Read.Offset,
                Bytes = SegmentBytes,
                FirstPoint = m_points,
                Points = rows,
                StartsInRow = true,
            });
            m_points += rows;
        }
    }
}
