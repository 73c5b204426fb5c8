namespace Unity.Mathematics;

public struct float2 : IEquatable<float2>, IFormattable
{
    public float x, y;

    [MethodImpl(Inline)] internal float2(int v) => x = y = v;
    [MethodImpl(Inline)] internal float2(float v) => x = y = v;
    [MethodImpl(Inline)] internal float2(uint v) => x = y = v;
    [MethodImpl(Inline)] public float2(float x, float y) => (this.x, this.y) = (x, y);

    [MethodImpl(Inline)] public static implicit operator float2(int v) => new(v);
    [MethodImpl(Inline)] public static implicit operator float2(float v) => new(v);
    [MethodImpl(Inline)] public static implicit operator float2(uint v) => new(v);
    [MethodImpl(Inline)] public static float2 operator +(float lhs, float2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(Inline)] public static float2 operator +(float2 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(Inline)] public static float2 operator +(float2 lhs, float2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(Inline)] public static float2 operator /(float2 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(Inline)] public static float2 operator *(float lhs, float2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(Inline)] public static float2 operator *(float2 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(Inline)] public static float2 operator *(float2 lhs, float2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(Inline)] public static float2 operator -(float lhs, float2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(Inline)] public static float2 operator -(float2 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(Inline)] public static float2 operator -(float2 lhs, float2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(Inline)] public static float2 operator -(float2 val) => new(-val.x, -val.y);
    [MethodImpl(Inline)] public bool Equals(float2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is float2 converted && Equals(converted);
    public override int GetHashCode() => (int)(math.asuint(x) * 0xFA3A3285u + math.asuint(y) * 0xAD55999Du + 0xDCDD5341u);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("float2", "f", format, formatProvider, 2, x, y);
}
