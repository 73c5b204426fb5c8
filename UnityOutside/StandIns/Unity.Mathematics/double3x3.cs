namespace Unity.Mathematics;

public struct double3x3 : IEquatable<double3x3>, IFormattable
{
    public double3 c0, c1, c2;

    public static readonly double3x3 identity = new double3x3(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);

    [MethodImpl(Inline)] public double3x3(double3 c0, double3 c1, double3 c2) => (this.c0, this.c1, this.c2) = (c0, c1, c2);
    [MethodImpl(Inline)]
    public double3x3(
        double m00, double m01, double m02,
        double m10, double m11, double m12,
        double m20, double m21, double m22) =>
        (c0, c1, c2) = (new double3(m00, m10, m20), new double3(m01, m11, m21), new double3(m02, m12, m22));

    [MethodImpl(Inline)]
    public static double3x3 operator *(double3x3 lhs, double rhs) => new double3x3(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);

    public unsafe ref double3 this[int index]
    {
        [MethodImpl(Inline)]
        get { fixed (double3x3* array = &this) return ref ((double3*)array)[Components.Checked(index, 3)]; }
    }

    public bool Equals(double3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);
    public override bool Equals(object o) => o is double3x3 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.fold_to_uint(c0.x) * 0xAC5DB57Bu + math.fold_to_uint(c0.y) * 0xA91A02EDu + math.fold_to_uint(c0.z) * 0xB3C49313u +
        math.fold_to_uint(c1.x) * 0xF43A9ABBu + math.fold_to_uint(c1.y) * 0x84E7E01Bu +
        math.fold_to_uint(c1.z) * 0x8E055BE5u +
        math.fold_to_uint(c2.x) * 0x6E624EB7u + math.fold_to_uint(c2.y) * 0x7383ED49u +
        math.fold_to_uint(c2.z) * 0xDD49C23Bu + 0xEBD0D005u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("double3x3", "", format, formatProvider, 3, c0.x, c1.x, c2.x, c0.y, c1.y, c2.y, c0.z, c1.z, c2.z);
}
