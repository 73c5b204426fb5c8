using System.Collections.Generic;
using FastPoints.Reading;
using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.Tests.Reading
{
    public class UnreadPagesTests
    {
        static UnreadPages Some()
        {
            var pages = new UnreadPages(10);
            pages.Add(new int4(0, 0, 0, 0), 1);
            pages.Add(new int4(3, 3, 3, 2), 2);
            pages.Add(new int4(0, 1, 0, 2), 3);
            pages.Add(new int4(1, 1, 1, 1), 4);
            pages.Add(new int4(13, 12, 15, 4), 5);
            return pages;
        }

        static List<long> TakeAll(UnreadPages pages, int4 node, int levels)
        {
            var taken = new List<long>();
            while (pages.TryPeek(node, levels, out var page))
            {
                taken.Add(page.Offset);
                pages.Remove(page);
            }
            return taken;
        }

        [Test]
        public void TryPeek_Root_ReturnsLevelByLevelInOrderOfAddition()
        {
            var pages = Some();
            Assert.That(TakeAll(pages, default, 2), Is.EqualTo(new[] { 1, 4 }));
            Assert.That(pages.Count, Is.EqualTo(3));
            Assert.That(TakeAll(pages, default, 10), Is.EqualTo(new[] { 2, 3, 5 }));
            Assert.That(pages.Count, Is.Zero);
        }

        [Test]
        public void TryPeek_Node_ReturnsPagesAboveAndBelow()
        {
            var pages = Some();
            Assert.That(TakeAll(pages, new int4(6, 6, 7, 3), 10), Is.EqualTo(new[] { 1, 4, 2, 5 }));
            Assert.That(pages.TryPeek(new int4(6, 6, 7, 3), 10, out _), Is.False);
            Assert.That(TakeAll(pages, default, 10), Is.EqualTo(new[] { 3 }));
        }

        [Test]
        public void TryPeek_PagesReadEarly_AreNotReturnedAgain()
        {
            var pages = Some();
            Assert.That(TakeAll(pages, new int4(0, 1, 0, 2), 10), Is.EqualTo(new[] { 1, 3 }));
            pages.Add(new int4(0, 1, 0, 2), 6);
            Assert.That(pages.Count, Is.EqualTo(4));
            Assert.That(TakeAll(pages, default, 10), Is.EqualTo(new[] { 4, 2, 6, 5 }));
            pages.Add(default, 7);
            pages.Clear();
            Assert.That(pages.Count, Is.Zero);
            Assert.That(pages.TryPeek(default, 10, out _), Is.False);
        }
    }
}
