namespace UnityOutside.Tests.Mathematics;

public sealed class VectorTests
{
    [Test]
    public void Operators_OnVectors_WorkByComponent()
    {
        var a = new int3(7, -8, 9);
        var b = new uint4 { x = 6, y = 3, z = 0, w = 5 };
        var c = new double3(2, 3, -4);

        Assert.That(a + new int3(2, 3, -4), Is.EqualTo(new int3(9, -5, 5)));
        Assert.That(a * 2, Is.EqualTo(new int3(14, -16, 18)));
        Assert.That(a % 3, Is.EqualTo(new int3(1, -2, 0)));
        Assert.That(a >> 1, Is.EqualTo(new int3(3, -4, 4)));
        Assert.That(new int2(7, -8) << 1, Is.EqualTo(new int2(14, -16)));
        Assert.That((~b).x, Is.EqualTo(~6u));
        Assert.That((~b | b).w, Is.EqualTo(uint.MaxValue));
        Assert.That(b == 3, Is.EqualTo(new bool4(false, true, false, false)));
        Assert.That(c / 2, Is.EqualTo(new double3(1, 1.5, -2)));
        Assert.That(-c, Is.EqualTo(new double3(-2, -3, 4)));
        Assert.That(c > new double3(1, 3, -5), Is.EqualTo(new bool3(true, false, true)));
    }

    [Test]
    public void HashCode_OfEachType_MatchesUnity()
    {
        var codes = new (object Of, uint Code)[]
        {
            (new bool2(true, false), 0x57C8E9B2), (new bool3(true, false, true), 0xD865353F),
            (new bool4(true, false, false, true), 0x9CD39CEE), (new int2(7, -8), 0x29DDB7F8),
            (new int3(1, 2, 3), 0xAF2D05FF), (new int4(1, -2, 3, int.MinValue), 0xC7389875), (new uint2(7, 8), 0xA48B429E),
            (new uint3(1, 2, uint.MaxValue), 0xBE8B99A1), (new uint4 { x = 1, y = 2, z = 3, w = 4 }, 0xCBAEE859),
            (new float2(1, -2), 0x9A5D5341), (new float3(0, 0, 1.5f), 0x7E9513F9), (new float3(0, -0.0f, 1.5f), 0xFE9513F9),
            (new float4(1, 2, 3, 4), 0x4CC36EE1), (new double2(0.1, -1), 0xB5ECB90C),
            (new double3(0.1, -1, 1e300), 0x89721BA6), (new double4(1, 2, 3, 4), 0xC951BFC3),
            (new double3x3(1, 0, 0, 0, 1, 0, 0, 0, 1), 0xAEC0D005),
            (double4x4.identity, 0xF352ADE1), (float4x4.identity, 0x52F7230F),
        };
        foreach ((object of, uint code) in codes)
            Assert.That((uint)of.GetHashCode(), Is.EqualTo(code), of.ToString());
    }

    [Test]
    public void Conversions_BetweenTypes_TruncateAndWiden()
    {
        double3 widened = new int3(1, 2, 3);
        var truncated = (int3)new float3(1.9f, -1.9f, 2.5f);
        double3 doubled = new float3(0.5f, 0.25f, 0);

        Assert.That(widened, Is.EqualTo(new double3(1, 2, 3)));
        Assert.That(truncated, Is.EqualTo(new int3(1, -1, 2)));
        Assert.That(doubled, Is.EqualTo(new double3(0.5, 0.25, 0)));
        Assert.That((float3)new double3(0.1, 1e300, -1e-300), Is.EqualTo(new float3(0.1f, float.PositiveInfinity, 0)));
        Assert.That(new float3(new float2(1, 2), 3), Is.EqualTo(new float3(1, 2, 3)));
    }

    [Test]
    public void Swizzles_ReadAndWritten_KeepTheirOrder()
    {
        var v = new double3(1, 2, 3);
        v.yz = new double2(8, 9);

        Assert.That(v, Is.EqualTo(new double3(1, 8, 9)));
        Assert.That(v.xz, Is.EqualTo(new double2(1, 9)));
        Assert.That(new float4(1, 2, 3, 4).xyz, Is.EqualTo(new float3(1, 2, 3)));
    }

    [Test]
    public void Indexer_EachComponent_ReadsAndWritesIt()
    {
        var v = new double3(1, 2, 3);
        v[1] = 5;

        Assert.That(v, Is.EqualTo(new double3(1, 5, 3)));
        Assert.That(v[2], Is.EqualTo(3));
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    [Test]
    public void Indexer_OutOfRange_Throws() => Assert.That(() => new float3(1, 2, 3)[3], Throws.ArgumentException);
#endif

    [Test]
    public void ToString_OfVectors_MatchesUnity()
    {
        Assert.That(new float2(1.5f, 2).ToString("R", CultureInfo.InvariantCulture), Is.EqualTo("float2(1.5f, 2f)"));
        Assert.That(new int3(1, 2, 3).ToString(), Is.EqualTo("int3(1, 2, 3)"));
    }

    [Test]
    public unsafe void Layout_OfVectors_HasNoGaps()
    {
        Assert.That(sizeof(float3), Is.EqualTo(12));
        Assert.That(sizeof(double3), Is.EqualTo(24));
        Assert.That(sizeof(bool3), Is.EqualTo(3));
        Assert.That(sizeof(float4x4), Is.EqualTo(64));
    }

    [Test]
    public void GetHashCode_EqualVectors_IsEqual() =>
        Assert.That(new int3(1, 2, 3).GetHashCode(), Is.EqualTo(new int3(1, 2, 3).GetHashCode()));
}
