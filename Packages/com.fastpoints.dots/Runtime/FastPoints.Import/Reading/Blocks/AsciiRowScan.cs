using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    // Counts the lines of a text file up to the last point's, several segments at a time. A segment's count does not depend on
    // earlier ones; whether it starts within a line does, and is settled here, in order.
    sealed class AsciiRowScan : IDisposable
    {
        sealed class Slot
        {
            public NativeFileRead Read;
            public NativeReference<AsciiRowCount> Count;
            public JobHandle Counted;
        }

        readonly SourceHandle m_file;
        readonly long m_fileBytes;
        readonly int m_blockBytes;
        readonly ulong m_rowsBefore;
        readonly ulong m_rowsEnd;
        readonly Slot[] m_slots;
        readonly List<SegmentBlock> m_blocks = new List<SegmentBlock>();
        long m_offset;
        SlotRing m_ring;
        ulong m_rows;
        bool m_isInText;

        // rowsBefore: leading lines that are not points; rowsEnd: lines up to the last point's, beyond the file's for all.
        public AsciiRowScan(PointReader reader, SourceHandle file, long offset, int blockBytes, ulong rowsBefore, ulong rowsEnd)
        {
            long fileBytes = reader.Info.FileBytes;
            int maxJobs = reader.MaxJobs;
            m_file = file;
            m_fileBytes = fileBytes;
            m_blockBytes = blockBytes;
            m_rowsBefore = rowsBefore;
            m_rowsEnd = rowsEnd;
            m_offset = offset;
            long segments = (fileBytes - offset) / blockBytes + 1;
            m_slots = new Slot[(int)Math.Min(segments, maxJobs > 0 ? maxJobs : 2 * (JobsUtility.JobWorkerCount + 1))];
            long bytes = Math.Min(blockBytes, fileBytes);
            m_ring = new SlotRing(m_slots.Length);
            for (int i = 0; i < m_slots.Length; i++)
                m_slots[i] = new Slot
                {
                    Read = new NativeFileRead(bytes, Allocator.Persistent),
                    Count = new NativeReference<AsciiRowCount>(Allocator.Persistent),
                };
        }

        public long Points { get; private set; }

        public SegmentBlock[] TakeBlocks() => m_blocks.ToArray();

        // Takes in the oldest segment, whose handle must be complete, and keeps all slots at work. False at the end.
        public bool Next(out JobHandle handle)
        {
            if (!m_ring.IsEmpty)
                Finish(m_slots[m_ring.End()]);
            handle = default;
            if (m_rows >= m_rowsEnd)
                return false;
            while (!m_ring.IsFull && m_offset < m_fileBytes)
                Start(m_slots[m_ring.Begin()]);
            if (m_ring.IsEmpty)
                return false;
            handle = m_slots[m_ring.Oldest].Counted;
            return true;
        }

        void Start(Slot slot)
        {
            int bytes = (int)Math.Min(m_blockBytes, m_fileBytes - m_offset);
            var read = slot.Read.Begin(m_file, m_offset, bytes);
            slot.Counted = new CountAsciiRowsJob { Input = slot.Read.Buffer, Bytes = bytes, Result = slot.Count }.Schedule(read);
            m_offset += bytes;
        }

        void Finish(Slot slot)
        {
            slot.Counted.Complete();
            slot.Read.End();
            var count = slot.Count.Value;
            ulong rows = (ulong)count.RowsBehindFirstEnd + (count.HasTextBeforeFirstEnd && !m_isInText ? 1ul : 0ul);
            ulong before = m_rowsBefore > m_rows ? Math.Min(m_rowsBefore - m_rows, rows) : 0;
            ulong left = m_rowsEnd > m_rows + before ? m_rowsEnd - m_rows - before : 0;
            int points = (int)Math.Min(rows - before, left);
            if (points > 0)
            {
                m_blocks.Add(new SegmentBlock
                {
                    OffsetBytes = slot.Read.Offset,
                    Bytes = slot.Read.Bytes,
                    FirstPoint = Points,
                    Points = points,
                    RowsBefore = (int)before,
                    StartsInRow = m_isInText,
                });
                Points += points;
            }
            m_rows += rows;
            m_isInText = count.HasLineEnd ? count.EndsInText : m_isInText || count.HasTextBeforeFirstEnd;
        }

        public void Dispose()
        {
            foreach (var slot in m_slots)
            {
                slot.Counted.Complete();
                slot.Read.Dispose();
                slot.Count.Dispose();
            }
        }
    }
}
