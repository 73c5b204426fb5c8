using System.Threading;
using NUnit.Framework;

namespace FastPoints.Tests.Core
{
    public class InFlightLimitTests
    {
        [Test]
        public void EndWait_IdleRepeatedly_DoublesUpToTheMaximum()
        {
            var limit = new InFlightLimit(3, 20, () => double.PositiveInfinity);
            foreach (int wanted in new[] { 6, 12, 20, 20 })
            {
                limit.BeginWait();
                Thread.Sleep(3);
                limit.EndWait(true);
                Assert.That(limit.Value, Is.EqualTo(wanted));
            }
        }

        [Test]
        public void EndWait_NotIdle_IsUnchanged()
        {
            var limit = new InFlightLimit(3, 20, () => double.PositiveInfinity);
            limit.BeginWait();
            Thread.Sleep(3);
            limit.EndWait(false);
            Assert.That(limit.Value, Is.EqualTo(3));
        }

        [Test]
        public void EndWait_IdleAfterLongerThanPlanned_IsUnchanged()
        {
            var limit = new InFlightLimit(3, 20, () => 2.5);
            limit.BeginWait();
            Thread.Sleep(5);
            limit.EndWait(true);
            Assert.That(limit.Value, Is.EqualTo(3));
        }

        [TestCase(5, 2, 2), TestCase(0, 9, 1), TestCase(5, 0, 1)]
        public void Count_AtFirst_IsWithinItsLimits(int first, int max, int wanted) =>
            Assert.That(new InFlightLimit(first, max, () => 1).Value, Is.EqualTo(wanted));
    }
}
