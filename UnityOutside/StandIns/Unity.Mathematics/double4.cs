namespace Unity.Mathematics;

public struct double4 : IEquatable<double4>, IFormattable
{
    public double x, y, z, w;

    [MethodImpl(Inline)]
    public double4(double x, double y, double z, double w) => (this.x, this.y, this.z, this.w) = (x, y, z, w);
    [MethodImpl(Inline)] public double4(double3 xyz, double w) => (x, y, z, this.w) = (xyz.x, xyz.y, xyz.z, w);
    [MethodImpl(Inline)] internal double4(float4 v) => (x, y, z, w) = (v.x, v.y, v.z, v.w);

    [MethodImpl(Inline)] public static implicit operator double4(float4 v) => new(v);
    [MethodImpl(Inline)]
    public static double4 operator +(double4 lhs, double4 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);
    [MethodImpl(Inline)]
    public static double4 operator *(double4 lhs, double rhs) => new double4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);
    [MethodImpl(Inline)]
    public static double4 operator -(double4 lhs, double4 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);

    public unsafe double this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (double* first = &x) return first[Components.Checked(index, 4)]; }
        [MethodImpl(Inline)]
        set { fixed (double* first = &x) first[Components.Checked(index, 4)] = value; }
    }

    [MethodImpl(Inline)] public bool Equals(double4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;
    public override bool Equals(object o) => o is double4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.fold_to_uint(x) * 0x9F1C739Bu + math.fold_to_uint(y) * 0x4B1BD187u +
        math.fold_to_uint(z) * 0x9DF50593u + math.fold_to_uint(w) * 0xF18EEB85u + 0x9E19BFC3u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("double4", "", format, formatProvider, 4, x, y, z, w);

    public double3 xyz
    {
        [MethodImpl(Inline)]
        get => new double3(x, y, z);
        [MethodImpl(Inline)]
        set { x = value.x; y = value.y; z = value.z; }
    }
}
