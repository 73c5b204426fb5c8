using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Copies binary PLY records to columns. Every value's bytes are kept, and reversed if the file is big-endian.
    /// Called by jobs; HPC#.</summary>
    static unsafe class PlyRecords
    {
        /// <summary>Records that go through all copies before the next ones do: they stay in the first-level cache.</summary>
        const int TilePoints = 512;

        /// <summary>
        /// Fills the columns that <paramref name="copies"/> name with <paramref name="count"/> points, from <paramref
        /// name="firstPoint"/> of the columns on.
        /// </summary>
        /// <param name="stride">Bytes from one wanted record to the next.</param>
        public static void ToColumns(byte* records, int stride, int count, PlyCopy* copies, int copyCount, bool isBigEndian,
            byte* columns, int firstPoint = 0)
        {
            for (int first = 0; first < count; first += TilePoints)
            {
                int points = math.min(TilePoints, count - first);
                byte* tile = records + (long)first * stride;
                for (int i = 0; i < copyCount; i++)
                    Copy(tile, stride, points, copies[i], isBigEndian, columns, firstPoint + first);
            }
        }

        static void Copy(byte* tile, int stride, int count, in PlyCopy copy, bool isBigEndian, byte* output, int first)
        {
            byte* source = tile + copy.SourceBytes;
            long skip = (long)first * copy.ValueBytes;
            byte* column0 = output + copy.Column0 + skip;
            byte* column1 = output + copy.Column1 + skip;
            byte* column2 = output + copy.Column2 + skip;
            switch (copy.ValueBytes)
            {
                case 1:
                    Copy1(source, stride, column0, column1, column2, copy.Values, count);
                    break;
                case 2:
                    Copy2(source, stride, (ushort*)column0, (ushort*)column1, (ushort*)column2, copy.Values, count, isBigEndian);
                    break;
                case 4:
                    Copy4(source, stride, (uint*)column0, (uint*)column1, (uint*)column2, copy.Values, count, isBigEndian);
                    break;
                default:
                    Copy8(source, stride, (ulong*)column0, (ulong*)column1, (ulong*)column2, copy.Values, count, isBigEndian);
                    break;
            }
        }

        static void Copy1(byte* source, int stride, byte* column0, byte* column1, byte* column2, int values, int count)
        {
            if (values == 3)
            {
                int i = 0;
                for (; i < count - 3; i += 4, source += 4 * stride)
                {
                    byte* second = source + stride, third = second + stride, fourth = third + stride;
                    *(uint*)(column0 + i) = (uint)(source[0] | second[0] << 8 | third[0] << 16 | fourth[0] << 24);
                    *(uint*)(column1 + i) = (uint)(source[1] | second[1] << 8 | third[1] << 16 | fourth[1] << 24);
                    *(uint*)(column2 + i) = (uint)(source[2] | second[2] << 8 | third[2] << 16 | fourth[2] << 24);
                }
                for (; i < count; i++, source += stride)
                {
                    column0[i] = source[0];
                    column1[i] = source[1];
                    column2[i] = source[2];
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = source[0];
                if (values > 1)
                    column1[i] = source[1];
            }
        }

        static void Copy2(byte* source, int stride, ushort* column0, ushort* column1, ushort* column2, int values, int count,
            bool isBigEndian)
        {
            if (values == 3 && !isBigEndian)
            {
                for (int i = 0; i < count; i++, source += stride)
                {
                    column0[i] = *(ushort*)source;
                    column1[i] = *(ushort*)(source + 2);
                    column2[i] = *(ushort*)(source + 4);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load2(source, isBigEndian);
                if (values > 1)
                    column1[i] = Load2(source + 2, isBigEndian);
                if (values > 2)
                    column2[i] = Load2(source + 4, isBigEndian);
            }
        }

        static void Copy4(byte* source, int stride, uint* column0, uint* column1, uint* column2, int values, int count,
            bool isBigEndian)
        {
            if (values == 3 && !isBigEndian)
            {
                int i = 0;
                for (; i < count - 1; i += 2, source += 2 * stride)
                {
                    byte* second = source + stride;
                    *(ulong*)(column0 + i) = *(uint*)source | (ulong)*(uint*)second << 32;
                    *(ulong*)(column1 + i) = *(uint*)(source + 4) | (ulong)*(uint*)(second + 4) << 32;
                    *(ulong*)(column2 + i) = *(uint*)(source + 8) | (ulong)*(uint*)(second + 8) << 32;
                }
                for (; i < count; i++, source += stride)
                {
                    column0[i] = *(uint*)source;
                    column1[i] = *(uint*)(source + 4);
                    column2[i] = *(uint*)(source + 8);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load4(source, isBigEndian);
                if (values > 1)
                    column1[i] = Load4(source + 4, isBigEndian);
                if (values > 2)
                    column2[i] = Load4(source + 8, isBigEndian);
            }
        }

        static void Copy8(byte* source, int stride, ulong* column0, ulong* column1, ulong* column2, int values, int count,
            bool isBigEndian)
        {
            if (values == 3 && !isBigEndian)
            {
                for (int i = 0; i < count; i++, source += stride)
                {
                    column0[i] = *(ulong*)source;
                    column1[i] = *(ulong*)(source + 8);
                    column2[i] = *(ulong*)(source + 16);
                }
                return;
            }
            for (int i = 0; i < count; i++, source += stride)
            {
                column0[i] = Load8(source, isBigEndian);
                if (values > 1)
                    column1[i] = Load8(source + 8, isBigEndian);
                if (values > 2)
                    column2[i] = Load8(source + 16, isBigEndian);
            }
        }

        static ushort Load2(byte* p, bool isBigEndian) => isBigEndian ? (ushort)(p[0] << 8 | p[1]) : *(ushort*)p;

        static uint Load4(byte* p, bool isBigEndian) => isBigEndian ? PlyBytes.Reverse(*(uint*)p) : *(uint*)p;

        static ulong Load8(byte* p, bool isBigEndian) => isBigEndian ? PlyBytes.Reverse(*(ulong*)p) : *(ulong*)p;
    }
}
