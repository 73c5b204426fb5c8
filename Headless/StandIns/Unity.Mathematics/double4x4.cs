// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public partial struct double4x4 : IEquatable<double4x4>, IFormattable
    {
        public double4 c0;
        public double4 c1;
        public double4 c2;
        public double4 c3;

        public static readonly double4x4 identity = new double4x4(
            1.0, 0.0, 0.0, 0.0,
            0.0, 1.0, 0.0, 0.0,
            0.0, 0.0, 1.0, 0.0,
            0.0, 0.0, 0.0, 1.0);

        public static readonly double4x4 zero;

        [MethodImpl(Inlining.Always)]
        public double4x4(double4 c0, double4 c1, double4 c2, double4 c3)
        {
            this.c0 = c0;
            this.c1 = c1;
            this.c2 = c2;
            this.c3 = c3;
        }

        [MethodImpl(Inlining.Always)]
        public double4x4(
            double m00, double m01, double m02, double m03,
            double m10, double m11, double m12, double m13,
            double m20, double m21, double m22, double m23,
            double m30, double m31, double m32, double m33)
        {
            c0 = new double4(m00, m10, m20, m30);
            c1 = new double4(m01, m11, m21, m31);
            c2 = new double4(m02, m12, m22, m32);
            c3 = new double4(m03, m13, m23, m33);
        }

        [MethodImpl(Inlining.Always)]
        public double4x4(double v)
        {
            c0 = v;
            c1 = v;
            c2 = v;
            c3 = v;
        }

        [MethodImpl(Inlining.Always)]
        public double4x4(float4x4 v)
        {
            c0 = v.c0;
            c1 = v.c1;
            c2 = v.c2;
            c3 = v.c3;
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4x4(double v) => new double4x4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4x4(float4x4 v) => new double4x4(v);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator *(double4x4 lhs, double4x4 rhs) =>
            new double4x4(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator *(double4x4 lhs, double rhs) =>
            new double4x4(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator *(double lhs, double4x4 rhs) =>
            new double4x4(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator +(double4x4 lhs, double4x4 rhs) =>
            new double4x4(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator +(double4x4 lhs, double rhs) =>
            new double4x4(lhs.c0 + rhs, lhs.c1 + rhs, lhs.c2 + rhs, lhs.c3 + rhs);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator +(double lhs, double4x4 rhs) =>
            new double4x4(lhs + rhs.c0, lhs + rhs.c1, lhs + rhs.c2, lhs + rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator -(double4x4 lhs, double4x4 rhs) =>
            new double4x4(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator -(double4x4 lhs, double rhs) =>
            new double4x4(lhs.c0 - rhs, lhs.c1 - rhs, lhs.c2 - rhs, lhs.c3 - rhs);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator -(double lhs, double4x4 rhs) =>
            new double4x4(lhs - rhs.c0, lhs - rhs.c1, lhs - rhs.c2, lhs - rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator /(double4x4 lhs, double4x4 rhs) =>
            new double4x4(lhs.c0 / rhs.c0, lhs.c1 / rhs.c1, lhs.c2 / rhs.c2, lhs.c3 / rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator /(double4x4 lhs, double rhs) =>
            new double4x4(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator /(double lhs, double4x4 rhs) =>
            new double4x4(lhs / rhs.c0, lhs / rhs.c1, lhs / rhs.c2, lhs / rhs.c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 operator -(double4x4 val) => new double4x4(-val.c0, -val.c1, -val.c2, -val.c3);

        public unsafe ref double4 this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (double4x4* array = &this)
                    return ref ((double4*)array)[index];
            }
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckIndex(int index)
        {
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
        }

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

        public override string ToString() =>
            $"double4x4({c0.x}, {c1.x}, {c2.x}, {c3.x},  {c0.y}, {c1.y}, {c2.y}, {c3.y},  {c0.z}, {c1.z}, {c2.z}, {c3.z},  {c0.w}, {c1.w}, {c2.w}, {c3.w})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "double4x4({0}, {1}, {2}, {3},  {4}, {5}, {6}, {7},  {8}, {9}, {10}, {11},  {12}, {13}, {14}, {15})",
                c0.x.ToString(format, formatProvider), c1.x.ToString(format, formatProvider), c2.x.ToString(format, formatProvider), c3.x.ToString(format, formatProvider),
                c0.y.ToString(format, formatProvider), c1.y.ToString(format, formatProvider), c2.y.ToString(format, formatProvider), c3.y.ToString(format, formatProvider),
                c0.z.ToString(format, formatProvider), c1.z.ToString(format, formatProvider), c2.z.ToString(format, formatProvider), c3.z.ToString(format, formatProvider),
                c0.w.ToString(format, formatProvider), c1.w.ToString(format, formatProvider), c2.w.ToString(format, formatProvider), c3.w.ToString(format, formatProvider));
    }
}
