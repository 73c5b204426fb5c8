namespace Unity.Mathematics;

public struct int2 : IEquatable<int2>, IFormattable
{
    public int x, y;

    [MethodImpl(Inline)] internal int2(int v) => x = y = v;
    [MethodImpl(Inline)] public int2(int x, int y) => (this.x, this.y) = (x, y);
    [MethodImpl(Inline)] internal int2(float2 v) => (x, y) = ((int)v.x, (int)v.y);

    [MethodImpl(Inline)] public static explicit operator int2(float2 v) => new(v);
    [MethodImpl(Inline)] public static implicit operator int2(int v) => new(v);
    [MethodImpl(Inline)] public static int2 operator +(int lhs, int2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(Inline)] public static int2 operator +(int2 lhs, int rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(Inline)] public static int2 operator +(int2 lhs, int2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(Inline)] public static int2 operator /(int2 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(Inline)] public static bool2 operator >(int2 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(Inline)] public static int2 operator <<(int2 x, int n) => new(x.x << n, x.y << n);
    [MethodImpl(Inline)] public static bool2 operator <(int2 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(Inline)] public static int2 operator -(int2 lhs, int rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(Inline)] public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is int2 converted && Equals(converted);
    public override int GetHashCode() => (int)((uint)x * 0x83B58237u + (uint)y * 0x833E3E29u + 0xA9D919BFu);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("int2", "", format, formatProvider, 2, x, y);
}
