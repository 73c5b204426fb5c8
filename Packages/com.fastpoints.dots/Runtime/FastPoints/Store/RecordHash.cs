using System.Runtime.CompilerServices;
using FastPoints.Points;

namespace FastPoints.Store
{
    /// <summary>A 64-bit hash of one point: its position on the cloud's grid and the bytes of all its attributes. The sum of all
    /// hashes modulo 2^64 is the cloud's checksum, which does not depend on the order. The hash also decides which point
    /// represents a cell.</summary>
    /// <remarks>The record as it is hashed: X, Y, Z as three 64-bit numbers, then the attributes' bytes in the schema's order
    /// without gaps, filled up with zeros to whole 32-bit words, taken two words at a time; a last single word counts as one.
    /// Each number goes through a round of XXH64's tail, the end through its avalanche. Different seeds give independent
    /// hashes.</remarks>
    internal static unsafe class RecordHash
    {
        const ulong P1 = 0x9E3779B185EBCA87UL;
        const ulong P2 = 0xC2B2AE3D27D4EB4FUL;
        const ulong P3 = 0x165667B19E3779F9UL;
        const ulong P4 = 0x85EBCA77C2B2AE63UL;
        const ulong P5 = 0x27D4EB2F165667C5UL;

        /// <summary>The seed of the checksum, and of the choice of the point that represents a cell.</summary>
        public const ulong ChecksumSeed = 0;

        /// <summary>A second, independent hash: two sums make the 128 bits that prove equality.</summary>
        public const ulong SecondSeed = 0x5851F42D4C957F2DUL;

        /// <summary>Bytes that attributes take in a record, rounded up to whole 32-bit words.</summary>
        public static int PaddedBytes(int attributeBytes) => (attributeBytes + 3) & ~3;

        /// <param name="place">The position on the cloud's grid.</param>
        /// <param name="attributes">The attributes' bytes, padded with zeros.</param>
        /// <param name="paddedBytes">A multiple of 4.</param>
        /// <param name="seed">One of the seeds above.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Of(Grid3 place, byte* attributes, int paddedBytes, ulong seed)
        {
            ulong hash = seed + P5;
            hash = Round(hash, (ulong)place.X);
            hash = Round(hash, (ulong)place.Y);
            hash = Round(hash, (ulong)place.Z);
            int at = 0;
            for (; at + 8 <= paddedBytes; at += 8)
                hash = Round(hash, *(ulong*)(attributes + at));
            if (at < paddedBytes)
                hash = Round(hash, *(uint*)(attributes + at));
            hash ^= hash >> 33;
            hash *= P2;
            hash ^= hash >> 29;
            hash *= P3;
            return hash ^ hash >> 32;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Round(ulong hash, ulong word)
        {
            word *= P2;
            hash ^= (word << 31 | word >> 33) * P1;
            return (hash << 27 | hash >> 37) * P1 + P4;
        }
    }
}
