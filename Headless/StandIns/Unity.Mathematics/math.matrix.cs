// A plain reading of Unity's signatures, one line a component.
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static float3 mul(float3x3 a, float3 b) =>
            a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;

        [MethodImpl(Inlining.Always)]
        public static float3 mul(float3 a, float3x3 b) =>
            new float3(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2));

        [MethodImpl(Inlining.Always)]
        public static float3x3 mul(float3x3 a, float3x3 b) =>
            new float3x3(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));

        [MethodImpl(Inlining.Always)]
        public static float3x3 transpose(float3x3 v) =>
            new float3x3(
                v.c0.x, v.c0.y, v.c0.z,
                v.c1.x, v.c1.y, v.c1.z,
                v.c2.x, v.c2.y, v.c2.z);

        public static float determinant(float3x3 m) =>
            m.c0.x * (m.c1.y * m.c2.z - m.c1.z * m.c2.y) - m.c1.x * (m.c0.y * m.c2.z - m.c0.z * m.c2.y)
                + m.c2.x * (m.c0.y * m.c1.z - m.c0.z * m.c1.y);

        public static float3x3 inverse(float3x3 m)
        {
            float3 r0 = cross(m.c1, m.c2);
            float3 r1 = cross(m.c2, m.c0);
            float3 r2 = cross(m.c0, m.c1);
            float rcpDet = 1.0f / (m.c0.x * r0.x + m.c1.x * r1.x + m.c2.x * r2.x);
            return new float3x3(
                r0.x, r0.y, r0.z,
                r1.x, r1.y, r1.z,
                r2.x, r2.y, r2.z) * rcpDet;
        }

        [MethodImpl(Inlining.Always)]
        public static float4 mul(float4x4 a, float4 b) =>
            a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3 * b.w;

        [MethodImpl(Inlining.Always)]
        public static float4 mul(float4 a, float4x4 b) =>
            new float4(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2), dot(a, b.c3));

        [MethodImpl(Inlining.Always)]
        public static float4x4 mul(float4x4 a, float4x4 b) =>
            new float4x4(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2), mul(a, b.c3));

        [MethodImpl(Inlining.Always)]
        public static float4x4 transpose(float4x4 v) =>
            new float4x4(
                v.c0.x, v.c0.y, v.c0.z, v.c0.w,
                v.c1.x, v.c1.y, v.c1.z, v.c1.w,
                v.c2.x, v.c2.y, v.c2.z, v.c2.w,
                v.c3.x, v.c3.y, v.c3.z, v.c3.w);

        // 2x2 minors of the first two columns (s) and of the last two (t), after Laplace.
        public static float determinant(float4x4 m)
        {
            float s0 = m.c0.x * m.c1.y - m.c0.y * m.c1.x;
            float s1 = m.c0.x * m.c1.z - m.c0.z * m.c1.x;
            float s2 = m.c0.x * m.c1.w - m.c0.w * m.c1.x;
            float s3 = m.c0.y * m.c1.z - m.c0.z * m.c1.y;
            float s4 = m.c0.y * m.c1.w - m.c0.w * m.c1.y;
            float s5 = m.c0.z * m.c1.w - m.c0.w * m.c1.z;
            float t0 = m.c2.x * m.c3.y - m.c2.y * m.c3.x;
            float t1 = m.c2.x * m.c3.z - m.c2.z * m.c3.x;
            float t2 = m.c2.x * m.c3.w - m.c2.w * m.c3.x;
            float t3 = m.c2.y * m.c3.z - m.c2.z * m.c3.y;
            float t4 = m.c2.y * m.c3.w - m.c2.w * m.c3.y;
            float t5 = m.c2.z * m.c3.w - m.c2.w * m.c3.z;
            return s0 * t5 - s1 * t4 + s2 * t3 + s3 * t2 - s4 * t1 + s5 * t0;
        }

        public static float4x4 inverse(float4x4 m)
        {
            float s0 = m.c0.x * m.c1.y - m.c0.y * m.c1.x;
            float s1 = m.c0.x * m.c1.z - m.c0.z * m.c1.x;
            float s2 = m.c0.x * m.c1.w - m.c0.w * m.c1.x;
            float s3 = m.c0.y * m.c1.z - m.c0.z * m.c1.y;
            float s4 = m.c0.y * m.c1.w - m.c0.w * m.c1.y;
            float s5 = m.c0.z * m.c1.w - m.c0.w * m.c1.z;
            float t0 = m.c2.x * m.c3.y - m.c2.y * m.c3.x;
            float t1 = m.c2.x * m.c3.z - m.c2.z * m.c3.x;
            float t2 = m.c2.x * m.c3.w - m.c2.w * m.c3.x;
            float t3 = m.c2.y * m.c3.z - m.c2.z * m.c3.y;
            float t4 = m.c2.y * m.c3.w - m.c2.w * m.c3.y;
            float t5 = m.c2.z * m.c3.w - m.c2.w * m.c3.z;
            float rcpDet = 1.0f / (s0 * t5 - s1 * t4 + s2 * t3 + s3 * t2 - s4 * t1 + s5 * t0);
            float4 r0 = new float4(m.c1.y * t5 - m.c1.z * t4 + m.c1.w * t3,
                m.c0.z * t4 - m.c0.y * t5 - m.c0.w * t3,
                m.c3.y * s5 - m.c3.z * s4 + m.c3.w * s3,
                m.c2.z * s4 - m.c2.y * s5 - m.c2.w * s3);
            float4 r1 = new float4(m.c1.z * t2 - m.c1.x * t5 - m.c1.w * t1,
                m.c0.x * t5 - m.c0.z * t2 + m.c0.w * t1,
                m.c3.z * s2 - m.c3.x * s5 - m.c3.w * s1,
                m.c2.x * s5 - m.c2.z * s2 + m.c2.w * s1);
            float4 r2 = new float4(m.c1.x * t4 - m.c1.y * t2 + m.c1.w * t0,
                m.c0.y * t2 - m.c0.x * t4 - m.c0.w * t0,
                m.c3.x * s4 - m.c3.y * s2 + m.c3.w * s0,
                m.c2.y * s2 - m.c2.x * s4 - m.c2.w * s0);
            float4 r3 = new float4(m.c1.y * t1 - m.c1.x * t3 - m.c1.z * t0,
                m.c0.x * t3 - m.c0.y * t1 + m.c0.z * t0,
                m.c3.y * s1 - m.c3.x * s3 - m.c3.z * s0,
                m.c2.x * s3 - m.c2.y * s1 + m.c2.z * s0);
            return new float4x4(r0 * rcpDet, r1 * rcpDet, r2 * rcpDet, r3 * rcpDet);
        }

        [MethodImpl(Inlining.Always)]
        public static double3 mul(double3x3 a, double3 b) =>
            a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;

        [MethodImpl(Inlining.Always)]
        public static double3 mul(double3 a, double3x3 b) =>
            new double3(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2));

        [MethodImpl(Inlining.Always)]
        public static double3x3 mul(double3x3 a, double3x3 b) =>
            new double3x3(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));

        [MethodImpl(Inlining.Always)]
        public static double3x3 transpose(double3x3 v) =>
            new double3x3(
                v.c0.x, v.c0.y, v.c0.z,
                v.c1.x, v.c1.y, v.c1.z,
                v.c2.x, v.c2.y, v.c2.z);

        public static double determinant(double3x3 m) =>
            m.c0.x * (m.c1.y * m.c2.z - m.c1.z * m.c2.y) - m.c1.x * (m.c0.y * m.c2.z - m.c0.z * m.c2.y)
                + m.c2.x * (m.c0.y * m.c1.z - m.c0.z * m.c1.y);

        public static double3x3 inverse(double3x3 m)
        {
            double3 r0 = cross(m.c1, m.c2);
            double3 r1 = cross(m.c2, m.c0);
            double3 r2 = cross(m.c0, m.c1);
            double rcpDet = 1.0 / (m.c0.x * r0.x + m.c1.x * r1.x + m.c2.x * r2.x);
            return new double3x3(
                r0.x, r0.y, r0.z,
                r1.x, r1.y, r1.z,
                r2.x, r2.y, r2.z) * rcpDet;
        }

        [MethodImpl(Inlining.Always)]
        public static double4 mul(double4x4 a, double4 b) =>
            a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3 * b.w;

        [MethodImpl(Inlining.Always)]
        public static double4 mul(double4 a, double4x4 b) =>
            new double4(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2), dot(a, b.c3));

        [MethodImpl(Inlining.Always)]
        public static double4x4 mul(double4x4 a, double4x4 b) =>
            new double4x4(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2), mul(a, b.c3));

        [MethodImpl(Inlining.Always)]
        public static double4x4 transpose(double4x4 v) =>
            new double4x4(
                v.c0.x, v.c0.y, v.c0.z, v.c0.w,
                v.c1.x, v.c1.y, v.c1.z, v.c1.w,
                v.c2.x, v.c2.y, v.c2.z, v.c2.w,
                v.c3.x, v.c3.y, v.c3.z, v.c3.w);

        // 2x2 minors of the first two columns (s) and of the last two (t), after Laplace.
        public static double determinant(double4x4 m)
        {
            double s0 = m.c0.x * m.c1.y - m.c0.y * m.c1.x;
            double s1 = m.c0.x * m.c1.z - m.c0.z * m.c1.x;
            double s2 = m.c0.x * m.c1.w - m.c0.w * m.c1.x;
            double s3 = m.c0.y * m.c1.z - m.c0.z * m.c1.y;
            double s4 = m.c0.y * m.c1.w - m.c0.w * m.c1.y;
            double s5 = m.c0.z * m.c1.w - m.c0.w * m.c1.z;
            double t0 = m.c2.x * m.c3.y - m.c2.y * m.c3.x;
            double t1 = m.c2.x * m.c3.z - m.c2.z * m.c3.x;
            double t2 = m.c2.x * m.c3.w - m.c2.w * m.c3.x;
            double t3 = m.c2.y * m.c3.z - m.c2.z * m.c3.y;
            double t4 = m.c2.y * m.c3.w - m.c2.w * m.c3.y;
            double t5 = m.c2.z * m.c3.w - m.c2.w * m.c3.z;
            return s0 * t5 - s1 * t4 + s2 * t3 + s3 * t2 - s4 * t1 + s5 * t0;
        }

        public static double4x4 inverse(double4x4 m)
        {
            double s0 = m.c0.x * m.c1.y - m.c0.y * m.c1.x;
            double s1 = m.c0.x * m.c1.z - m.c0.z * m.c1.x;
            double s2 = m.c0.x * m.c1.w - m.c0.w * m.c1.x;
            double s3 = m.c0.y * m.c1.z - m.c0.z * m.c1.y;
            double s4 = m.c0.y * m.c1.w - m.c0.w * m.c1.y;
            double s5 = m.c0.z * m.c1.w - m.c0.w * m.c1.z;
            double t0 = m.c2.x * m.c3.y - m.c2.y * m.c3.x;
            double t1 = m.c2.x * m.c3.z - m.c2.z * m.c3.x;
            double t2 = m.c2.x * m.c3.w - m.c2.w * m.c3.x;
            double t3 = m.c2.y * m.c3.z - m.c2.z * m.c3.y;
            double t4 = m.c2.y * m.c3.w - m.c2.w * m.c3.y;
            double t5 = m.c2.z * m.c3.w - m.c2.w * m.c3.z;
            double rcpDet = 1.0 / (s0 * t5 - s1 * t4 + s2 * t3 + s3 * t2 - s4 * t1 + s5 * t0);
            double4 r0 = new double4(m.c1.y * t5 - m.c1.z * t4 + m.c1.w * t3,
                m.c0.z * t4 - m.c0.y * t5 - m.c0.w * t3,
                m.c3.y * s5 - m.c3.z * s4 + m.c3.w * s3,
                m.c2.z * s4 - m.c2.y * s5 - m.c2.w * s3);
            double4 r1 = new double4(m.c1.z * t2 - m.c1.x * t5 - m.c1.w * t1,
                m.c0.x * t5 - m.c0.z * t2 + m.c0.w * t1,
                m.c3.z * s2 - m.c3.x * s5 - m.c3.w * s1,
                m.c2.x * s5 - m.c2.z * s2 + m.c2.w * s1);
            double4 r2 = new double4(m.c1.x * t4 - m.c1.y * t2 + m.c1.w * t0,
                m.c0.y * t2 - m.c0.x * t4 - m.c0.w * t0,
                m.c3.x * s4 - m.c3.y * s2 + m.c3.w * s0,
                m.c2.y * s2 - m.c2.x * s4 - m.c2.w * s0);
            double4 r3 = new double4(m.c1.y * t1 - m.c1.x * t3 - m.c1.z * t0,
                m.c0.x * t3 - m.c0.y * t1 + m.c0.z * t0,
                m.c3.y * s1 - m.c3.x * s3 - m.c3.z * s0,
                m.c2.x * s3 - m.c2.y * s1 + m.c2.z * s0);
            return new double4x4(r0 * rcpDet, r1 * rcpDet, r2 * rcpDet, r3 * rcpDet);
        }
    }
}
