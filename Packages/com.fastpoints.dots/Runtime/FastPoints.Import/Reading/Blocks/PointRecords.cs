using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Reading
{
    // One tight strided loop for each copy of a plan; called by jobs and directly. Values in a record are not aligned,
    // so they are loaded through pointers, which the machines Unity runs on allow. Several copies go over the same
    // records in tiles, so that a record is read from memory once, then from the L1 cache.
    internal static unsafe class PointRecords
    {
        const int TileBytes = 16 << 10;

        /// <summary>Moves values of a column to consecutive rows at or before the first of them.</summary>
        /// <param name="from">Their current rows, ascending.</param>
        public static void Gather(byte* columns, PointColumn column, int* from, int count, int to)
        {
            byte* values = columns + column.OffsetBytes;
            switch (column.Type.SizeOf())
            {
                case 1:
                    for (int i = 0; i < count; i++)
                        values[to + i] = values[from[i]];
                    break;
                case 2:
                    for (int i = 0; i < count; i++)
                        ((ushort*)values)[to + i] = ((ushort*)values)[from[i]];
                    break;
                case 4:
                    for (int i = 0; i < count; i++)
                        ((uint*)values)[to + i] = ((uint*)values)[from[i]];
                    break;
                default:
                    for (int i = 0; i < count; i++)
                        ((ulong*)values)[to + i] = ((ulong*)values)[from[i]];
                    break;
            }
        }

        public static void ToColumns(byte* records, int recordBytes, int count, FieldCopies copies, byte* columns,
            int firstPoint = 0)
        {
            int tilePoints = TilePoints(recordBytes);
            for (int first = 0; first < count; first += tilePoints)
            {
                int points = count - first < tilePoints ? count - first : tilePoints;
                byte* tile = records + (long)first * recordBytes;
                for (int i = 0; i < copies.Count; i++)
                    ToColumn(tile, recordBytes, points, copies.First + i, columns, firstPoint + first);
            }
        }

        // The other bytes (and bits) of the records stay as they are.
        public static void FromColumns(byte* columns, int firstPoint, int count, FieldCopies copies, byte* records,
            int recordBytes)
        {
            int tilePoints = TilePoints(recordBytes);
            for (int first = 0; first < count; first += tilePoints)
            {
                int points = count - first < tilePoints ? count - first : tilePoints;
                byte* tile = records + (long)first * recordBytes;
                for (int i = 0; i < copies.Count; i++)
                    FromColumn(columns, firstPoint + first, points, copies.First + i, tile, recordBytes);
            }
        }

        public static uint ReverseBytes(uint v) => v >> 24 | (v >> 8 & 0xFF00) | (v << 8 & 0xFF0000) | v << 24;

        public static ulong ReverseBytes(ulong v) => (ulong)ReverseBytes((uint)v) << 32 | ReverseBytes((uint)(v >> 32));

        static int TilePoints(int recordBytes) => recordBytes < TileBytes / 64 ? TileBytes / recordBytes : 64;

        static void ToColumn(byte* records, int stride, int count, FieldCopy* copy, byte* columns, int first)
        {
            byte* from = records + copy->RecordByte;
            byte* to = columns + copy->Column0;
            switch (copy->Kind)
            {
                case FieldCopyKind.Bits:
                    ToBits(from, stride, count, to + first, copy->BitShift, copy->BitMask);
                    break;
                case FieldCopyKind.Bytes1:
                    ToOne(from, stride, count, to + first);
                    break;
                case FieldCopyKind.Bytes2:
                    ToTwo(from, stride, count, (ushort*)to + first);
                    break;
                case FieldCopyKind.Bytes4:
                    ToFour(from, stride, count, (uint*)to + first);
                    break;
                case FieldCopyKind.Bytes8:
                    ToEight(from, stride, count, (ulong*)to + first);
                    break;
                case FieldCopyKind.Bytes2Reversed:
                    for (int i = 0; i < count; i++, from += stride)
                        ((ushort*)to)[first + i] = (ushort)(from[0] << 8 | from[1]);
                    break;
                case FieldCopyKind.Bytes4Reversed:
                    for (int i = 0; i < count; i++, from += stride)
                        ((uint*)to)[first + i] = ReverseBytes(*(uint*)from);
                    break;
                case FieldCopyKind.Bytes8Reversed:
                    for (int i = 0; i < count; i++, from += stride)
                        ((ulong*)to)[first + i] = ReverseBytes(*(ulong*)from);
                    break;
                case FieldCopyKind.TripleOfBytes1:
                    ToThreeOfOne(from, stride, count, to + first, columns + copy->Column1 + first,
                        columns + copy->Column2 + first);
                    break;
                case FieldCopyKind.TripleOfBytes8:
                    ToThreeOfEight(from, stride, count, (ulong*)to + first, (ulong*)(columns + copy->Column1) + first,
                        (ulong*)(columns + copy->Column2) + first);
                    break;
                case FieldCopyKind.TripleOfBytes2:
                    ToThreeOfTwo(from, stride, count, (ushort*)to + first, (ushort*)(columns + copy->Column1) + first,
                        (ushort*)(columns + copy->Column2) + first);
                    break;
                case FieldCopyKind.TripleOfBytes4:
                    ToThreeOfFour(from, stride, count, (uint*)to + first, (uint*)(columns + copy->Column1) + first,
                        (uint*)(columns + copy->Column2) + first);
                    break;
                case FieldCopyKind.PositionAndColor:
                    ToPositionAndColor(records, stride, count, copy, columns, first);
                    break;
            }
        }

        static void ToBits(byte* from, int stride, int count, byte* to, int shift, int mask)
        {
            for (int i = 0; i < count; i++, from += stride)
                to[i] = (byte)(*from >> shift & mask);
        }

        static void ToOne(byte* from, int stride, int count, byte* to)
        {
            for (int i = 0; i < count; i++, from += stride)
                to[i] = *from;
        }

        static void ToTwo(byte* from, int stride, int count, ushort* to)
        {
            for (int i = 0; i < count; i++, from += stride)
                to[i] = *(ushort*)from;
        }

        static void ToFour(byte* from, int stride, int count, uint* to)
        {
            for (int i = 0; i < count; i++, from += stride)
                to[i] = *(uint*)from;
        }

        static void ToEight(byte* from, int stride, int count, ulong* to)
        {
            for (int i = 0; i < count; i++, from += stride)
                to[i] = *(ulong*)from;
        }

        static void ToThreeOfOne(byte* from, int stride, int count, byte* a, byte* b, byte* c)
        {
            int i = 0;
            for (; i < count - 3; i += 4, from += 4 * stride)
            {
                byte* second = from + stride, third = second + stride, fourth = third + stride;
                *(uint*)(a + i) = (uint)(from[0] | second[0] << 8 | third[0] << 16 | fourth[0] << 24);
                *(uint*)(b + i) = (uint)(from[1] | second[1] << 8 | third[1] << 16 | fourth[1] << 24);
                *(uint*)(c + i) = (uint)(from[2] | second[2] << 8 | third[2] << 16 | fourth[2] << 24);
            }
            for (; i < count; i++, from += stride)
            {
                a[i] = from[0];
                b[i] = from[1];
                c[i] = from[2];
            }
        }

        static void ToThreeOfEight(byte* from, int stride, int count, ulong* a, ulong* b, ulong* c)
        {
            for (int i = 0; i < count; i++, from += stride)
            {
                a[i] = ((ulong*)from)[0];
                b[i] = ((ulong*)from)[1];
                c[i] = ((ulong*)from)[2];
            }
        }

        static void ToThreeOfTwo(byte* from, int stride, int count, ushort* a, ushort* b, ushort* c)
        {
            for (int i = 0; i < count; i++, from += stride)
            {
                a[i] = ((ushort*)from)[0];
                b[i] = ((ushort*)from)[1];
                c[i] = ((ushort*)from)[2];
            }
        }

        static void ToThreeOfFour(byte* from, int stride, int count, uint* a, uint* b, uint* c)
        {
            int i = 0;
            for (; i < count - 1; i += 2, from += 2 * stride)
            {
                byte* second = from + stride;
                *(ulong*)(a + i) = *(uint*)from | (ulong)*(uint*)second << 32;
                *(ulong*)(b + i) = *(uint*)(from + 4) | (ulong)*(uint*)(second + 4) << 32;
                *(ulong*)(c + i) = *(uint*)(from + 8) | (ulong)*(uint*)(second + 8) << 32;
            }
            for (; i < count; i++, from += stride)
            {
                a[i] = ((uint*)from)[0];
                b[i] = ((uint*)from)[1];
                c[i] = ((uint*)from)[2];
            }
        }

        static void ToPositionAndColor(byte* records, int stride, int count, FieldCopy* copy, byte* columns, int first)
        {
            uint* x = (uint*)(columns + copy->Column0) + first;
            uint* y = (uint*)(columns + copy->Column1) + first;
            uint* z = (uint*)(columns + copy->Column2) + first;
            ushort* red = (ushort*)(columns + copy->Red) + first;
            ushort* green = (ushort*)(columns + copy->Green) + first;
            ushort* blue = (ushort*)(columns + copy->Blue) + first;
            byte* color = records + copy->ColorByte;
            for (int i = 0; i < count; i++, records += stride, color += stride)
            {
                x[i] = ((uint*)records)[0];
                y[i] = ((uint*)records)[1];
                z[i] = ((uint*)records)[2];
                red[i] = ((ushort*)color)[0];
                green[i] = ((ushort*)color)[1];
                blue[i] = ((ushort*)color)[2];
            }
        }

        // Formats that are written have no reversed fields.
        static void FromColumn(byte* columns, int first, int count, FieldCopy* copy, byte* records, int stride)
        {
            byte* to = records + copy->RecordByte;
            byte* from = columns + copy->Column0;
            switch (copy->Kind)
            {
                case FieldCopyKind.Bits:
                    FromBits(from + first, count, to, stride, copy->BitShift, copy->BitMask);
                    break;
                case FieldCopyKind.Bytes1:
                    FromOne(from + first, count, to, stride);
                    break;
                case FieldCopyKind.Bytes2:
                    FromTwo((ushort*)from + first, count, to, stride);
                    break;
                case FieldCopyKind.Bytes4:
                    FromFour((uint*)from + first, count, to, stride);
                    break;
                case FieldCopyKind.Bytes8:
                    FromEight((ulong*)from + first, count, to, stride);
                    break;
                case FieldCopyKind.TripleOfBytes1:
                    FromOne(from + first, count, to, stride);
                    FromOne(columns + copy->Column1 + first, count, to + 1, stride);
                    FromOne(columns + copy->Column2 + first, count, to + 2, stride);
                    break;
                case FieldCopyKind.TripleOfBytes8:
                    FromEight((ulong*)from + first, count, to, stride);
                    FromEight((ulong*)(columns + copy->Column1) + first, count, to + 8, stride);
                    FromEight((ulong*)(columns + copy->Column2) + first, count, to + 16, stride);
                    break;
                case FieldCopyKind.TripleOfBytes2:
                    FromTwo((ushort*)from + first, count, to, stride);
                    FromTwo((ushort*)(columns + copy->Column1) + first, count, to + 2, stride);
                    FromTwo((ushort*)(columns + copy->Column2) + first, count, to + 4, stride);
                    break;
                case FieldCopyKind.TripleOfBytes4:
                    FromFour((uint*)from + first, count, to, stride);
                    FromFour((uint*)(columns + copy->Column1) + first, count, to + 4, stride);
                    FromFour((uint*)(columns + copy->Column2) + first, count, to + 8, stride);
                    break;
                case FieldCopyKind.PositionAndColor:
                    FromFour((uint*)from + first, count, to, stride);
                    FromFour((uint*)(columns + copy->Column1) + first, count, to + 4, stride);
                    FromFour((uint*)(columns + copy->Column2) + first, count, to + 8, stride);
                    FromTwo((ushort*)(columns + copy->Red) + first, count, records + copy->ColorByte, stride);
                    FromTwo((ushort*)(columns + copy->Green) + first, count, records + copy->ColorByte + 2, stride);
                    FromTwo((ushort*)(columns + copy->Blue) + first, count, records + copy->ColorByte + 4, stride);
                    break;
            }
        }

        // Bits beyond the field's width are dropped, and the other fields of the byte stay.
        static void FromBits(byte* from, int count, byte* to, int stride, int shift, int mask)
        {
            for (int i = 0; i < count; i++, to += stride)
                *to = (byte)(*to & ~(mask << shift) | (from[i] & mask) << shift);
        }

        static void FromOne(byte* from, int count, byte* to, int stride)
        {
            for (int i = 0; i < count; i++, to += stride)
                *to = from[i];
        }

        static void FromEight(ulong* from, int count, byte* to, int stride)
        {
            for (int i = 0; i < count; i++, to += stride)
                *(ulong*)to = from[i];
        }

        static void FromTwo(ushort* from, int count, byte* to, int stride)
        {
            for (int i = 0; i < count; i++, to += stride)
                *(ushort*)to = from[i];
        }

        static void FromFour(uint* from, int count, byte* to, int stride)
        {
            for (int i = 0; i < count; i++, to += stride)
                *(uint*)to = from[i];
        }
    }

    internal readonly unsafe struct FieldCopies
    {
        public readonly FieldCopy* First;
        public readonly int Count;

        public FieldCopies(FieldCopy* first, int count)
        {
            First = first;
            Count = count;
        }

        public static implicit operator FieldCopies(NativeArray<FieldCopy> copies) =>
            new FieldCopies((FieldCopy*)copies.GetUnsafeReadOnlyPtr(), copies.Length);
    }
}
