using System.Numerics;

namespace UnityOutside.Tests.Mathematics;

public sealed class MathTests
{
    [Test]
    public void MinMax_WithNaN_ReturnTheNumber()
    {
        Assert.That(math.min(float.NaN, 1.0f), Is.EqualTo(1.0f));
        Assert.That(math.min(1.0f, float.NaN), Is.EqualTo(1.0f));
        Assert.That(math.max(double.NaN, 1.0), Is.EqualTo(1.0));
        Assert.That(math.max(1.0, double.NaN), Is.EqualTo(1.0));
        Assert.That(math.min(float.NaN, float.NaN), Is.NaN);
        Assert.That(math.cmin(new float3(float.NaN, 1, 2)), Is.EqualTo(1.0f));
        Assert.That(math.cmax(new double3(double.NaN, -1, -2)), Is.EqualTo(-1.0));
    }

    [Test]
    public void Clamp_NaN_IsTheUpperBound()
    {
        Assert.That(math.clamp(float.NaN, -1, 3), Is.EqualTo(3.0f));
        Assert.That(math.clamp(double.NaN, -1, 3), Is.EqualTo(3.0));
        Assert.That(math.clamp(new double3(double.NaN, -9, 9), -1, 3), Is.EqualTo(new double3(3, -1, 3)));
        Assert.That(math.clamp(5, -1, 3), Is.EqualTo(3));
        Assert.That(math.saturate(new float3(-2, 0.5f, float.NaN)), Is.EqualTo(new float3(0, 0.5f, 1)));
    }

    [Test]
    public void Normalize_OfTooShortVectors_IsNaNOrTheDefault()
    {
        var up = new float3(0, 0, 1);

        Assert.That(math.normalize(float3.zero).x, Is.NaN);
        Assert.That(math.normalizesafe(float3.zero, up), Is.EqualTo(up));
        Assert.That(math.normalizesafe(new float3(1e-30f, 0, 0), up), Is.EqualTo(up));
        Assert.That(math.normalizesafe(new float3(1.1e-19f, 0, 0), up), Is.EqualTo(new float3(1, 0, 0)));
    }

    [TestCase(0.5f, 0.0f)]
    [TestCase(1.5f, 2.0f)]
    [TestCase(2.5f, 2.0f)]
    [TestCase(-0.5f, -0.0f)]
    [TestCase(-1.5f, -2.0f)]
    [TestCase(0.49999997f, 0.0f)]
    [TestCase(8388609.0f, 8388609.0f)]
    public void Round_Halves_GoToEven(float x, float rounded)
    {
        Assert.That(math.round(x), Is.EqualTo(rounded));
        Assert.That(math.round((double)x), Is.EqualTo((double)rounded));
    }

    [TestCase(0, 0)]
    [TestCase(-5, 0)]
    [TestCase(1 << 30, 1 << 30)]
    [TestCase((1 << 30) + 1, int.MinValue)]
    public void CeilPow2_AtTheLimits_Wraps(int x, int ceiling) => Assert.That(math.ceilpow2(x), Is.EqualTo(ceiling));

    [Test]
    public void Transcendentals_OfFloats_AreRoundedDoubles()
    {
        for (float x = 0.1f; x < 40; x += 0.7f)
        {
            Assert.That(math.sin(x), Is.EqualTo((float)Math.Sin(x)));
            Assert.That(math.exp(x), Is.EqualTo((float)Math.Exp(x)));
            Assert.That(math.log(x), Is.EqualTo((float)Math.Log(x)));
            Assert.That(math.pow(x, 0.3f), Is.EqualTo((float)Math.Pow(x, 0.3f)));
            Assert.That(math.atan2(x, 2), Is.EqualTo((float)Math.Atan2(x, 2)));
        }
    }

    [Test]
    public void Frac_OfNegative_IsUpFromTheFloor()
    {
        Assert.That(math.floor(-1.25f), Is.EqualTo(-2.0f));
        Assert.That(math.frac(-1.25f), Is.EqualTo(0.75f));
        Assert.That(math.ceil(-1.25), Is.EqualTo(-1.0));
    }

