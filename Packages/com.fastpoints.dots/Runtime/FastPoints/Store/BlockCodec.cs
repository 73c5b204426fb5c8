using System.Runtime.CompilerServices;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Store
{
    /// <summary>Packs and unpacks columns of a block as offsets from the column's minimum, each at the width of the largest
    /// (frame of reference). Any value can be read on its own. The layout is that of <see cref="PlaneShape"/>.</summary>
    internal static unsafe class BlockCodec
    {
        const int Lanes = 8; // 32-bit values of a vector.

        /// <summary>Bits that a number needs: 0 for 0, 64 for the largest.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int WidthOf(ulong value) => 64 - math.lzcnt(value);

        /// <summary>Writes offsets of up to 32 bits.</summary>
        /// <param name="words">Must have room for <see cref="PlaneShape.WordsOf"/>.</param>
        /// <returns>The number of words written.</returns>
        public static int Pack(uint* values, uint minimum, int count, int width, uint* words)
        {
            if (width == 0)
                return 0;
            ulong* at = (ulong*)words;
            ulong filled = 0;
            int bits = 0, i = 0;
            // Neighbours are joined first, so that the chain of dependent steps is half or a quarter as long.
            for (; width <= 16 && i + 4 <= count; i += 4)
            {
                ulong low = PairOf(values + i, minimum, width), high = PairOf(values + i + 2, minimum, width);
                Append(low | high << 2 * width, 4 * width, ref at, ref filled, ref bits);
            }
            for (; i + 2 <= count; i += 2)
                Append(PairOf(values + i, minimum, width), 2 * width, ref at, ref filled, ref bits);
            if (i < count)
                Append(values[i] - minimum, width, ref at, ref filled, ref bits);
            if (bits > 0)
                *(uint*)at = (uint)filled;
            if (bits > 32)
                ((uint*)at)[1] = (uint)(filled >> 32);
            return PlaneShape.WordsOf(count, width);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong PairOf(uint* values, uint minimum, int width) => values[0] - minimum | (ulong)(values[1] - minimum) << width;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static void Append(ulong value, int width, ref ulong* at, ref ulong filled, ref int bits)
        {
            filled |= value << bits;
            bits += width;
            if (bits < 64)
                return;
            *at++ = filled;
            bits -= 64;
            filled = value >> 1 >> width - bits - 1;
        }

        /// <summary>Writes offsets of up to 64 bits.</summary>
        /// <returns>The number of words written.</returns>
        public static int PackWide(ulong* values, ulong minimum, int count, int width, uint* words)
        {
            if (width == 0)
                return 0;
            int lowWidth = math.min(width, 32), highWidth = width - lowWidth;
            uint* at = words;
            ulong filled = 0;
            int bits = 0;
            for (int i = 0; i < count; i++)
            {
                ulong offset = values[i] - minimum;
                filled |= (ulong)(uint)offset << bits;
                bits += lowWidth;
                if (bits >= 32)
                {
                    *at++ = (uint)filled;
                    filled >>= 32;
                    bits -= 32;
                }
                filled |= (offset >> 32) << bits;
                bits += highWidth;
                if (bits >= 32)
                {
                    *at++ = (uint)filled;
                    filled >>= 32;
                    bits -= 32;
                }
            }
            if (bits > 0)
                *at++ = (uint)filled;
            return (int)(at - words);
        }

        public static void Unpack(uint* words, uint minimum, int count, int width, uint* values)
        {
            if (width == 0)
            {
                for (int i = 0; i < count; i++)
                    values[i] = minimum;
                return;
            }
            byte* bytes = (byte*)words;
            uint mask = width == 32 ? uint.MaxValue : (1u << width) - 1;
            int bit = 0;
            for (int i = 0; i < count; i++, bit += width)
                values[i] = minimum + ((uint)(*(ulong*)(bytes + (bit >> 3)) >> (bit & 7)) & mask);
        }

        public static void UnpackWide(uint* words, ulong minimum, int count, int width, ulong* values)
        {
            for (int i = 0; i < count; i++)
                values[i] = minimum + OffsetAt(words, (long)i * width, width);
        }

        public static void UnpackWide(uint* words, ulong minimum, int first, int count, int width, ulong* values)
        {
            if (width > 32)
            {
                for (int i = 0; i < count; i++)
                    values[i] = minimum + OffsetAt(words, (long)(first + i) * width, width);
                return;
            }
            ulong mask = (1UL << width) - 1;
            int bit = first * width;
            // The second word may lie in what follows the last: see PlaneShape.SlackBytes.
            for (int i = 0; i < count; i++, bit += width)
            {
                uint* at = words + (bit >> 5);
                values[i] = minimum + ((at[0] | (ulong)at[1] << 32) >> (bit & 31) & mask);
            }
        }

        public static ulong ValueAt(uint* words, ulong minimum, int width, int index) =>
            minimum + OffsetAt(words, (long)index * width, width);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static ulong OffsetAt(uint* words, long bit, int width)
        {
            if (width == 0)
                return 0;
            uint* at = words + (bit >> 5);
            int shift = (int)(bit & 31);
            // Not one load of eight bytes, since words lie at multiples of four: ARMv7 faults on some of those.
            ulong value = (at[0] | (ulong)at[1] << 32) >> shift;
            // A value that starts inside a word and is wider than the rest of two ends in the third.
            if (shift + width > 64)
                value |= (ulong)at[2] << (64 - shift);
            return width == 64 ? value : value & ((1UL << width) - 1);
        }

        internal static void FindRange(uint* values, int count, out uint min, out uint max)
        {
            int first = 0;
            if (X86.Avx2.IsAvx2Supported && count >= Lanes)
            {
                var low = X86.Avx.mm256_loadu_si256(values);
                var high = low;
                for (first = Lanes; first + Lanes <= count; first += Lanes)
                {
                    var eight = X86.Avx.mm256_loadu_si256(values + first);
                    low = X86.Avx2.mm256_min_epu32(low, eight);
                    high = X86.Avx2.mm256_max_epu32(high, eight);
                }
                uint* found = stackalloc uint[2 * Lanes];
                X86.Avx.mm256_storeu_si256(found, low);
                X86.Avx.mm256_storeu_si256(found + Lanes, high);
                FindRangePlain(found, 2 * Lanes, found[0], found[0], out min, out max);
            }
            else
            {
                min = max = values[0];
            }
            FindRangePlain(values + first, count - first, min, max, out min, out max);
        }

        /// <summary>The same for some of the values and a known range: Burst vectorizes it.</summary>
        internal static void FindRangePlain(uint* values, int count, uint knownMin, uint knownMax, out uint min, out uint max)
        {
            uint low = knownMin, high = knownMax;
            for (int i = 0; i < count; i++)
            {
                low = math.min(low, values[i]);
                high = math.max(high, values[i]);
            }
            min = low;
            max = high;
        }
    }
}
