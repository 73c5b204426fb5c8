using Random = Unity.Mathematics.Random;

namespace UnityOutside.Tests.Mathematics;

public sealed class RandomTests
{
    [Test]
    public void State_AfterSeedOne_MatchesXorshift() => Assert.That(new Random(1).state, Is.EqualTo(270369u));

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

    [Test]
    public void Numbers_OfExtremeStates_AreTheRangeLimits()
    {
        var random = new Random(1) { state = uint.MaxValue };

        Assert.That(random.NextFloat(), Is.EqualTo(0.9999999f));
        Assert.That(random.state, Is.EqualTo(0x3E01Fu));
        random.state = uint.MaxValue;
        Assert.That(random.NextFloat(1000000, 1000001), Is.EqualTo(1000001.0f), "rounds up to the excluded end");
        random.state = uint.MaxValue;
        Assert.That(random.NextInt(-5, 5), Is.EqualTo(4));
        Assert.That(Random.CreateFromIndex(7).state, Is.EqualTo(4287286566u));
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    [Test]
    public void Constructor_SeedZero_Throws() => Assert.That(() => new Random(0), Throws.ArgumentException);

    [Test]
    public void NextInt_OfEmptyRange_Throws()
    {
        Assert.That(() => new Random(1).NextInt(-1), Throws.ArgumentException);
        Assert.That(() => new Random(1).NextInt(3, 2), Throws.ArgumentException);
        Assert.That(() => new Random(1).NextInt3(new int3(1, 1, -1)), Throws.ArgumentException);
        Assert.That(new Random(1).NextInt(3, 3), Is.EqualTo(3));
    }
#endif
}
