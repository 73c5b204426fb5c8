using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Store
{
    internal unsafe struct PlaneView
    {
        [NativeDisableUnsafePtrRestriction] public uint* Words;
        public PlaneShape Shape;
        public int BlockCount;

        public PlaneView(void* bytes, PlaneShape shape, int blockCount)
        {
            Words = (uint*)bytes;
            Shape = shape;
            BlockCount = blockCount;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public uint* Descriptor(int block) => Words + (long)block * Shape.DescriptorWords;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int PointsOf(int block) => (int)(Descriptor(block)[1] >> 24) + 1;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public int WidthOf(int block, int column) => (int)(Descriptor(block)[1] >> (column * 8) & 0xFF);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public ulong MinimumOf(int block, int column)
        {
            uint* minimum = Descriptor(block) + Shape.MinimumWord(column);
            return Shape.IsWide(column) ? minimum[0] | (ulong)minimum[1] << 32 : minimum[0];
        }

        public void Unpack(int block, int column, uint* values) =>
            BlockCodec.Unpack(Packed(block, column), (uint)MinimumOf(block, column), PointsOf(block), WidthOf(block, column),
                values);

        public void UnpackWide(int block, int column, ulong* values) =>
            BlockCodec.UnpackWide(Packed(block, column), MinimumOf(block, column), PointsOf(block), WidthOf(block, column),
                values);

        public void UnpackWide(int block, int column, int first, int count, ulong* values)
        {
            uint* words = Packed(block, column);
            ulong minimum = MinimumOf(block, column);
            int width = WidthOf(block, column);
            BlockCodec.UnpackWide(words, minimum, first, count, width, values);
        }

        // Of three columns of up to 32 bits, from the block's smallest values; those of a column begin a stride after those
        // before. Word by word, as BlockCodec.OffsetAt, for ARMv7.
        public void UnpackOffsets(int block, int first, int count, uint* offsets, int stride)
        {
            uint* words = Words + Descriptor(block)[0];
            for (int column = 0; column < 3; column++, offsets += stride)
            {
                int width = WidthOf(block, column), bit = first * width;
                uint mask = (uint)((1UL << width) - 1);
                for (int i = 0; i < count; i++, bit += width)
                {
                    uint* at = words + (bit >> 5);
                    offsets[i] = (uint)((at[0] | (ulong)at[1] << 32) >> (bit & 31)) & mask;
                }
                words += PlaneShape.WordsOf(PointsOf(block), width);
            }
        }

        // On one axis, counted from where the node's corner counts from.
        public void UnpackPositions(int block, int axis, long corner, int first, int count, long* to)
        {
            UnpackWide(block, axis, first, count, (ulong*)to);
            for (int i = 0; i < count; i++)
                to[i] += corner;
        }

        public ulong ValueAt(int block, int column, int index) =>
            BlockCodec.ValueAt(Packed(block, column), MinimumOf(block, column), WidthOf(block, column), index);

        uint* Packed(int block, int column)
        {
            uint* descriptor = Descriptor(block);
            uint widths = descriptor[1];
            int points = (int)(widths >> 24) + 1;
            long word = descriptor[0];
            for (int c = 0; c < column; c++)
                word += PlaneShape.WordsOf(points, (int)(widths >> (c * 8) & 0xFF));
            return Words + word;
        }

        // Whether every block's descriptor and words lie inside the plane, one after the other, with widths that its columns
        // can have. Check this for everything read from disk before unpacking it.
        public static bool IsValid(void* bytes, long lengthBytes, PlaneShape shape, int blockCount)
        {
            long descriptorWords = (long)blockCount * shape.DescriptorWords;
            if (blockCount < 0 || lengthBytes % PlaneShape.AlignmentBytes != 0 ||
                PlaneShape.LengthBytes(descriptorWords) > lengthBytes)
                return false;
            uint max0 = MaxWidth(shape, 0), max1 = MaxWidth(shape, 1), max2 = MaxWidth(shape, 2);
            long word = descriptorWords;
            bool isWrong = false;
            // Without a branch: it runs for everything that is uploaded.
            uint* descriptor = (uint*)bytes;
            for (int block = 0; block < blockCount; block++, descriptor += shape.DescriptorWords)
            {
                uint widths = descriptor[1], width0 = widths & 0xFF, width1 = widths >> 8 & 0xFF, width2 = widths >> 16 & 0xFF;
                uint points = (widths >> 24) + 1;
                isWrong |= descriptor[0] != word | points > PlaneShape.MaxPointsPerBlock | width0 > max0 | width1 > max1 |
                    width2 > max2;
                word += ((points * width0 + 31) >> 5) + ((points * width1 + 31) >> 5) + ((points * width2 + 31) >> 5);
            }
            return !isWrong && PlaneShape.LengthBytes(word) == lengthBytes;
        }

        static uint MaxWidth(PlaneShape shape, int column) =>
            column >= shape.ColumnCount ? 0u : shape.IsWide(column) ? 64u : 32u;
    }

    /// <summary>Writes a plane from gathered values, block by block: the layout of <see cref="PlaneShape"/>.</summary>
    internal unsafe struct BlockWriter
    {
        public readonly uint* Plane;
        readonly PlaneShape m_shape;
        uint* m_descriptor;

        public BlockWriter(uint* plane, PlaneShape shape, int firstBlock, long word)
        {
            Plane = plane;
            m_shape = shape;
            m_descriptor = plane + (long)firstBlock * shape.DescriptorWords;
            Word = word;
        }

        public long Word { get; private set; } // The plane's word after the packed ones.

        /// <summary>Where a column of 64-bit values is gathered.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static ulong* WideOf(ulong* values, int column) => values + column * PlaneShape.MaxPointsPerBlock;

        /// <summary>Where a column of 32-bit values is gathered.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static uint* NarrowOf(ulong* values, int column) => (uint*)values + column * PlaneShape.MaxPointsPerBlock;

        /// <param name="values">The values, with room for <see cref="PlaneShape.MaxColumns"/> full columns.</param>
        /// <param name="min">For each column, lowered to the block's smallest; <paramref name="max"/> raised to its
        /// largest.</param>
        public void Write(ulong* values, int count, ulong* min, ulong* max)
        {
            var shape = m_shape;
            uint* plane = Plane, descriptor = m_descriptor;
            long word = Word;
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
            m_descriptor = descriptor + shape.DescriptorWords;
            Word = word;
        }

        // A block of another plane of this shape, as it is.
        public void Copy(in PlaneView from, int block)
        {
            uint* source = from.Descriptor(block);
            long words = 0;
            for (int c = 0; c < m_shape.ColumnCount; c++)
                words += PlaneShape.WordsOf(from.PointsOf(block), from.WidthOf(block, c));
            UnsafeUtility.MemCpy(m_descriptor, source, m_shape.DescriptorWords * sizeof(uint));
            UnsafeUtility.MemCpy(Plane + Word, from.Words + source[0], words * sizeof(uint));
            m_descriptor[0] = (uint)Word;
            m_descriptor += m_shape.DescriptorWords;
            Word += words;
        }

        /// <summary>Clears the padding.</summary>
        /// <returns>Its length in bytes.</returns>
        public long End()
        {
            long length = PlaneShape.LengthBytes(Word);
            UnsafeUtility.MemClear(Plane + Word, length - Word * sizeof(uint));
            return length;
        }
    }
}
