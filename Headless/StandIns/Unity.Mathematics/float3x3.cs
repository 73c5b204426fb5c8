// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public partial struct float3x3 : IEquatable<float3x3>, IFormattable
    {
        public float3 c0;
        public float3 c1;
        public float3 c2;

        public static readonly float3x3 identity = new float3x3(
            1.0f, 0.0f, 0.0f,
            0.0f, 1.0f, 0.0f,
            0.0f, 0.0f, 1.0f);

        public static readonly float3x3 zero;

        [MethodImpl(Inlining.Always)]
        public float3x3(float3 c0, float3 c1, float3 c2)
        {
            this.c0 = c0;
            this.c1 = c1;
            this.c2 = c2;
        }

        [MethodImpl(Inlining.Always)]
        public float3x3(
            float m00, float m01, float m02,
            float m10, float m11, float m12,
            float m20, float m21, float m22)
        {
            c0 = new float3(m00, m10, m20);
            c1 = new float3(m01, m11, m21);
            c2 = new float3(m02, m12, m22);
        }

        [MethodImpl(Inlining.Always)]
        public float3x3(float v)
        {
            c0 = v;
            c1 = v;
            c2 = v;
        }

        [MethodImpl(Inlining.Always)]
        public float3x3(double3x3 v)
        {
            c0 = (float3)v.c0;
            c1 = (float3)v.c1;
            c2 = (float3)v.c2;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3x3(float v) => new float3x3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float3x3(double3x3 v) => new float3x3(v);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator *(float3x3 lhs, float3x3 rhs) =>
            new float3x3(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator *(float3x3 lhs, float rhs) =>
            new float3x3(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator *(float lhs, float3x3 rhs) =>
            new float3x3(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator +(float3x3 lhs, float3x3 rhs) =>
            new float3x3(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator +(float3x3 lhs, float rhs) =>
            new float3x3(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator +(float lhs, float3x3 rhs) =>
            new float3x3(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator -(float3x3 lhs, float3x3 rhs) =>
            new float3x3(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator -(float3x3 lhs, float rhs) =>
            new float3x3(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator -(float lhs, float3x3 rhs) =>
            new float3x3(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator /(float3x3 lhs, float3x3 rhs) =>
            new float3x3(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator /(float3x3 lhs, float rhs) =>
            new float3x3(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator /(float lhs, float3x3 rhs) =>
            new float3x3(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 operator -(float3x3 val) => new float3x3(-val.c0, -val.c1, -val.c2);

        public unsafe ref float3 this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (float3x3* array = &this)
                    return ref ((float3*)array)[index];
            }
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckIndex(int index)
        {
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        public bool Equals(float3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);

        public override bool Equals(object o) => o is float3x3 converted && Equals(converted);

        public override int GetHashCode() => HashCode.Combine(c0, c1, c2);

        public override string ToString() =>
            $"float3x3({c0.x}f, {c1.x}f, {c2.x}f,  {c0.y}f, {c1.y}f, {c2.y}f,  {c0.z}f, {c1.z}f, {c2.z}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "float3x3({0}f, {1}f, {2}f,  {3}f, {4}f, {5}f,  {6}f, {7}f, {8}f)",
                c0.x.ToString(format, formatProvider), c1.x.ToString(format, formatProvider), c2.x.ToString(format, formatProvider),
                c0.y.ToString(format, formatProvider), c1.y.ToString(format, formatProvider), c2.y.ToString(format, formatProvider),
                c0.z.ToString(format, formatProvider), c1.z.ToString(format, formatProvider), c2.z.ToString(format, formatProvider));
    }
}
