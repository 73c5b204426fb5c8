using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;

namespace FastPoints.Store
{
    /// <summary>A 64-bit hash of one point: its position on the cloud's grid and the bytes of all its attributes. The sum of all
    /// hashes modulo 2^64 is the cloud's checksum, which does not depend on the order. The hash also decides which point
    /// represents a cell.</summary>
    /// <remarks>The record as it is hashed: X, Y, Z as three 64-bit numbers, then the attributes' bytes in the schema's order
    /// without gaps, filled up with zeros to whole 32-bit words, taken two words at a time; an odd last word is
    /// zero-extended; without attributes the word is zero. Two numbers at a time are multiplied and folded, as wyhash does:
    /// its quality at a third of the instructions of XXH64's tail. Different seeds give independent hashes.</remarks>
    internal static unsafe class RecordHash
    {
        // No position equals one of them (K2 with either seed): the product would be 0 and lose the other factor.
        const ulong K1 = 0xA0761D6478BD642FUL;
        const ulong K2 = 0xE7037ED1A0B428DBUL;
        const ulong K3 = 0x8EBC6AF09C88C6E3UL;
        const ulong K4 = 0x589965CC75374CC3UL;
        public const ulong ChecksumSeed = 0; // Also chooses the point that represents a cell.
        public const ulong SecondSeed = 0x5851F42D4C957F2DUL; // Two independent sums make the 128 bits that prove equality.

        public static int PaddedBytes(int attributeBytes) => (attributeBytes + 3) & ~3;

        // The attributes are padded with zeros, to a multiple of 4 bytes.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Of(Grid3 position, byte* attributes, int paddedBytes, ulong seed)
        {
            ulong hash = Fold((ulong)position.X ^ K1, (ulong)position.Y ^ K2 ^ seed);
            ulong word = (ulong)position.Z ^ K3;
            int at = 0;
            for (; at + 8 <= paddedBytes; at += 8)
            {
                hash = Fold(word, hash ^ *(ulong*)(attributes + at));
                word = K3;
            }
            if (at < paddedBytes || paddedBytes == 0)
                hash = Fold(word, hash ^ (paddedBytes == 0 ? 0 : *(uint*)(attributes + at)));
            return Fold(hash ^ K4, K2);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong Fold(ulong a, ulong b)
        {
            ulong low = Common.umul128(a, b, out ulong high);
            return low ^ high;
        }
    }
}
