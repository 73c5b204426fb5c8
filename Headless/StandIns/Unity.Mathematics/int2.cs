namespace Unity.Mathematics;

public struct int2 : IEquatable<int2>, IFormattable
{
    public int x, y;

    [MethodImpl(Inlining.Always)] internal int2(int v) => x = y = v;
    [MethodImpl(Inlining.Always)] public int2(int x, int y) => (this.x, this.y) = (x, y);
    [MethodImpl(Inlining.Always)] internal int2(float2 v) => (x, y) = ((int)v.x, (int)v.y);

    [MethodImpl(Inlining.Always)] public static explicit operator int2(float2 v) => new int2(v);
    [MethodImpl(Inlining.Always)] public static implicit operator int2(int v) => new int2(v);
    [MethodImpl(Inlining.Always)] public static int2 operator +(int lhs, int2 rhs) => new int2(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(Inlining.Always)] public static int2 operator +(int2 lhs, int rhs) => new int2(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(Inlining.Always)] public static int2 operator +(int2 lhs, int2 rhs) => new int2(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(Inlining.Always)] public static int2 operator /(int2 lhs, int rhs) => new int2(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(Inlining.Always)] public static bool2 operator >(int2 lhs, int rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(Inlining.Always)] public static int2 operator <<(int2 x, int n) => new int2(x.x << n, x.y << n);
    [MethodImpl(Inlining.Always)] public static bool2 operator <(int2 lhs, int rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(Inlining.Always)] public static int2 operator -(int2 lhs, int rhs) => new int2(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(Inlining.Always)] public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is int2 converted && Equals(converted);
    public override int GetHashCode() => (int)((uint)x * 0x83B58237u + (uint)y * 0x833E3E29u + 0xA9D919BFu);
    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("int2", "", format, formatProvider, 2, x, y);
}
