using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Points
{
    /// <summary>
    /// Three coordinates of 21 bits and one 63-bit code whose order is the Z curve's:
    /// <code>
    /// bit  62 61 60  59 58 57  ...  5  4  3   2  1  0
    ///       z  y  x   z  y  x  ...  z  y  x   z  y  x
    ///      bit 20     bit 19        bit 1     bit 0
    /// </code>
    /// </summary>
    /// <remarks>Spread and gathered by shifts and masks (Warren, Hacker's Delight, ch. 7): no table to keep in the cache, and a
    /// compiler can do several codes at once.</remarks>
    internal static unsafe class Morton
    {
        /// <summary>Bits of one coordinate.</summary>
        public const int BitsPerAxis = 21;

        /// <summary>Bits of one coordinate that <see cref="EncodeFew"/> takes.</summary>
        public const int FewBits = 7;

        // 32-bit values of a vector.
        const int VectorLength = 8;

        // One bit for each of three numbers of 21 bits.
        const ulong Lanes = 1 | 1UL << 21 | 1UL << 42;

        /// <summary>The largest coordinate.</summary>
        public const uint MaxCoordinate = (1u << BitsPerAxis) - 1;

        /// <summary>Interleaves the coordinates; bits above <see cref="MaxCoordinate"/> are ignored.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong Encode(uint x, uint y, uint z) => Spread(x) | Spread(y) << 1 | Spread(z) << 2;

        /// <summary>Interleaves coordinates of at most <see cref="FewBits"/> bits: three of them fit one number.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int EncodeFew(uint x, uint y, uint z)
        {
            ulong v = x | (ulong)y << 21 | (ulong)z << 42;
            v = (v | v << 8) & 0x700FUL * Lanes;
            v = (v | v << 4) & 0x430C3UL * Lanes;
            v = (v | v << 2) & 0x49249UL * Lanes;
            return (int)(v | v >> 20 | v >> 40) & (1 << 3 * FewBits) - 1;
        }

        /// <summary>The codes of many positions: coordinates relative to a corner, shifted right.</summary>
        public static void Encode(uint* x, uint* y, uint* z, int count, uint3 corner, int shift, ulong* codes)
        {
            int i = 0;
            if (X86.Avx2.IsAvx2Supported)
            {
                for (; i + VectorLength <= count; i += VectorLength)
                {
                    var vx = Load(x + i, corner.x, shift);
                    var vy = Load(y + i, corner.y, shift);
                    var vz = Load(z + i, corner.z, shift);
                    var even = Join(SpreadEven(vx), SpreadEven(vy), SpreadEven(vz));
                    var odd = Join(SpreadEven(X86.Avx2.mm256_srli_epi64(vx, 32)), SpreadEven(X86.Avx2.mm256_srli_epi64(vy, 32)),
                        SpreadEven(X86.Avx2.mm256_srli_epi64(vz, 32)));
                    // 0 1 4 5 and 2 3 6 7.
                    var low = X86.Avx2.mm256_unpacklo_epi64(even, odd);
                    var high = X86.Avx2.mm256_unpackhi_epi64(even, odd);
                    X86.Avx.mm256_storeu_si256(codes + i, X86.Avx2.mm256_permute2x128_si256(low, high, 0x20));
                    X86.Avx.mm256_storeu_si256(codes + i + 4, X86.Avx2.mm256_permute2x128_si256(low, high, 0x31));
                }
            }
            for (; i < count; i++)
                codes[i] = Encode(x[i] - corner.x >> shift, y[i] - corner.y >> shift, z[i] - corner.z >> shift);
        }

        /// <summary>The same for coordinates that have at most <see cref="FewBits"/> bits when shifted.</summary>
        public static void EncodeFew(uint* x, uint* y, uint* z, int count, uint3 corner, int shift, uint* codes)
        {
            int i = 0;
            if (X86.Avx2.IsAvx2Supported)
            {
                for (; i + VectorLength <= count; i += VectorLength)
                {
                    X86.Avx.mm256_storeu_si256(codes + i, Join(SpreadFew(Load(x + i, corner.x, shift)),
                        SpreadFew(Load(y + i, corner.y, shift)), SpreadFew(Load(z + i, corner.z, shift))));
                }
            }
            for (; i < count; i++)
                codes[i] = (uint)EncodeFew(x[i] - corner.x >> shift, y[i] - corner.y >> shift, z[i] - corner.z >> shift);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 Load(uint* values, uint corner, int shift) => X86.Avx2.mm256_srlv_epi32(
            X86.Avx2.mm256_sub_epi32(X86.Avx.mm256_loadu_si256(values), X86.Avx.mm256_set1_epi32((int)corner)),
            X86.Avx.mm256_set1_epi32(shift));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 Join(v256 x, v256 y, v256 z) => X86.Avx2.mm256_or_si256(x,
            X86.Avx2.mm256_or_si256(X86.Avx2.mm256_slli_epi64(y, 1), X86.Avx2.mm256_slli_epi64(z, 2)));

        // Spreads the lower halves of 64-bit lanes.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 SpreadEven(v256 v)
        {
            v = X86.Avx2.mm256_and_si256(v, X86.Avx.mm256_set1_epi64x(MaxCoordinate));
            v = Step(v, 32, 0x001F00000000FFFF);
            v = Step(v, 16, 0x001F0000FF0000FF);
            v = Step(v, 8, 0x100F00F00F00F00F);
            v = Step(v, 4, 0x10C30C30C30C30C3);
            return Step(v, 2, 0x1249249249249249);
        }

        // Two lanes at a time: codes of 21 bits stay within 32.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 SpreadFew(v256 v)
        {
            v = Step(v, 8, 0x0000700F0000700F);
            v = Step(v, 4, 0x000430C3000430C3);
            return Step(v, 2, 0x0004924900049249);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static v256 Step(v256 v, int shift, long mask) => X86.Avx2.mm256_and_si256(
            X86.Avx2.mm256_or_si256(v, X86.Avx2.mm256_sllv_epi64(v, X86.Avx.mm256_set1_epi64x(shift))),
            X86.Avx.mm256_set1_epi64x(mask));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Decode(ulong code, out uint x, out uint y, out uint z)
        {
            x = Gather(code);
            y = Gather(code >> 1);
            z = Gather(code >> 2);
        }

        /// <summary>Moves bit i of the low 21 to bit 3i.</summary>
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

        /// <summary>Moves bit 3i to bit i: the inverse of <see cref="Spread"/>, whatever lies between.</summary>
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
}
