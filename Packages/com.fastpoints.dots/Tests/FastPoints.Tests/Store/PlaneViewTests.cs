using FastPoints.Store;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    public unsafe class PlaneViewTests
    {
        [TestCase(1, 0), TestCase(2, 0), TestCase(3, 0), TestCase(3, 7), TestCase(3, 2)]
        public void IsValid_AnyBitOfAnyDescriptor_FollowsTheRules(int columns, int wide)
        {
            var shape = new PlaneShape(columns, wide);
            var random = new Random(11);
            const int Blocks = 5;
            var words = new uint[4096];
            long word = Blocks * shape.DescriptorWords;
            for (int block = 0; block < Blocks; block++)
            {
                int points = block == Blocks - 1 ? 77 : 128;
                words[block * shape.DescriptorWords] = (uint)word;
                uint widths = (uint)(points - 1) << 24;
                for (int c = 0; c < columns; c++)
                {
                    int width = random.NextInt(shape.IsWide(c) ? 65 : 33);
                    widths |= (uint)width << 8 * c;
                    word += PlaneShape.WordsOf(points, width);
                }
                words[block * shape.DescriptorWords + 1] = widths;
            }
            long length = PlaneShape.LengthBytes(word);
            fixed (uint* plane = words)
            {
                Assert.That(PlaneView.IsValid(plane, length, shape, Blocks), Is.True);
                Assert.That(PlaneView.IsValid(plane, length - 16, shape, Blocks), Is.False);
                Assert.That(PlaneView.IsValid(plane, length + 16, shape, Blocks), Is.False);
                Assert.That(PlaneView.IsValid(plane, length - 4, shape, Blocks), Is.False);
                Assert.That(PlaneView.IsValid(plane, length, shape, Blocks + 1), Is.False);
                Assert.That(PlaneView.IsValid(plane, length, shape, Blocks - 1), Is.False);
                for (int bit = 0; bit < Blocks * shape.DescriptorWords * 32; bit++)
                {
                    plane[bit >> 5] ^= 1u << (bit & 31);
                    Assert.That(PlaneView.IsValid(plane, length, shape, Blocks),
                        Is.EqualTo(IsSound(plane, length, shape, Blocks)), "bit " + bit);
                    plane[bit >> 5] ^= 1u << (bit & 31);
                }
            }
        }

        static bool IsSound(uint* plane, long length, PlaneShape shape, int blocks)
        {
            long word = (long)blocks * shape.DescriptorWords;
            for (int block = 0; block < blocks; block++)
            {
                uint* descriptor = plane + block * shape.DescriptorWords;
                int points = (int)(descriptor[1] >> 24) + 1;
                if (descriptor[0] != word || points > PlaneShape.MaxPointsPerBlock)
                    return false;
                for (int c = 0; c < PlaneShape.MaxColumns; c++)
                {
                    int width = (int)(descriptor[1] >> 8 * c & 0xFF);
                    if (width > (c >= shape.ColumnCount ? 0 : shape.IsWide(c) ? 64 : 32))
                        return false;
                    word += PlaneShape.WordsOf(points, width);
                }
            }
            return PlaneShape.LengthBytes(word) == length;
        }
    }
}
