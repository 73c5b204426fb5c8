using FastPoints.Sampling;
using NUnit.Framework;

namespace FastPoints.Tests.Sampling
{
    public class ReadStrategyTests
    {
        const long LargeBytes = 4L << 30;

        [Test]
        public void Pace_SlowReads_AreFewerLongerAndMoreAtOnce()
        {
            ReadStrategy quick = ReadStrategy.Of(100e-6, LargeBytes), slow = ReadStrategy.Of(10e-3, LargeBytes);
            Assert.That(quick.IsSlow, Is.False);
            Assert.That(slow.IsSlow, Is.True);
            Assert.That(slow.PointsPerRange, Is.EqualTo(8 * quick.PointsPerRange));
            Assert.That(slow.Slots, Is.GreaterThan(quick.Slots));
            Assert.That(slow.RangesPerRequest(16, slow.Slots, 4, 256), Is.EqualTo(1));
            Assert.That(slow.GapBytes(5e-3), Is.GreaterThan(quick.GapBytes(5e-3)));
        }

        [Test]
        public void Pace_SmallSource_IsTheDefault() => Assert.That(ReadStrategy.Of(10e-3, 1 << 20).IsSlow, Is.False);

        [Test]
        public void GapBytes_SlowerReads_AreLarger()
        {
            var pace = ReadStrategy.Of(0, LargeBytes);
            Assert.That(pace.GapBytes(0), Is.EqualTo(512));
            Assert.That(pace.GapBytes(1e-4), Is.EqualTo(20_000));
            Assert.That(pace.GapBytes(1), Is.EqualTo(256 << 10));
        }
    }
}
