namespace FastPoints.E57
{
    // Integers of any width, packed without gaps from the lowest bit of the first byte on (ASTM E2807, 9.7.2): value i takes bits
    // i*w to i*w + w - 1, where bit b is bit b % 8 of byte b / 8.
    static unsafe class E57Bits
    {
        // Behind the last value: may be loaded and not used.
        public const int PaddingBytes = 16;

        public static ulong Mask(int bits) => bits == 0 ? 0 : ulong.MaxValue >> 64 - bits;

        // bits: 1 to 64.
        public static void Unpack(byte* bytes, long firstBit, int bits, int count, ulong* values)
        {
            ulong mask = Mask(bits);
            if ((firstBit & 7) == 0 && (bits == 8 || bits == 16 || bits == 32))
            {
                UnpackBytes(bytes + (firstBit >> 3), bits, count, values);
                return;
            }
            if (bits <= 57)
            {
                long at = firstBit;
                for (int i = 0; i < count; i++, at += bits)
                    values[i] = *(ulong*)(bytes + (at >> 3)) >> (int)(at & 7) & mask;
                return;
            }
            for (int i = 0; i < count; i++)
            {
                long at = firstBit + (long)i * bits;
                int shift = (int)(at & 7);
                byte* p = bytes + (at >> 3);
                ulong value = *(ulong*)p >> shift;
                // This shifts twice, since a shift by 64 is one by 0.
                value |= (ulong)p[8] << (63 - shift) << 1;
                values[i] = value & mask;
            }
        }

        static void UnpackBytes(byte* bytes, int bits, int count, ulong* values)
        {
            if (bits == 8)
                for (int i = 0; i < count; i++)
                    values[i] = bytes[i];
            else if (bits == 16)
                for (int i = 0; i < count; i++)
                    values[i] = ((ushort*)bytes)[i];
            else
                for (int i = 0; i < count; i++)
                    values[i] = ((uint*)bytes)[i];
        }

        public static long BytesOf(long firstBit, int bits, long count) => (firstBit + count * bits + 7 >> 3) - (firstBit >> 3);
    }
}
