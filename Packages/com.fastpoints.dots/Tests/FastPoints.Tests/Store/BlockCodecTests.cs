using System;
using System.Linq;
using FastPoints.Store;
using NUnit.Framework;

namespace FastPoints.Tests.Store
{
    [Category("Smoke")]
    public unsafe class BlockCodecTests
    {
        [Test]
        public void Pack_EveryWidthTo32_ReadsBackTheSame([Range(0, 32)] int width)
        {
            var random = new Random(width);
            foreach (int count in new[] { 1, 2, 31, 32, 33, 127, 128 })
            {
                uint max = width == 0 ? 0 : uint.MaxValue >> (32 - width);
                uint minimum = (uint)random.NextDouble() * (uint.MaxValue - max);
                var values = new uint[count];
                for (int i = 0; i < count; i++)
                    values[i] = minimum + (i == 0 ? 0 : i == 1 ? max : (uint)(random.NextDouble() * max));
                var words = new uint[PlaneShape.WordsOf(count, width) + 2];
                var back = new uint[count];
                fixed (uint* v = values, w = words, b = back)
                {
                    Assert.That(BlockCodec.Pack(v, minimum, count, width, w), Is.EqualTo(PlaneShape.WordsOf(count, width)));
                    BlockCodec.Unpack(w, minimum, count, width, b);
                    for (int i = 0; i < count; i++)
                        Assert.That(BlockCodec.ValueAt(w, minimum, width, i), Is.EqualTo((ulong)values[i]));
                }
                Assert.That(back, Is.EqualTo(values));
                Assert.That(words[words.Length - 1] | words[words.Length - 2], Is.EqualTo(0u), "nothing is written behind");
            }
        }

        [Test]
        public void PackWide_EveryWidthTo64_ReadsBackTheSame([Range(0, 64)] int width)
        {
            var random = new Random(width);
            foreach (int count in new[] { 1, 3, 64, 128 })
            {
                ulong max = width == 0 ? 0 : ulong.MaxValue >> (64 - width);
                ulong minimum = width == 64 ? 0 : (ulong)random.Next(int.MaxValue);
                var values = new ulong[count];
                for (int i = 0; i < count; i++)
                    values[i] = minimum + (i == 0 ? 0 : i == 1 ? max
                        : ((ulong)random.Next() << 33 ^ (ulong)random.Next() << 10) & max);
                var words = new uint[PlaneShape.WordsOf(count, width) + 2];
                var back = new ulong[count];
                fixed (uint* w = words)
                fixed (ulong* v = values, b = back)
                {
                    Assert.That(BlockCodec.PackWide(v, minimum, count, width, w), Is.EqualTo(PlaneShape.WordsOf(count, width)));
                    BlockCodec.UnpackWide(w, minimum, count, width, b);
                    for (int i = 0; i < count; i++)
                        Assert.That(BlockCodec.ValueAt(w, minimum, width, i), Is.EqualTo(values[i]));
                }
                Assert.That(back, Is.EqualTo(values));
            }
        }

        [Test]
        public void PackWide_NarrowValues_WritesTheSameAsPack([Values(1, 7, 17, 31, 32)] int width)
        {
            var random = new Random(width);
            var narrow = new uint[128];
            var wide = new ulong[128];
            for (int i = 0; i < 128; i++)
                wide[i] = narrow[i] = (uint)(random.NextDouble() * (uint.MaxValue >> (32 - width)));
            uint[] a = new uint[4 * width], b = new uint[4 * width];
            fixed (uint* n = narrow, pa = a, pb = b)
            fixed (ulong* w = wide)
            {
                BlockCodec.Pack(n, 0, 128, width, pa);
                BlockCodec.PackWide(w, 0, 128, width, pb);
            }
            Assert.That(b, Is.EqualTo(a));
        }

        /// <summary>Processors have different vectors: the stored bytes must not.</summary>
        [Test]
        public void FindRange_AnyCount_MatchesScalarCode()
        {
            var random = new Random(3);
            for (int count = 1; count <= 128; count++)
            {
                var values = new uint[count];
                for (int i = 0; i < count; i++)
                    values[i] = (uint)random.Next(int.MinValue, int.MaxValue);
                // Each place has the extremes once.
                foreach (int extreme in new[] { 0, count / 3, count - 1 })
                {
                    values[extreme] = extreme % 2 == 0 ? 0 : uint.MaxValue;
                    fixed (uint* v = values)
                    {
                        BlockCodec.FindRange(v, count, out uint min, out uint max);
                        BlockCodec.FindRangePlain(v, count, v[0], v[0], out uint plainMin, out uint plainMax);
                        Assert.That((min, max), Is.EqualTo((plainMin, plainMax)));
                        Assert.That((min, max), Is.EqualTo((values.Min(), values.Max())));
                    }
                }
            }
        }

        [Test]
        public void WidthOf_Extremes_AreZeroAndSixtyFour()
        {
            Assert.That(BlockCodec.WidthOf(0), Is.EqualTo(0));
            Assert.That(BlockCodec.WidthOf(1), Is.EqualTo(1));
            Assert.That(BlockCodec.WidthOf(uint.MaxValue), Is.EqualTo(32));
            Assert.That(BlockCodec.WidthOf(ulong.MaxValue), Is.EqualTo(64));
        }
    }
}
