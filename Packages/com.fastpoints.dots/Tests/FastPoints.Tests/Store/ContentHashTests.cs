using System;
using System.Linq;
using System.Text;
using FastPoints.Store;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Store
{
    public unsafe class ContentHashTests
    {
        // Published results of XXH64 with seed 0.
        [TestCase("", 0xEF46DB3751D8E999UL)]
        [TestCase("a", 0xD24EC4F1A98C6E5BUL)]
        [TestCase("abc", 0x44BC2CF5AD770999UL)]
        [TestCase("Nobody inspects the spammish repetition", 0xFBCEA83C8A378BF1UL)]
        public void Of_KnownText_GivesThePublishedHash(string text, ulong wanted)
        {
            byte[] bytes = Encoding.ASCII.GetBytes(text + "?");
            fixed (byte* b = bytes)
                Assert.That(ContentHash.Of(b, text.Length), Is.EqualTo(wanted));
        }

        [Test]
        public void CopyAndHash_AnyLength_CopiesAndGivesTheHash()
        {
            var random = new System.Random(5);
            var from = new byte[400];
            random.NextBytes(from);
            for (int length = 0; length < 300; length++)
            {
                var to = new byte[400];
                var wanted = new byte[400];
                Array.Copy(from, 3, wanted, 5, length);
                fixed (byte* f = from, t = to)
                    Assert.That(ContentHash.CopyAndHash(t + 5, f + 3, length), Is.EqualTo(ContentHash.Of(f + 3, length)));
                Assert.That(to, Is.EqualTo(wanted));
            }
        }

        [Test]
        public void RecordHash_AnyBitOfAnyWord_ChangesHalfOfTheBits([Values(0, 4, 8, 12, 24)] int attributeBytes,
            [Values(RecordHash.ChecksumSeed, RecordHash.SecondSeed)] ulong seed)
        {
            var random = new System.Random(7);
            int bits = 8 * (24 + attributeBytes);
            var changed = new long[bits];
            const int Records = 400;
            long* record = stackalloc long[6];
            for (int n = 0; n < Records; n++)
            {
                // Neighbours on a map, with small values.
                record[0] = 50000000 + random.Next(1 << 17);
                record[1] = 450000000 + random.Next(1 << 17);
                record[2] = random.Next(1 << 12);
                record[3] = record[4] = record[5] = 0;
                for (int b = 0; b < attributeBytes; b += 2)
                    ((byte*)(record + 3))[b] = (byte)random.Next(256);
                ulong before = HashOf(record, attributeBytes, seed);
                for (int bit = 0; bit < bits; bit++)
                {
                    record[bit / 64] ^= 1L << (bit & 63);
                    changed[bit] += math.countbits(before ^ HashOf(record, attributeBytes, seed));
                    record[bit / 64] ^= 1L << (bit & 63);
                }
            }
            for (int bit = 0; bit < bits; bit++)
                Assert.That(changed[bit] / (double)Records, Is.EqualTo(32).Within(1.5), "bit " + bit);
        }

        /// <summary>Points in a lattice, or on a vertical line. The lowest priorities are chosen, so they must be
        /// random.</summary>
        [Test]
        public void RecordHash_OneColumn_SpreadsTheLowestPriorities([Values(0, 4, 8)] int attributeBytes)
        {
            long* record = stackalloc long[6];
            for (int column = 0; column < 100; column++)
            {
                record[0] = 1000 + 7 * column;
                record[1] = 2000 - column;
                var priorities = new (ulong Hash, int Z)[1024];
                int different = 0;
                for (int z = 0; z < priorities.Length; z++)
                {
                    record[2] = z;
                    priorities[z] = (HashOf(record, attributeBytes, RecordHash.ChecksumSeed), z);
                    different += math.countbits(priorities[z].Hash ^ HashOf(record, attributeBytes, RecordHash.SecondSeed));
                }
                Assert.That(different / 1024.0, Is.EqualTo(32).Within(1), "bits by which two seeds differ");
                var chosen = priorities.OrderBy(p => p.Hash).Take(64).Select(p => p.Z).OrderBy(z => z).ToArray();
                Assert.That(chosen.Zip(chosen.Skip(1), (a, b) => b - a).Distinct().Count(), Is.InRange(20, 45));
            }
        }

        static ulong HashOf(long* record, int attributeBytes, ulong seed) =>
            RecordHash.Of(new Grid3(record[0], record[1], record[2]), (byte*)(record + 3), attributeBytes, seed);
    }
}
