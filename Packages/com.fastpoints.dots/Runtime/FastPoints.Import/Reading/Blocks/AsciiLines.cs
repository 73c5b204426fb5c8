using System;
using FastPoints.Core;

namespace FastPoints.Reading
{
    struct AsciiRange
    {
        // In the file.
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

        // There must be one.
        public static byte* LineEnd(byte* p)
        {
            while (!IsLineEnd(*p))
                p++;
            return p;
        }

        // False if the value does not fit into the type: the nearest one that fits is stored.
        public static bool StoreInteger(byte* column, int row, AttributeType type, int bytes, ulong magnitude, bool isNegative)
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
}
