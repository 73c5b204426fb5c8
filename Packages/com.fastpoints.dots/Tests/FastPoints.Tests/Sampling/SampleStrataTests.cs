using FastPoints.Sampling;
using NUnit.Framework;

namespace FastPoints.Tests.Sampling
{
    public class SampleStrataTests
    {
        [TestCase(10, 3), TestCase(10, 10), TestCase(10, 100), TestCase(1_000_003, 1000)]
        public void Strata_AnyCounts_CoverAllPointsEvenly(long points, int wanted)
        {
            var strata = new SampleStrata(points, wanted, 1);
            Assert.That(strata.Count, Is.EqualTo(wanted < points ? wanted : points));
            Assert.That(strata.FirstOf(0), Is.EqualTo(0));
            Assert.That(strata.FirstOf(strata.Count), Is.EqualTo(points));
            long min = points / strata.Count;
            for (int i = 0; i < strata.Count; i++)
            {
                Assert.That(strata.FirstOf(i + 1) - strata.FirstOf(i), Is.InRange(min, min + 1));
                Assert.That(strata.Chosen(i), Is.InRange(strata.FirstOf(i), strata.FirstOf(i + 1) - 1));
                Assert.That(strata.StratumOf(strata.FirstOf(i)), Is.EqualTo(i));
                Assert.That(strata.StratumOf(strata.FirstOf(i + 1) - 1), Is.EqualTo(i));
            }
        }

        [Test]
        public void Strata_TrillionsOfPoints_DoNotOverflow()
        {
            const long Points = 9_000_000_000_000;
            var strata = new SampleStrata(Points, 2_000_000_000, 1);
            Assert.That(strata.FirstOf(strata.Count), Is.EqualTo(Points));
            foreach (int i in new[] { 0, 1, 999_999_999, 1_999_999_999 })
            {
                Assert.That(strata.StratumOf(strata.Chosen(i)), Is.EqualTo(i));
                Assert.That(strata.FirstOf(i), Is.EqualTo(i * 4500L));
            }
        }

        [Test]
        public void Strata_NoPoints_AreNone()
        {
            Assert.That(new SampleStrata(0, 10, 1).Count, Is.EqualTo(0));
            Assert.That(new SampleStrata(-1, 10, 1).Count, Is.EqualTo(0));
        }

        [Test]
        public void Chosen_ManyStrata_AreUniformWithinThem()
        {
            // 100 positions in each of 20,000 strata: chi-square with 99 degrees of freedom exceeds 148 once in a thousand.
            var strata = new SampleStrata(2_000_000, 20_000, 12345);
            var hits = new int[100];
            for (int i = 0; i < strata.Count; i++)
                hits[strata.Chosen(i) - strata.FirstOf(i)]++;
            double chiSquare = 0;
            foreach (int hit in hits)
                chiSquare += (hit - 200.0) * (hit - 200.0) / 200.0;
            Assert.That(chiSquare, Is.LessThan(148));
        }
    }
}
