namespace Unity.Mathematics;

public struct double4x4 : IEquatable<double4x4>, IFormattable
{
    public double4 c0, c1, c2, c3;

    public static readonly double4x4 identity = new double4x4(
        new double4(1, 0, 0, 0), new double4(0, 1, 0, 0), new double4(0, 0, 1, 0), new double4(0, 0, 0, 1));

    [MethodImpl(Inline)]
    public double4x4(double4 c0, double4 c1, double4 c2, double4 c3) => (this.c0, this.c1, this.c2, this.c3) = (c0, c1, c2, c3);
    [MethodImpl(Inline)] public double4x4(float4x4 v) => (c0, c1, c2, c3) = (v.c0, v.c1, v.c2, v.c3);

    public bool Equals(double4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);
    public override bool Equals(object o) => o is double4x4 converted && Equals(converted);

    public override int GetHashCode() => (int)(
        math.fold_to_uint(c0.x) * 0x4DDC6509u + math.fold_to_uint(c0.y) * 0x7CF083CBu +
        math.fold_to_uint(c0.z) * 0x5C4D6CEDu + math.fold_to_uint(c0.w) * 0xF9137117u +
        math.fold_to_uint(c1.x) * 0xE857DCE1u + math.fold_to_uint(c1.y) * 0xF62213C5u +
        math.fold_to_uint(c1.z) * 0x9CDAA959u + math.fold_to_uint(c1.w) * 0xAA269ABFu +
        math.fold_to_uint(c2.x) * 0xD54BA36Fu + math.fold_to_uint(c2.y) * 0xFD0847B9u +
        math.fold_to_uint(c2.z) * 0x8189A683u + math.fold_to_uint(c2.w) * 0xB139D651u +
        math.fold_to_uint(c3.x) * 0xE7579997u + math.fold_to_uint(c3.y) * 0xEF7D56C7u +
        math.fold_to_uint(c3.z) * 0x66F38F0Bu + math.fold_to_uint(c3.w) * 0x624256A3u + 0x5292ADE1u);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        VectorText.Of("double4x4", "", format, formatProvider, 4,
            c0.x, c1.x, c2.x, c3.x,
            c0.y, c1.y, c2.y, c3.y,
            c0.z, c1.z, c2.z, c3.z,
            c0.w, c1.w, c2.w, c3.w);
}
