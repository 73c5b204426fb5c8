using System.Runtime.CompilerServices;
using FastPoints.Store;
using Unity.Burst.Intrinsics;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>Writes one block of a plane from gathered values: the layout of <see cref="PlaneShape"/>.</summary>
    internal static unsafe class BlockWriting
    {
        // 32-bit values of a vector.
        const int Lanes = 8;

        /// <summary>Where a column of 64-bit values is gathered.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong* WideOf(ulong* values, int column) => values + column * PlaneShape.MaxPointsPerBlock;

        /// <summary>Where a column of 32-bit values is gathered.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint* NarrowOf(ulong* values, int column) => (uint*)values + column * PlaneShape.MaxPointsPerBlock;

        /// <param name="values">The values, with room for <see cref="PlaneShape.MaxColumns"/> full columns.</param>
        /// <param name="descriptor">The block's; afterwards the next one's.</param>
        /// <param name="word">The plane's word where packed words go; afterwards behind them.</param>
        /// <param name="min">For each column, lowered to the block's smallest; <paramref name="max"/> raised to its
        /// largest.</param>
        public static void Write(ulong* values, int count, PlaneShape shape, uint* plane, ref uint* descriptor, ref long word,
            ulong* min, ulong* max)
        {
            uint widths = (uint)(count - 1) << 24;
            descriptor[0] = (uint)word;
            for (int c = 0; c < shape.ColumnCount; c++)
            {
                int at = shape.MinimumWord(c), width;
                ulong least, most;
                if (shape.IsWide(c))
                {
                    ulong* column = WideOf(values, c);
                    least = most = column[0];
                    for (int i = 1; i < count; i++)
                    {
                        least = math.min(least, column[i]);
                        most = math.max(most, column[i]);
                    }
                    width = BlockCodec.WidthOf(most - least);
                    descriptor[at + 1] = (uint)(least >> 32);
                    word += BlockCodec.PackWide(column, least, count, width, plane + word);
                }
                else
                {
                    uint* column = NarrowOf(values, c);
                    FindRange(column, count, out uint leastNarrow, out uint mostNarrow);
                    least = leastNarrow;
                    most = mostNarrow;
                    width = BlockCodec.WidthOf(most - least);
                    word += BlockCodec.Pack(column, leastNarrow, count, width, plane + word);
                }
                min[c] = math.min(min[c], least);
                max[c] = math.max(max[c], most);
                widths |= (uint)width << (8 * c);
                descriptor[at] = (uint)least;
            }
            descriptor[1] = widths;
            descriptor += shape.DescriptorWords;
        }

        /// <summary>The smallest and the largest value.</summary>
        internal static void FindRange(uint* values, int count, out uint least, out uint most)
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
                FindRangePlain(found, 0, 2 * Lanes, found[0], found[0], out least, out most);
            }
            else
            {
                least = most = values[0];
            }
            FindRangePlain(values, first, count, least, most, out least, out most);
        }

        /// <summary>The same for some of the values and a range that is known: Burst makes vectors of it.</summary>
        internal static void FindRangePlain(uint* values, int first, int end, uint knownLeast, uint knownMost, out uint least,
            out uint most)
        {
            least = knownLeast;
            most = knownMost;
            for (int i = first; i < end; i++)
            {
                least = math.min(least, values[i]);
                most = math.max(most, values[i]);
            }
        }
    }
}
