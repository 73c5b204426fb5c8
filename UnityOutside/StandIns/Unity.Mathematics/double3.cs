namespace Unity.Mathematics;

public struct double3 : IEquatable<double3>, IFormattable
{
    public double x, y, z;

    [MethodImpl(Inline)] internal double3(double v) => x = y = z = v;
    [MethodImpl(Inline)] public double3(double x, double y, double z) => (this.x, this.y, this.z) = (x, y, z);
    [MethodImpl(Inline)] public double3(int v) => x = y = z = v;
    [MethodImpl(Inline)] public double3(float v) => x = y = z = v;
    [MethodImpl(Inline)] public double3(uint v) => x = y = z = v;
    [MethodImpl(Inline)] public double3(double2 xy, double z) => (x, y, this.z) = (xy.x, xy.y, z);
    [MethodImpl(Inline)] public double3(float3 v) => (x, y, z) = (v.x, v.y, v.z);
    [MethodImpl(Inline)] public double3(int3 v) => (x, y, z) = (v.x, v.y, v.z);

    [MethodImpl(Inline)] public static implicit operator double3(double v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double3(int v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double3(float v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double3(uint v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double3(float3 v) => new(v);
    [MethodImpl(Inline)] public static implicit operator double3(int3 v) => new(v);
    [MethodImpl(Inline)] public static double3 operator +(double lhs, double3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);
    [MethodImpl(Inline)] public static double3 operator +(double3 lhs, double rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);
    [MethodImpl(Inline)]
    public static double3 operator +(double3 lhs, double3 rhs) => new double3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);
    [MethodImpl(Inline)] public static double3 operator /(double lhs, double3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);
    [MethodImpl(Inline)] public static double3 operator /(double3 lhs, double rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);
    [MethodImpl(Inline)]
    public static double3 operator /(double3 lhs, double3 rhs) => new double3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator ==(double lhs, double3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator ==(double3 lhs, double rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);
    [MethodImpl(Inline)]
    public static bool3 operator ==(double3 lhs, double3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);
    [MethodImpl(Inline)] public static bool3 operator >(double lhs, double3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);
    [MethodImpl(Inline)] public static bool3 operator >(double3 lhs, double rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);
    [MethodImpl(Inline)]
    public static bool3 operator >(double3 lhs, double3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator >=(double lhs, double3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator >=(double3 lhs, double rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);
    [MethodImpl(Inline)]
    public static bool3 operator >=(double3 lhs, double3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator !=(double lhs, double3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator !=(double3 lhs, double rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);
    [MethodImpl(Inline)]
    public static bool3 operator !=(double3 lhs, double3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);
    [MethodImpl(Inline)] public static bool3 operator <(double lhs, double3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);
    [MethodImpl(Inline)] public static bool3 operator <(double3 lhs, double rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);
    [MethodImpl(Inline)]
    public static bool3 operator <(double3 lhs, double3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator <=(double lhs, double3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);
    [MethodImpl(Inline)]
    public static bool3 operator <=(double3 lhs, double rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);
    [MethodImpl(Inline)]
    public static bool3 operator <=(double3 lhs, double3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);
    [MethodImpl(Inline)] public static double3 operator *(double lhs, double3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);
    [MethodImpl(Inline)] public static double3 operator *(double3 lhs, double rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);
    [MethodImpl(Inline)]
    public static double3 operator *(double3 lhs, double3 rhs) => new double3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);
    [MethodImpl(Inline)] public static double3 operator -(double lhs, double3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);
    [MethodImpl(Inline)] public static double3 operator -(double3 lhs, double rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);
    [MethodImpl(Inline)]
    public static double3 operator -(double3 lhs, double3 rhs) => new double3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);
    [MethodImpl(Inline)] public static double3 operator -(double3 val) => new(-val.x, -val.y, -val.z);

    public unsafe double this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (double* first = &x) return first[Components.Checked(index, 3)]; }
        [MethodImpl(Inline)]
        set { fixed (double* first = &x) first[Components.Checked(index, 3)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(double3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;
    public override bool Equals(object o) => o is double3 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.fold_to_uint(x) * 0xAF0F3103u + math.fold_to_uint(y) * 0xE4A056C7u +
        math.fold_to_uint(z) * 0x841D8225u + 0xC9393C7Du);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("double3", "", format, formatProvider, 3, x, y, z);

    public double2 xy
    {
        [MethodImpl(Inline)]
        get => new double2(x, y);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; }
    }

    public double2 xz
    {
        [MethodImpl(Inline)]
        get => new double2(x, z);
        [MethodImpl(Inline)]
        set { x = value.x; z = value.y; }
    }

    public double2 yz
    {
        [MethodImpl(Inline)]
        get => new double2(y, z);
        [MethodImpl(Inline)]
        set { y = value.x; z = value.y; }
    }

    internal double3 yzx
    {
        [MethodImpl(Inline)]
        get => new double3(y, z, x);
    }
}
