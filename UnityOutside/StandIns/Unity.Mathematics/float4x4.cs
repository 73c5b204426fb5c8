namespace Unity.Mathematics;

public struct float4x4 : IEquatable<float4x4>, IFormattable
{
    public float4 c0, c1, c2, c3;

    public static readonly float4x4 identity = new float4x4(
        new float4(1, 0, 0, 0), new float4(0, 1, 0, 0), new float4(0, 0, 1, 0), new float4(0, 0, 0, 1));

    [MethodImpl(Inline)]
    public float4x4(float4 c0, float4 c1, float4 c2, float4 c3) => (this.c0, this.c1, this.c2, this.c3) = (c0, c1, c2, c3);

    public static float4x4 Translate(float3 vector) => new float4x4(
        new float4(1, 0, 0, 0), new float4(0, 1, 0, 0), new float4(0, 0, 1, 0), new float4(vector, 1));

    public bool Equals(float4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);
    public override bool Equals(object o) => o is float4x4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.asuint(c0.x) * 0xC4B1493Fu + math.asuint(c0.y) * 0xBA0966D3u +
        math.asuint(c0.z) * 0xAFBEE253u + math.asuint(c0.w) * 0x5B419C01u +
        math.asuint(c1.x) * 0x515D90F5u + math.asuint(c1.y) * 0xEC9F68F3u +
        math.asuint(c1.z) * 0xF9EA92D5u + math.asuint(c1.w) * 0xC2FAFCB9u +
        math.asuint(c2.x) * 0x616E9CA1u + math.asuint(c2.y) * 0xC5C5394Bu +
        math.asuint(c2.z) * 0xCAE78587u + math.asuint(c2.w) * 0x7A1541C9u +
        math.asuint(c3.x) * 0xF83BD927u + math.asuint(c3.y) * 0x6A243BCBu +
        math.asuint(c3.z) * 0x509B84C9u + math.asuint(c3.w) * 0x91D13847u + 0x52F7230Fu);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("float4x4", "f", format, formatProvider, 4,
            c0.x, c1.x, c2.x, c3.x,
            c0.y, c1.y, c2.y, c3.y,
            c0.z, c1.z, c2.z, c3.z,
            c0.w, c1.w, c2.w, c3.w);
}
