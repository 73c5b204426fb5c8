namespace Unity.Mathematics;

public struct float4 : IEquatable<float4>, IFormattable
{
    public float x, y, z, w;

    [MethodImpl(Inline)] public float4(float x, float y, float z, float w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
    [MethodImpl(Inline)] internal float4(double4 v) => (x, y, z, w) = ((float)v.x, (float)v.y, (float)v.z, (float)v.w);
    [MethodImpl(Inline)] internal float4(float3 xyz, float w) => (x, y, z, this.w) = (xyz.x, xyz.y, xyz.z, w);

    [MethodImpl(Inline)] public static explicit operator float4(double4 v) => new(v);
    [MethodImpl(Inline)] public bool Equals(float4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is float4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.asuint(x) * 0xE69626FFu + math.asuint(y) * 0xBD010EEBu +
        math.asuint(z) * 0x9CEDE1D1u + math.asuint(w) * 0x43BE0B51u + 0xAF836EE1u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("float4", "f", format, formatProvider, 4, x, y, z, w);

    public float3 xyz
    {
        [MethodImpl(Inline)]
        get => new float3(x, y, z);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; z = value.z; }
    }
}
