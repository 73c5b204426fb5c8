using NUnit.Framework;
using Unity.Mathematics;

namespace FastPoints.HostTests.Mathematics
{
    public sealed class RandomTests
    {
        [Test]
        public void State_AfterSeedOne_IsXorshifts() => Assert.That(new Random(1).state, Is.EqualTo(270369u));

        [Test]
        public void Numbers_OfAnyKind_StayInRange()
        {
            var random = Random.CreateFromIndex(5);
            for (int i = 0; i < 10000; i++)
            {
                Assert.That(random.NextInt(-3, 4), Is.InRange(-3, 3));
                Assert.That(random.NextUInt(7), Is.LessThan(7u));
                Assert.That(random.NextFloat(), Is.GreaterThanOrEqualTo(0.0f).And.LessThan(1.0f));
                Assert.That(random.NextDouble(2, 3), Is.GreaterThanOrEqualTo(2.0).And.LessThan(3.0));
            }
        }

        [Test]
        public void Mean_OfManyFloats_IsHalf()
        {
            var random = new Random(99);
            double sum = 0;
            for (int i = 0; i < 100000; i++)
                sum += random.NextFloat();

            Assert.That(sum / 100000, Is.EqualTo(0.5).Within(0.01));
        }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
        [Test]
        public void Constructor_SeedZero_Throws() => Assert.That(() => new Random(0), Throws.ArgumentException);
#endif
    }
}