    [Test]
    public void Bits_OfRandomNumbers_MatchTheCount()
    {
        var random = new System.Random(7);
        for (int i = 0; i < 1000; i++)
        {
            ulong x = (ulong)random.NextInt64() >> random.Next(64);
            Assert.That(math.lzcnt(x), Is.EqualTo(BitOperations.LeadingZeroCount(x)));
            Assert.That(math.tzcnt(x), Is.EqualTo(BitOperations.TrailingZeroCount(x)));
            Assert.That(math.countbits(x), Is.EqualTo(BitOperations.PopCount(x)));
            Assert.That(math.lzcnt((uint)x), Is.EqualTo(BitOperations.LeadingZeroCount((uint)x)));
            Assert.That(math.rol((uint)x, 13), Is.EqualTo(BitOperations.RotateLeft((uint)x, 13)));
            Assert.That(math.ror((uint)x, 5), Is.EqualTo(BitOperations.RotateRight((uint)x, 5)));
        }
        Assert.That(math.lzcnt(0), Is.EqualTo(32));
        Assert.That(math.tzcnt(0), Is.EqualTo(32));
        Assert.That(math.lzcnt(0ul), Is.EqualTo(64));
        Assert.That(math.tzcnt(0ul), Is.EqualTo(64));
    }

    [Test]
    public void Reinterpretation_RoundTrip_KeepsTheBits()
    {
        Assert.That(math.asuint(1.0f), Is.EqualTo(0x3F800000u));
        Assert.That(math.asuint(math.asfloat(0xFFC12345u)), Is.EqualTo(0xFFC12345u));
        Assert.That(math.asdouble(math.asulong(-0.1)), Is.EqualTo(-0.1));
    }

    [Test]
    public void Finiteness_OfSpecialNumbers_IsReported()
    {
        Assert.That(math.isfinite(new double3(1, double.NaN, double.PositiveInfinity)),
            Is.EqualTo(new bool3(true, false, false)));
        Assert.That(math.isfinite(float.NegativeInfinity), Is.False);
    }

    [Test]
    public void Select_ByMask_TakesTheSecondIfTrue()
    {
        Assert.That(math.select(1u, 2u, true), Is.EqualTo(2u));
        Assert.That(math.select(new float3(1, 1, 1), new float3(2, 2, 2), new bool3(true, false, true)),
            Is.EqualTo(new float3(2, 1, 2)));
        Assert.That(math.any(new bool3(false, false, true)), Is.True);
        Assert.That(math.all(new bool4(true, true, true, false)), Is.False);
        Assert.That(math.cmin(new int3(4, -2, 7)), Is.EqualTo(-2));
        Assert.That(math.cmax(new double3(4, -2, 7)), Is.EqualTo(7.0));
        Assert.That(math.csum(new int3(1, 2, 3)), Is.EqualTo(6));
    }

    [Test]
    public void Geometry_OfSmallVectors_MatchesByHand()
    {
        var a = new double3(1, 2, 3);
        var b = new double3(-4, 5, 6);

        Assert.That(math.dot(a, b), Is.EqualTo(24.0));
        Assert.That(math.cross(a, b), Is.EqualTo(new double3(-3, -18, 13)));
        Assert.That(math.length(new double2(3, 4)), Is.EqualTo(5.0));
        Assert.That(math.distancesq(a, b), Is.EqualTo(43.0));
        Assert.That(math.length(math.normalize(a)), Is.EqualTo(1.0).Within(1e-12));
        Assert.That(math.lerp(new float3(0, 10, 1), new float3(10, 20, 1), 0.25f), Is.EqualTo(new float3(2.5f, 12.5f, 1)));
        Assert.That(math.sign(new float3(-2, 0, 3)), Is.EqualTo(new float3(-1, 0, 1)));
    }

    [Test]
    public void Transcendentals_OfDoubles_MatchDotNet()
    {
        Assert.That(math.sin(0.7), Is.EqualTo(Math.Sin(0.7)));
        Assert.That(math.pow(2.5, 1.5), Is.EqualTo(Math.Pow(2.5, 1.5)));
        Assert.That(math.exp2(new double3(3, 0, 0)).x, Is.EqualTo(8.0).Within(1e-12));
        Assert.That(math.log2(8.0f), Is.EqualTo(3.0f));
        math.sincos(0.3, out double s, out double c);
        Assert.That(s * s + c * c, Is.EqualTo(1.0).Within(1e-12));
    }
}
