namespace Unity.Mathematics;

public struct double2 : IEquatable<double2>, IFormattable
{
    public double x, y;

    [MethodImpl(Inline)] public double2(double x, double y) => (this.x, this.y) = (x, y);
    [MethodImpl(Inline)] internal double2(int v) => x = y = v;
    [MethodImpl(Inline)] internal double2(double v) => x = y = v;
    [MethodImpl(Inline)] internal double2(float v) => x = y = v;
    [MethodImpl(Inline)] internal double2(uint v) => x = y = v;

    [MethodImpl(Inline)] public static implicit operator double2(int v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double2(double v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double2(float v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double2(uint v) => new(v);
    [MethodImpl(Inline)] public static double2 operator +(double lhs, double2 rhs) => new(lhs + rhs.x, lhs + rhs.y);
    [MethodImpl(Inline)] public static double2 operator +(double2 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs);
    [MethodImpl(Inline)] public static double2 operator +(double2 lhs, double2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);
    [MethodImpl(Inline)] public static double2 operator /(double2 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs);
    [MethodImpl(Inline)] public static bool2 operator >(double2 lhs, double rhs) => new(lhs.x > rhs, lhs.y > rhs);
    [MethodImpl(Inline)] public static bool2 operator >=(double lhs, double2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);
    [MethodImpl(Inline)] public static bool2 operator >=(double2 lhs, double rhs) => new(lhs.x >= rhs, lhs.y >= rhs);
    [MethodImpl(Inline)] public static bool2 operator >=(double2 lhs, double2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);
    [MethodImpl(Inline)] public static bool2 operator <(double2 lhs, double rhs) => new(lhs.x < rhs, lhs.y < rhs);
    [MethodImpl(Inline)] public static bool2 operator <=(double lhs, double2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);
    [MethodImpl(Inline)] public static bool2 operator <=(double2 lhs, double rhs) => new(lhs.x <= rhs, lhs.y <= rhs);
    [MethodImpl(Inline)] public static bool2 operator <=(double2 lhs, double2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);
    [MethodImpl(Inline)] public static double2 operator *(double lhs, double2 rhs) => new(lhs * rhs.x, lhs * rhs.y);
    [MethodImpl(Inline)] public static double2 operator *(double2 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs);
    [MethodImpl(Inline)] public static double2 operator *(double2 lhs, double2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);
    [MethodImpl(Inline)] public static double2 operator -(double lhs, double2 rhs) => new(lhs - rhs.x, lhs - rhs.y);
    [MethodImpl(Inline)] public static double2 operator -(double2 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs);
    [MethodImpl(Inline)] public static double2 operator -(double2 lhs, double2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);
    [MethodImpl(Inline)] public bool Equals(double2 rhs) => x == rhs.x && y == rhs.y;
    public override bool Equals(object o) => o is double2 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.fold_to_uint(x) * 0x9536A0F5u + math.fold_to_uint(y) * 0xAF816615u + 0x9AF8D62Du);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("double2", "", format, formatProvider, 2, x, y);
}
