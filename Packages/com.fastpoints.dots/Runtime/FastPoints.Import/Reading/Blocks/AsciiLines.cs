using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    struct AsciiRange
    {
        public long Offset;
        public int Bytes;

        // Lines that start behind these bytes belong to the next block.
        public int BlockBytes;
        public bool ReachesFileEnd;
        public bool StartsInRow;
        public int RowsBefore;
        public int Rows;

        // The last line may extend maxLineBytes behind its block.
        public static AsciiRange Of(in SegmentBlock block, BlockRange range, long fileBytes, int maxLineBytes)
        {
            long left = fileBytes - block.OffsetBytes;
            int bytes = (int)Math.Min((long)block.Bytes + maxLineBytes, left);
            return new AsciiRange
            {
                Offset = block.OffsetBytes,
                Bytes = bytes,
                BlockBytes = Math.Min(block.Bytes, bytes),
                ReachesFileEnd = bytes == left,
                StartsInRow = block.StartsInRow,
                RowsBefore = block.RowsBefore + range.First,
                Rows = range.Count,
            };
        }
    }

    static unsafe class AsciiLines
    {
        public static bool IsLineEnd(byte b) => b == '\n' || b == '\r';

        // Within the line.
        public static void SkipBlanks(ref byte* p)
        {
            while (*p <= ' ' && !IsLineEnd(*p))
                p++;
        }

        // One must exist.
        public static byte* LineEnd(byte* p)
        {
            while (!IsLineEnd(*p))
                p++;
            return p;
        }

        // False if the value does not fit into the type: the nearest one that fits is stored.
        public static bool StoreClamped(byte* column, int row, AttributeType type, int bytes, ulong magnitude, bool isNegative)
        {
            int bits = 8 * bytes;
            bool isSigned = type == AttributeType.Int8 || type == AttributeType.Int16 || type == AttributeType.Int32 ||
                            type == AttributeType.Int64;
            ulong limit;
            if (isSigned)
                limit = isNegative ? 1ul << (bits - 1) : (1ul << (bits - 1)) - 1;
            else
                limit = isNegative ? 0 : ulong.MaxValue >> (64 - bits);
            bool fits = magnitude <= limit;
            ulong value = fits ? magnitude : limit;
            if (isNegative)
                value = 0 - value;
            switch (bytes)
            {
                case 1:
                    column[row] = (byte)value;
                    break;
                case 2:
                    ((ushort*)column)[row] = (ushort)value;
                    break;
                case 4:
                    ((uint*)column)[row] = (uint)value;
                    break;
                default:
                    ((ulong*)column)[row] = value;
                    break;
            }
            return fits;
        }
    }

    [BurstCompile]
    unsafe struct CountAsciiRowsJob : IJob
    {
        const ulong Ones = 0x0101010101010101;
        const ulong Highs = 0x8080808080808080;

        [ReadOnly] public NativeArray<byte> Input;
        public int Bytes;
        [WriteOnly] public NativeReference<AsciiRowCount> Result;

        public void Execute()
        {
            byte* p = (byte*)Input.GetUnsafeReadOnlyPtr();
            byte* end = p + Bytes;
            var count = default(AsciiRowCount);
            bool isInText = false;

            while (p < end && !AsciiLines.IsLineEnd(*p))
                isInText |= *p++ > ' ';
            count.HasTextBeforeFirstEnd = isInText;
            count.HasLineEnd = p < end;
            int rows = 0;
            if (count.HasLineEnd)
                isInText = false;
            while (p < end)
            {
                // Within a line only its end matters, so eight bytes are tested at a time. The test for "any byte equal" is
                // exact.
                if (isInText)
                {
                    while (end - p >= 8)
                    {
                        ulong word = *(ulong*)p;
                        ulong lf = word ^ Ones * '\n', cr = word ^ Ones * '\r';
                        if (((((lf - Ones) & ~lf) | ((cr - Ones) & ~cr)) & Highs) != 0)
                            break;
                        p += 8;
                    }
                    while (p < end && !AsciiLines.IsLineEnd(*p))
                        p++;
                    isInText = p == end;
                }
                else if (*p++ > ' ')
                {
                    rows++;
                    isInText = true;
                }
            }
            count.RowsAfterFirstEnd = rows;
            count.EndsInText = isInText;
            Result.Value = count;
        }
    }

    // Counted without knowing whether the segment starts within a line. Blank lines do not count.
    struct AsciiRowCount
    {
        public int RowsAfterFirstEnd; // Lines whose first character lies in the segment, behind its first line end.
        public bool HasTextBeforeFirstEnd; // A line of this segment unless it started earlier.

        public bool HasLineEnd;
        public bool EndsInText; // The next segment starts within a line.
    }

    // Counts the lines of a text file up to the last point's, several segments at a time. A segment's count does not depend on
    // earlier ones; whether it starts within a line does, and is settled here, in order.
    sealed class AsciiRowScan : IDisposable
    {
        readonly SourceHandle m_file;
        readonly long m_fileBytes;
        readonly int m_blockBytes;
        readonly ulong m_rowsBefore;
        readonly ulong m_rowsEnd;
        readonly AsciiSlot[] m_slots;
        readonly List<SegmentBlock> m_blocks = new List<SegmentBlock>();

        // Null for a local file.
        readonly FetchWindow m_window;
        long m_offset;
        SlotRing m_ring;
        ulong m_rows;
        bool m_isInText;

        // rowsBefore: leading lines that are not points; rowsEnd: lines up to the last point's, beyond the file's for all.
        public AsciiRowScan(PointReader reader, SourceHandle file, long offset, int blockBytes, ulong rowsBefore, ulong rowsEnd)
        {
            long fileBytes = reader.Info.FileBytes;
            int maxJobs = reader.MaxIndexingJobs;
            m_file = file;
            m_fileBytes = fileBytes;
            m_blockBytes = blockBytes;
            m_rowsBefore = rowsBefore;
            m_rowsEnd = rowsEnd;
            m_offset = offset;
            long segments = (fileBytes - offset) / blockBytes + 1;
            m_slots = new AsciiSlot[(int)Math.Min(segments, maxJobs > 0 ? maxJobs : 2 * (JobsUtility.JobWorkerCount + 1))];
            long bytes = Math.Min(blockBytes, fileBytes);
            m_ring = new SlotRing(m_slots.Length);
            if (reader.IsRemote)
                m_window = new FetchWindow(0, (int)Math.Min(segments, int.MaxValue), (n, pieces) => pieces.Add(new FilePiece
                {
                    Path = file.Path,
                    OffsetBytes = offset + (long)n * blockBytes,
                    LengthBytes = blockBytes,
                }));
            for (int i = 0; i < m_slots.Length; i++)
                m_slots[i] = new AsciiSlot(bytes);
        }

        public long Points { get; private set; }

        public SegmentBlock[] TakeBlocks() => m_blocks.ToArray();

        // Takes the oldest segment, whose handle must be complete, and refills the slots. False at the end. The handle is the
        // default one while nothing is here yet.
        public bool Next(out JobHandle handle)
        {
            if (!m_ring.IsEmpty)
                Finish(m_slots[m_ring.End()]);
            handle = default;
            if (m_rows >= m_rowsEnd)
                return false;
            while (!m_ring.IsFull && m_offset < m_fileBytes && (m_window == null || m_window.TryPrepareNext()))
                Start(m_slots[m_ring.Begin()]);
            if (m_ring.IsEmpty)
                return m_offset < m_fileBytes;
            handle = m_slots[m_ring.Oldest].Counted;
            return true;
        }

        void Start(AsciiSlot slot)
        {
            int bytes = (int)Math.Min(m_blockBytes, m_fileBytes - m_offset);
            slot.Begin(m_file, m_offset, bytes, m_window?.Take());
            m_offset += bytes;
        }

        void Finish(AsciiSlot slot)
        {
            var count = slot.End();
            ulong rows = (ulong)count.RowsAfterFirstEnd + (count.HasTextBeforeFirstEnd && !m_isInText ? 1ul : 0ul);
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
            m_window?.Dispose();
            foreach (var slot in m_slots)
                slot.Dispose();
        }
    }

    // A segment whose lines are counted.
    sealed class AsciiSlot : IDisposable
    {
        readonly NativeReference<AsciiRowCount> m_rows = new NativeReference<AsciiRowCount>(Allocator.Persistent);

        public AsciiSlot(long maxBytes) => Read = new NativeFileRead(maxBytes, Allocator.Persistent);

        public NativeFileRead Read { get; }
        public JobHandle Counted { get; private set; }

        public JobHandle Begin(SourceHandle file, long offset, int bytes, RemoteFetch fetched)
        {
            Read.Fetched = fetched;
            var read = Read.Begin(file, offset, bytes);
            return Counted = new CountAsciiRowsJob { Input = Read.Buffer, Bytes = bytes, Result = m_rows }.Schedule(read);
        }

        public AsciiRowCount End()
        {
            Counted.Complete();
            Read.End();
            return m_rows.Value;
        }

        public void Dispose()
        {
            Counted.Complete();
            Read.Dispose();
            m_rows.Dispose();
        }
    }
}
