using System.Runtime.CompilerServices;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Nodes
{
    /// <summary>Writes one block of a plane from gathered values: the layout of <see cref="PlaneShape"/>.</summary>
    internal static unsafe class BlockWriting
    {
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
                    BlockCodec.FindRange(column, count, out uint leastNarrow, out uint mostNarrow);
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
    }
}
