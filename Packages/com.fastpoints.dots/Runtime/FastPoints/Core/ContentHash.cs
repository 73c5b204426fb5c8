using System;
using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints
{
    // Guards each byte range of a converted cloud, and of a cache: XXH64 with seed 0, as its published specification defines
    // it. It detects damage, not tampering.
    internal static unsafe class ContentHash
    {
        const ulong P1 = 0x9E3779B185EBCA87UL;
        const ulong P2 = 0xC2B2AE3D27D4EB4FUL;
        const ulong P3 = 0x165667B19E3779F9UL;
        const ulong P4 = 0x85EBCA77C2B2AE63UL;
        const ulong P5 = 0x27D4EB2F165667C5UL;

        public static ulong Of(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* first = bytes)
                return Of(first, bytes.Length);
        }

        public static ulong Of(void* bytes, long count)
        {
            byte* at = (byte*)bytes;
            ulong a = unchecked(P1 + P2), b = P2, c = 0, d = unchecked(0 - P1);
            for (long stripes = count / 32; stripes > 0; stripes--, at += 32)
            {
                a = Round(a, ((ulong*)at)[0]);
                b = Round(b, ((ulong*)at)[1]);
                c = Round(c, ((ulong*)at)[2]);
                d = Round(d, ((ulong*)at)[3]);
            }
            return End(a, b, c, d, at, count);
        }

        // Copies and hashes on the way: multiplying takes most of a hash's time, moving most of a copy's, so that one hides in
        // the other. The target is written front to back and not read.
        public static ulong CopyAndHash(void* target, void* bytes, long count)
        {
            byte* at = (byte*)bytes;
            byte* to = (byte*)target;
            ulong a = unchecked(P1 + P2), b = P2, c = 0, d = unchecked(0 - P1);
            for (long stripes = count / 32; stripes > 0; stripes--, at += 32, to += 32)
            {
                ulong e = ((ulong*)at)[0], f = ((ulong*)at)[1], g = ((ulong*)at)[2], h = ((ulong*)at)[3];
                ((ulong*)to)[0] = e;
                ((ulong*)to)[1] = f;
                ((ulong*)to)[2] = g;
                ((ulong*)to)[3] = h;
                a = Round(a, e);
                b = Round(b, f);
                c = Round(c, g);
                d = Round(d, h);
            }
            UnsafeUtility.MemCpy(to, at, count & 31);
            return End(a, b, c, d, at, count);
        }

        // The last bytes are fewer than 32.
        static ulong End(ulong a, ulong b, ulong c, ulong d, byte* at, long count)
        {
            ulong hash = P5;
            if (count >= 32)
            {
                hash = Rotate(a, 1) + Rotate(b, 7) + Rotate(c, 12) + Rotate(d, 18);
                hash = Merge(Merge(Merge(Merge(hash, a), b), c), d);
            }
            hash += (ulong)count;
            byte* end = at + (count & 31);
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
