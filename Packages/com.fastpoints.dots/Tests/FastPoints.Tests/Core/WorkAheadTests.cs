using System.Threading;
using FastPoints.Core;
using NUnit.Framework;

namespace FastPoints.Tests.Core
{
    public class WorkAheadTests
    {
        [Test]
        public void Resume_IdleAgainAndAgain_DoublesUpToTheMost()
        {
            var ahead = new WorkAhead(3, 20, () => double.PositiveInfinity);
            foreach (int wanted in new[] { 6, 12, 20, 20 })
            {
                ahead.Await();
                Thread.Sleep(3);
                ahead.Resume(true);
                Assert.That(ahead.Count, Is.EqualTo(wanted));
            }
        }

        [Test]
        public void Resume_NotIdle_StaysAsItIs()
        {
            var ahead = new WorkAhead(3, 20, () => double.PositiveInfinity);
            ahead.Await();
            Thread.Sleep(3);
            ahead.Resume(false);
            Assert.That(ahead.Count, Is.EqualTo(3));
        }

        [Test]
        public void Resume_IdleAfterLongerThanPlanned_StaysAsItIs()
        {
            var ahead = new WorkAhead(3, 20, () => 2.5);
            ahead.Await();
            Thread.Sleep(5);
            ahead.Resume(true);
            Assert.That(ahead.Count, Is.EqualTo(3));
        }

        [TestCase(5, 2, 2), TestCase(0, 9, 1), TestCase(5, 0, 1)]
        public void Count_AtFirst_IsWithinItsLimits(int first, int most, int wanted) =>
            Assert.That(new WorkAhead(first, most, () => 1).Count, Is.EqualTo(wanted));
    }
}
