using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;

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
}
