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
                ulong low, high;
                if (shape.IsWide(c))
                {
                    ulong* column = WideOf(values, c);
                    low = high = column[0];
                    for (int i = 1; i < count; i++)
                    {
                        low = math.min(low, column[i]);
                        high = math.max(high, column[i]);
                    }
                    width = BlockCodec.WidthOf(high - low);
                    descriptor[at + 1] = (uint)(low >> 32);
                    word += BlockCodec.PackWide(column, low, count, width, plane + word);
                }
                else
                {
                    uint* column = NarrowOf(values, c);
                    BlockCodec.FindRange(column, count, out uint minNarrow, out uint maxNarrow);
                    low = minNarrow;
                    high = maxNarrow;
                    width = BlockCodec.WidthOf(high - low);
                    word += BlockCodec.Pack(column, minNarrow, count, width, plane + word);
                }
                min[c] = math.min(min[c], low);
                max[c] = math.max(max[c], high);
                widths |= (uint)width << (8 * c);
                descriptor[at] = (uint)low;
            }
            descriptor[1] = widths;
            descriptor += shape.DescriptorWords;
        }
    }
}
