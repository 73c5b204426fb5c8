namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inline)] public static double3 mul(double3x3 a, double3 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;
    [MethodImpl(Inline)] public static double3x3 mul(double3x3 a, double3x3 b) => new(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));

    [MethodImpl(Inline)]
    public static double3x3 transpose(double3x3 v) =>
        new double3x3(v.c0.x, v.c0.y, v.c0.z, v.c1.x, v.c1.y, v.c1.z, v.c2.x, v.c2.y, v.c2.z);

    public static double determinant(double3x3 m) =>
        m.c0.x * (m.c1.y * m.c2.z - m.c1.z * m.c2.y) - m.c1.x * (m.c0.y * m.c2.z - m.c0.z * m.c2.y)
            + m.c2.x * (m.c0.y * m.c1.z - m.c0.z * m.c1.y);

    public static double3x3 inverse(double3x3 m)
    {
        double3 r0 = cross(m.c1, m.c2);
        double3 r1 = cross(m.c2, m.c0);
        double3 r2 = cross(m.c0, m.c1);
        double rcpDet = 1.0 / (m.c0.x * r0.x + m.c1.x * r1.x + m.c2.x * r2.x);
        return new double3x3(r0.x, r0.y, r0.z, r1.x, r1.y, r1.z, r2.x, r2.y, r2.z) * rcpDet;
    }

    [MethodImpl(Inline)] public static double4 mul(double4x4 a, double4 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3 * b.w;
}
