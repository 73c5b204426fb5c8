namespace FastPoints.Files
{
    /// <summary>Copies point records to columns and back: one tight strided loop for each copy of a plan. Called by jobs and
    /// directly; HPC#.</summary>
    /// <remarks>Values in a record are not aligned, so they are loaded through pointers, which the machines Unity runs on allow.
    /// Several copies go over the same records: in tiles, so that a record comes from memory once and from the L1 cache
    /// after.</remarks>
    internal static unsafe class LasRecords
    {
        const int TileBytes = 16 << 10;

        /// <summary>Fills the columns that <paramref name="copies"/> name with <paramref name="count"/> points, from
        /// <paramref name="firstPoint"/> of the columns on.</summary>
        public static void ToColumns(byte* records, int recordBytes, int count, LasFieldCopy* copies, int copyCount,
            byte* columns, int firstPoint = 0)
        {
            int tilePoints = TilePoints(recordBytes);
            for (int first = 0; first < count; first += tilePoints)
            {
                int points = count - first < tilePoints ? count - first : tilePoints;
                byte* tile = records + (long)first * recordBytes;
                for (int i = 0; i < copyCount; i++)
                    ToColumn(tile, recordBytes, points, copies + i, columns, firstPoint + first);
            }
        }

        /// <summary>Packs <paramref name="count"/> points of the columns, from <paramref name="firstPoint"/> on, into records,
        /// whose other bytes (and bits) stay as they are.</summary>
        public static void FromColumns(byte* columns, int firstPoint, int count, LasFieldCopy* copies, int copyCount,
            byte* records, int recordBytes)
        {
            int tilePoints = TilePoints(recordBytes);
            for (int first = 0; first < count; first += tilePoints)
            {
                int points = count - first < tilePoints ? count - first : tilePoints;
                byte* tile = records + (long)first * recordBytes;
                for (int i = 0; i < copyCount; i++)
                    FromColumn(columns, firstPoint + first, points, copies + i, tile, recordBytes);
            }
        }

        static int TilePoints(int recordBytes) => recordBytes < TileBytes / 64 ? TileBytes / recordBytes : 64;

        static void ToColumn(byte* records, int stride, int count, LasFieldCopy* copy, byte* columns, int first)
        {
            byte* from = records + copy->RecordByte;
            byte* to = columns + copy->Column0;
            switch (copy->Kind)
            {
                case LasCopyKind.Bits:
                    ToBits(from, stride, count, to + first, copy->BitShift, copy->BitMask);
                    break;
                case LasCopyKind.One:
                    ToOne(from, stride, count, to + first);
                    break;
                case LasCopyKind.Two:
                    ToTwo(from, stride, count, (ushort*)to + first);
                    break;
                case LasCopyKind.Four:
                    ToFour(from, stride, count, (uint*)to + first);
                    break;
                case LasCopyKind.Eight:
                    ToEight(from, stride, count, (ulong*)to + first);
                    break;
                case LasCopyKind.ThreeOfTwo:
                    ToThreeOfTwo(from, stride, count, (ushort*)to + first, (ushort*)(columns + copy->Column1) + first,
                        (ushort*)(columns + copy->Column2) + first);
                    break;
                case LasCopyKind.ThreeOfFour:
                    ToThreeOfFour(from, stride, count, (uint*)to + first, (uint*)(columns + copy->Column1) + first,
                        (uint*)(columns + copy->Column2) + first);
                    break;
                case LasCopyKind.PositionAndColor:
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
            for (int i = 0; i < count; i++, from += stride)
            {
                a[i] = ((uint*)from)[0];
                b[i] = ((uint*)from)[1];
                c[i] = ((uint*)from)[2];
            }
        }

        static void ToPositionAndColor(byte* records, int stride, int count, LasFieldCopy* copy, byte* columns, int first)
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

        static void FromColumn(byte* columns, int first, int count, LasFieldCopy* copy, byte* records, int stride)
        {
            byte* to = records + copy->RecordByte;
            byte* from = columns + copy->Column0;
            switch (copy->Kind)
            {
                case LasCopyKind.Bits:
                    FromBits(from + first, count, to, stride, copy->BitShift, copy->BitMask);
                    break;
                case LasCopyKind.One:
                    for (int i = 0; i < count; i++, to += stride)
                        *to = from[first + i];
                    break;
                case LasCopyKind.Two:
                    FromTwo((ushort*)from + first, count, to, stride);
                    break;
                case LasCopyKind.Four:
                    FromFour((uint*)from + first, count, to, stride);
                    break;
                case LasCopyKind.Eight:
                    for (int i = 0; i < count; i++, to += stride)
                        *(ulong*)to = ((ulong*)from)[first + i];
                    break;
                case LasCopyKind.ThreeOfTwo:
                    FromTwo((ushort*)from + first, count, to, stride);
                    FromTwo((ushort*)(columns + copy->Column1) + first, count, to + 2, stride);
                    FromTwo((ushort*)(columns + copy->Column2) + first, count, to + 4, stride);
                    break;
                case LasCopyKind.ThreeOfFour:
                    FromFour((uint*)from + first, count, to, stride);
                    FromFour((uint*)(columns + copy->Column1) + first, count, to + 4, stride);
                    FromFour((uint*)(columns + copy->Column2) + first, count, to + 8, stride);
                    break;
                case LasCopyKind.PositionAndColor:
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
}
