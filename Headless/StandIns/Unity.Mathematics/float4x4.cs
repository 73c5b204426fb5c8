// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public partial struct float4x4 : IEquatable<float4x4>, IFormattable
    {
        public float4 c0;
        public float4 c1;
        public float4 c2;
        public float4 c3;

        public static readonly float4x4 identity = new float4x4(
            1.0f, 0.0f, 0.0f, 0.0f,
            0.0f, 1.0f, 0.0f, 0.0f,
            0.0f, 0.0f, 1.0f, 0.0f,
            0.0f, 0.0f, 0.0f, 1.0f);

        public static readonly float4x4 zero;

        [MethodImpl(Inlining.Always)]
        public float4x4(float4 c0, float4 c1, float4 c2, float4 c3)
        {
            this.c0 = c0;
            this.c1 = c1;
            this.c2 = c2;
            this.c3 = c3;
        }

        [MethodImpl(Inlining.Always)]
        public float4x4(
            float m00, float m01, float m02, float m03,
            float m10, float m11, float m12, float m13,
            float m20, float m21, float m22, float m23,
            float m30, float m31, float m32, float m33)
        {
            c0 = new float4(m00, m10, m20, m30);
            c1 = new float4(m01, m11, m21, m31);
            c2 = new float4(m02, m12, m22, m32);
            c3 = new float4(m03, m13, m23, m33);
        }

        [MethodImpl(Inlining.Always)]
        public float4x4(float v)
        {
            c0 = v;
            c1 = v;
            c2 = v;
            c3 = v;
        }

        [MethodImpl(Inlining.Always)]
        public float4x4(double4x4 v)
        {
            c0 = (float4)v.c0;
            c1 = (float4)v.c1;
            c2 = (float4)v.c2;
            c3 = (float4)v.c3;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4x4(float v) => new float4x4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float4x4(double4x4 v) => new float4x4(v);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator *(float4x4 lhs, float4x4 rhs) =>
            new float4x4(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator *(float4x4 lhs, float rhs) =>
            new float4x4(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator *(float lhs, float4x4 rhs) =>
            new float4x4(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator +(float4x4 lhs, float4x4 rhs) =>
            new float4x4(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator +(float4x4 lhs, float rhs) =>
            new float4x4(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs, lhs.c3 + rhs);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator +(float lhs, float4x4 rhs) =>
            new float4x4(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2, lhs + rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator -(float4x4 lhs, float4x4 rhs) =>
            new float4x4(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator -(float4x4 lhs, float rhs) =>
            new float4x4(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs, lhs.c3 - rhs);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator -(float lhs, float4x4 rhs) =>
            new float4x4(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2, lhs - rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator /(float4x4 lhs, float4x4 rhs) =>
            new float4x4(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2, lhs.c3 / rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator /(float4x4 lhs, float rhs) =>
            new float4x4(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator /(float lhs, float4x4 rhs) =>
            new float4x4(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2, lhs / rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 operator -(float4x4 val) => new float4x4(-val.c0, -val.c1, -val.c2, -val.c3);

        public unsafe ref float4 this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (float4x4* array = &this)
                    return ref ((float4*)array)[index];
            }
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckIndex(int index)
        {
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
        }

        public bool Equals(float4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);

        public override bool Equals(object o) => o is float4x4 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.asuint(c0.x) * 0xC4B1493Fu + math.asuint(c0.y) * 0xBA0966D3u +
            math.asuint(c0.z) * 0xAFBEE253u + math.asuint(c0.w) * 0x5B419C01u +
            math.asuint(c1.x) * 0x515D90F5u + math.asuint(c1.y) * 0xEC9F68F3u +
            math.asuint(c1.z) * 0xF9EA92D5u + math.asuint(c1.w) * 0xC2FAFCB9u +
            math.asuint(c2.x) * 0x616E9CA1u + math.asuint(c2.y) * 0xC5C5394Bu +
            math.asuint(c2.z) * 0xCAE78587u + math.asuint(c2.w) * 0x7A1541C9u +
            math.asuint(c3.x) * 0xF83BD927u + math.asuint(c3.y) * 0x6A243BCBu +
            math.asuint(c3.z) * 0x509B84C9u + math.asuint(c3.w) * 0x91D13847u + 0x52F7230Fu);

        public override string ToString() =>
            $"float4x4({c0.x}f, {c1.x}f, {c2.x}f, {c3.x}f,  {c0.y}f, {c1.y}f, {c2.y}f, {c3.y}f,  {c0.z}f, {c1.z}f, {c2.z}f, {c3.z}f,  {c0.w}f, {c1.w}f, {c2.w}f, {c3.w}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "float4x4({0}f, {1}f, {2}f, {3}f,  {4}f, {5}f, {6}f, {7}f,  {8}f, {9}f, {10}f, {11}f,  {12}f, {13}f, {14}f, {15}f)",
                c0.x.ToString(format, formatProvider), c1.x.ToString(format, formatProvider), c2.x.ToString(format, formatProvider), c3.x.ToString(format, formatProvider),
                c0.y.ToString(format, formatProvider), c1.y.ToString(format, formatProvider), c2.y.ToString(format, formatProvider), c3.y.ToString(format, formatProvider),
                c0.z.ToString(format, formatProvider), c1.z.ToString(format, formatProvider), c2.z.ToString(format, formatProvider), c3.z.ToString(format, formatProvider),
                c0.w.ToString(format, formatProvider), c1.w.ToString(format, formatProvider), c2.w.ToString(format, formatProvider), c3.w.ToString(format, formatProvider));
    }
}
