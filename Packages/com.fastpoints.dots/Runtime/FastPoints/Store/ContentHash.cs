using System.Runtime.CompilerServices;

namespace FastPoints.Store
{
    /// <summary>The 64-bit hash that guards each byte range of a stored cloud: XXH64 with seed 0, as its published specification
    /// defines it. It detects damage, not tampering.</summary>
    internal static unsafe class ContentHash
    {
        const ulong P1 = 0x9E3779B185EBCA87UL;
        const ulong P2 = 0xC2B2AE3D27D4EB4FUL;
        const ulong P3 = 0x165667B19E3779F9UL;
        const ulong P4 = 0x85EBCA77C2B2AE63UL;
        const ulong P5 = 0x27D4EB2F165667C5UL;

        public static ulong Of(void* bytes, long count)
        {
            byte* at = (byte*)bytes;
            byte* end = at + count;
            ulong hash;
            if (count >= 32)
            {
                ulong a = unchecked(P1 + P2), b = P2, c = 0, d = unchecked(0 - P1);
                for (byte* last = end - 32; at <= last; at += 32)
                {
                    a = Round(a, ((ulong*)at)[0]);
                    b = Round(b, ((ulong*)at)[1]);
                    c = Round(c, ((ulong*)at)[2]);
                    d = Round(d, ((ulong*)at)[3]);
                }
                hash = Rotate(a, 1) + Rotate(b, 7) + Rotate(c, 12) + Rotate(d, 18);
                hash = Merge(hash, a);
                hash = Merge(hash, b);
                hash = Merge(hash, c);
                hash = Merge(hash, d);
            }
            else
            {
                hash = P5;
            }

            hash += (ulong)count;
            for (; end - at >= 8; at += 8)
                hash = Rotate(hash ^ Round(0, *(ulong*)at), 27) * P1 + P4;
            if (end - at >= 4)
            {
                hash = Rotate(hash ^ *(uint*)at * P1, 23) * P2 + P3;
                at += 4;
            }
            for (; at < end; at++)
                hash = Rotate(hash ^ *at * P5, 11) * P1;

            hash ^= hash >> 33;
            hash *= P2;
            hash ^= hash >> 29;
            hash *= P3;
            return hash ^ hash >> 32;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Rotate(ulong value, int bits) => value << bits | value >> (64 - bits);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Round(ulong lane, ulong input) => Rotate(lane + input * P2, 31) * P1;

        static ulong Merge(ulong hash, ulong lane) => (hash ^ Round(0, lane)) * P1 + P4;
    }
}
