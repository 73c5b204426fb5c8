using System;
using System.Collections.Generic;
using FastPoints.Reading;
using NUnit.Framework;

namespace FastPoints.Tests.Reading
{
    [Category("Smoke")]
    public class SlotRingTests
    {
        [TestCase(3, 10)]
        [TestCase(3, 2)]
        [TestCase(1, 3)]
        [TestCase(0, 0)]
        public void Run_AnyNumberOfItems_EndsEachOnceInOrder(int slots, int items)
        {
            var inFlight = new Dictionary<int, int>();
            var ended = new List<int>();
            int max = 0;
            JobCoroutine.RunToEnd(SlotRing.Run(slots, items, (slot, thing) =>
            {
                inFlight.Add(slot, thing);
                max = Math.Max(max, inFlight.Count);
                return default;
            }, slot =>
            {
                ended.Add(inFlight[slot]);
                inFlight.Remove(slot);
            }));
            Assert.That(ended, Is.EqualTo(System.Linq.Enumerable.Range(0, items)));
            Assert.That(max, Is.EqualTo(Math.Min(slots, items)));
        }

        [Test]
        public void Slots_OfARing_AreTakenInTurn()
        {
            var ring = new SlotRing(2);
            Assert.That(new[] { ring.Begin(), ring.Begin(), ring.End(), ring.Begin(), ring.End(), ring.Oldest },
                Is.EqualTo(new[] { 0, 1, 0, 0, 1, 0 }));
        }

        [Test]
        public void Misuse_OfARing_Throws()
        {
            var ring = new SlotRing(1);
            Assert.That(() => ring.End(), Throws.InvalidOperationException.With.Message.EqualTo(SlotRing.NotInFlight));
            Assert.That(() => ring.Oldest, Throws.InvalidOperationException.With.Message.EqualTo(SlotRing.NotInFlight));
            ring.Begin();
            Assert.That(ring.IsFull);
            Assert.That(() => ring.Begin(), Throws.InvalidOperationException.With.Message.EqualTo(SlotRing.InFlight));
            ring.End();
            Assert.That(ring.IsEmpty);
        }
    }
}
