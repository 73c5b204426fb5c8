using FastPoints.Core;

namespace FastPoints.Ply
{
    // Of either byte order; Unity runs on little-endian machines only. HPC#.
    static class PlyBytes
    {
        // An integer of 1, 2, 4 or 8 bytes as its bits, without extending its sign.
        public static unsafe ulong Load(byte* p, int bytes, bool isBigEndian)
        {
            ulong value = 0;
            for (int i = 0; i < bytes; i++)
                value |= (ulong)p[i] << 8 * (isBigEndian ? bytes - 1 - i : i);
            return value;
        }

        public static bool IsNegative(ulong bits, AttributeType type) =>
            type.IsSigned() && !type.IsFloat() && (bits >> 8 * type.SizeOf() - 1 & 1) != 0;
    }
}
