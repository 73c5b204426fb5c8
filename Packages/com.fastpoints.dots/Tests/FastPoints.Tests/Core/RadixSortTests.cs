using System.Linq;
using NUnit.Framework;

namespace FastPoints.Tests.Core
{
    [Category("Smoke")]
    public class RadixSortTests
    {
        static ulong[] Keys(int count, ulong mask, ulong set, uint seed)
        {
            var random = new Unity.Mathematics.Random(seed);
            var keys = new ulong[count];
            for (int i = 0; i < count; i++)
                keys[i] = (((ulong)random.NextUInt() << 32 | random.NextUInt()) & mask) | set;
            return keys;
        }

        [TestCase(0, ulong.MaxValue, 0UL)]
        [TestCase(1, ulong.MaxValue, 0UL)]
        [TestCase(2, ulong.MaxValue, 0UL)]
        [TestCase(5000, ulong.MaxValue, 0UL)]
        [TestCase(5000, 0x7UL, 0UL)]
        [TestCase(5000, 0x00FF00000000FF00UL, 0x8000000000000001UL)]
        [TestCase(5000, 0xFF0000UL, 0UL)]
        [TestCase(5000, 0UL, 42UL)]
        public unsafe void Sort_AnyKeys_OrdersThemStably(int count, ulong mask, ulong set)
        {
            var keys = Keys(count, mask, set, 3);
            var indices = Enumerable.Range(0, count).Select(i => (uint)i).OrderBy(i => keys[i]).ToArray();
            var sorted = (ulong[])keys.Clone();
            var payload = Enumerable.Range(0, count).Select(i => (uint)i).ToArray();
            fixed (ulong* at = sorted, scratch = new ulong[count])
            fixed (uint* payloadAt = payload, payloadScratch = new uint[count])
                RadixSort.Sort(at, payloadAt, scratch, payloadScratch, count);
            Assert.That(payload, Is.EqualTo(indices));
            Assert.That(sorted, Is.EqualTo(indices.Select(i => keys[i]).ToArray()));
        }

        [Test]
        public unsafe void Sort_KeysAlone_NeedsNoPayload()
        {
            var keys = Keys(1000, ulong.MaxValue, 0, 5);
            var expected = keys.OrderBy(key => key).ToArray();
            var scratch = new ulong[keys.Length];
            fixed (ulong* at = keys)
            fixed (ulong* scratchAt = scratch)
                RadixSort.Sort(at, null, scratchAt, null, keys.Length);
            Assert.That(keys, Is.EqualTo(expected));
        }
    }
}
