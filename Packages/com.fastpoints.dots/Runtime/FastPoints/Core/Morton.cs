using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace FastPoints
{
    /// <summary>
    /// Three coordinates of 21 bits and one 63-bit code whose order is the Z curve's:
    /// <code>
    /// bit  62 61 60  59 58 57  ...  5  4  3   2  1  0
    ///       z  y  x   z  y  x  ...  z  y  x   z  y  x
    ///      bit 20     bit 19        bit 1     bit 0
    /// </code>
    /// </summary>
    /// <remarks>Spread and gathered by shifts and masks (Warren, Hacker's Delight, ch. 7): no table to keep in the
    /// cache, and compilers can vectorize it.</remarks>
    internal static unsafe class Morton
    {
        public const int BitsPerAxis = 21;
        public const int ShortBits = 7;
        const ulong Lanes = 1 | 1UL << 21 | 1UL << 42; // One bit for each of three numbers of 21 bits.
        public const uint MaxCoordinate = (1u << BitsPerAxis) - 1;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Encode(uint x, uint y, uint z) => Spread(x) | Spread(y) << 1 | Spread(z) << 2;

        // For at most ShortBits bits: three of them fit into one number.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int EncodeShort(uint x, uint y, uint z)
        {
            ulong v = x | (ulong)y << 21 | (ulong)z << 42;
            v = (v | v << 8) & 0x700FUL * Lanes;
            v = (v | v << 4) & 0x430C3UL * Lanes;
            v = (v | v << 2) & 0x49249UL * Lanes;
            return (int)(v | v >> 20 | v >> 40) & (1 << 3 * ShortBits) - 1;
        }

        // Burst vectorizes it.
        public static void Encode(uint* x, uint* y, uint* z, int count, MortonCells cells, ulong* codes)
        {
            var corner = cells.Corner;
            int shift = cells.SideLog2;
            for (int i = 0; i < count; i++)
                codes[i] = Encode(x[i] - corner.x >> shift, y[i] - corner.y >> shift, z[i] - corner.z >> shift);
        }

        public static void EncodeShort(uint* x, uint* y, uint* z, int count, MortonCells cells, uint* codes)
        {
            var corner = cells.Corner;
            int shift = cells.SideLog2;
            for (int i = 0; i < count; i++)
                codes[i] = (uint)EncodeShort(x[i] - corner.x >> shift, y[i] - corner.y >> shift, z[i] - corner.z >> shift);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Decode(ulong code, out uint x, out uint y, out uint z)
        {
            x = Gather(code);
            y = Gather(code >> 1);
            z = Gather(code >> 2);
        }

        // Moves bit i of the low 21 to bit 3i.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Spread(uint value)
        {
            ulong v = value & MaxCoordinate;
            v = (v | v << 32) & 0x001F00000000FFFFUL;
            v = (v | v << 16) & 0x001F0000FF0000FFUL;
            v = (v | v << 8) & 0x100F00F00F00F00FUL;
            v = (v | v << 4) & 0x10C30C30C30C30C3UL;
            v = (v | v << 2) & 0x1249249249249249UL;
            return v;
        }

        // Moves bit 3i to bit i; other bits are ignored.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint Gather(ulong code)
        {
            ulong v = code & 0x1249249249249249UL;
            v = (v | v >> 2) & 0x10C30C30C30C30C3UL;
            v = (v | v >> 4) & 0x100F00F00F00F00FUL;
            v = (v | v >> 8) & 0x001F0000FF0000FFUL;
            v = (v | v >> 16) & 0x001F00000000FFFFUL;
            v = (v | v >> 32) & MaxCoordinate;
            return (uint)v;
        }
    }
    internal readonly struct MortonCells
    {
        public readonly uint3 Corner;
        public readonly int SideLog2;

        public MortonCells(uint3 corner, int sideLog2) => (Corner, SideLog2) = (corner, sideLog2);
    }
}
