using System;
using FastPoints.Reading;
using FastPoints.Sampling;
using NUnit.Framework;

namespace FastPoints.Tests.Sampling
{
    public class RangePlanTests
    {
        [TestCase(1), TestCase(2), TestCase(1000), TestCase(4096), TestCase(4097)]
        public void Order_AllIndices_VisitEachStratumOnce(int strata)
        {
            var order = new SampleOrder(strata, 7);
            var seen = new bool[strata];
            for (int index = 0; index < order.Length; index++)
            {
                int stratum = order.StratumAt(index);
                if (stratum < 0)
                    continue;
                Assert.That(seen[stratum], Is.False);
                seen[stratum] = true;
            }
            Assert.That(seen, Has.All.True);
        }

        [Test]
        public void Order_FirstIndices_AreSpreadOverTheStrata([Range(0, 12)] int bits)
        {
            var order = new SampleOrder(4096, 3);
            var taken = new int[1 << bits];
            for (int index = 0; index < taken.Length; index++)
                taken[order.StratumAt(index) >> 12 - bits]++;
            Assert.That(taken, Has.All.EqualTo(1));
        }

        [Test]
        public void Order_AnotherSeed_IsAnother()
        {
            SampleOrder one = new SampleOrder(1024, 1), other = new SampleOrder(1024, 2);
            int same = 0;
            for (int index = 0; index < 1024; index++)
                same += one.StratumAt(index) == other.StratumAt(index) ? 1 : 0;
            Assert.That(same, Is.LessThan(100));
        }

        [TestCase(1, 1), TestCase(10, 100), TestCase(1000, 17), TestCase(5003, 5003), TestCase(40_000, 39_999)]
        [TestCase(40_000, 7001), TestCase(1_000_003, 5000)]
        public void Ranges_AnySource_TakeEachPointAtMostOnceAndFillTheSample(int points, int wanted)
        {
            var plan = new RangePlan(points, wanted, 34, 5);
            var taken = new bool[points];
            var filled = new bool[plan.EntryCount];
            int rank = 0, count = 0;
            for (int index = 0; rank < plan.RangeCount; index++)
            {
                int stratum = plan.Order.StratumAt(index);
                if (stratum < 0)
                    continue;
                bool isSplit = plan.RangeOf(stratum, rank++, out var range, out var second);
                Take(range);
                if (!isSplit)
                    continue;
                Assert.That(second.First, Is.GreaterThan(range.Last));
                Take(second);
            }
            int expected = Math.Min(points, wanted);
            Assert.That(count, wanted < points && wanted > points - plan.RangeCount
                ? Is.InRange(expected - plan.RangeCount, expected) : Is.EqualTo(expected));
            Assert.That(plan.EntryCount, Is.InRange(count, expected + plan.RangeCount));

            void Take(FastPoints.Reading.StridedRange range)
            {
                Assert.That(range.Last - range.First, Is.LessThan(plan.MaxSegmentPoints));
                for (int i = 0; i < range.Count; i++)
                {
                    long point = range.First + (long)i * range.Step;
                    Assert.That(taken[point], Is.False);
                    Assert.That(filled[range.FirstInSample + i], Is.False);
                    taken[point] = filled[range.FirstInSample + i] = true;
                    count++;
                }
            }
        }

        // Over many seeds each point of the file is taken as often as every other. The count of a point is binomial; 6 standard
        // deviations leave one false alarm in about 10^5 runs of the test over 2,000 points.
        [TestCase(2000, 100), TestCase(2000, 900), TestCase(4000, 1777)]
        public void Ranges_ManySeeds_TakeEveryPointEquallyOften(int points, int wanted)
        {
            const int Seeds = 2000;
            var count = new int[points];
            for (uint seed = 1; seed <= Seeds; seed++)
            {
                var plan = new RangePlan(points, wanted, 34, seed * 2654435761u);
                int rank = 0;
                for (int index = 0; rank < plan.RangeCount; index++)
                {
                    int stratum = plan.Order.StratumAt(index);
                    if (stratum < 0)
                        continue;
                    bool isSplit = plan.RangeOf(stratum, rank++, out var range, out var second);
                    for (int i = 0; i < range.Count; i++)
                        count[range.First + (long)i * range.Step]++;
                    for (int i = 0; isSplit && i < second.Count; i++)
                        count[second.First + (long)i * second.Step]++;
                }
            }
            // Ranges and strata differ by one point: the share of a stratum is its range's count over its length.
            double share = wanted / (double)points, slack = 0.08 * share;
            double sigma = Math.Sqrt(Seeds * share * (1 - share));
            Assert.That(count, Has.All.InRange(Seeds * (share - slack) - 6 * sigma, Seeds * (share + slack) + 6 * sigma));
        }
    }
}
