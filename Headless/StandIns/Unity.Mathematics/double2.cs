// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct double2 : IEquatable<double2>, IFormattable
    {
        public double x;
        public double y;

        public static readonly double2 zero;

        [MethodImpl(Inlining.Always)]
        public double2(bool v)
        {
            this.x = v ? 1.0 : 0.0;
            this.y = v ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double2(double v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public double2(double x, double y)
        {
            this.x = x;
            this.y = y;
        }

        [MethodImpl(Inlining.Always)]
        public double2(int v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public double2(float v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public double2(uint v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public double2(bool2 v)
        {
            this.x = v.x ? 1.0 : 0.0;
            this.y = v.y ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double2(double2 xy)
        {
            this.x = xy.x;
            this.y = xy.y;
        }

        [MethodImpl(Inlining.Always)]
        public double2(float2 v)
        {
            this.x = v.x;
            this.y = v.y;
        }

        [MethodImpl(Inlining.Always)]
        public double2(int2 v)
        {
            this.x = v.x;
            this.y = v.y;
        }

        [MethodImpl(Inlining.Always)]
        public double2(uint2 v)
        {
            this.x = v.x;
            this.y = v.y;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator double2(bool v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator double2(bool2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(double v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(int v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(float v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(uint v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(float2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(int2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double2(uint2 v) => new double2(v);

        [MethodImpl(Inlining.Always)]
        public static double2 operator +(double lhs, double2 rhs) => new double2(lhs + rhs.x, lhs + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator +(double2 lhs, double rhs) => new double2(lhs.x + rhs, lhs.y + rhs);

        [MethodImpl(Inlining.Always)]
        public static double2 operator +(double2 lhs, double2 rhs) => new double2(lhs.x + rhs.x, lhs.y + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator --(double2 val) => new double2(val.x - 1, val.y - 1);

        [MethodImpl(Inlining.Always)]
        public static double2 operator /(double lhs, double2 rhs) => new double2(lhs / rhs.x, lhs / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator /(double2 lhs, double rhs) => new double2(lhs.x / rhs, lhs.y / rhs);

        [MethodImpl(Inlining.Always)]
        public static double2 operator /(double2 lhs, double2 rhs) => new double2(lhs.x / rhs.x, lhs.y / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(double lhs, double2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(double2 lhs, double rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(double2 lhs, double2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(double lhs, double2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(double2 lhs, double rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(double2 lhs, double2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(double lhs, double2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(double2 lhs, double rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(double2 lhs, double2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator ++(double2 val) => new double2(val.x + 1, val.y + 1);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(double lhs, double2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(double2 lhs, double rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(double2 lhs, double2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(double lhs, double2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(double2 lhs, double rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(double2 lhs, double2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(double lhs, double2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(double2 lhs, double rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(double2 lhs, double2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator %(double lhs, double2 rhs) => new double2(lhs % rhs.x, lhs % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator %(double2 lhs, double rhs) => new double2(lhs.x % rhs, lhs.y % rhs);

        [MethodImpl(Inlining.Always)]
        public static double2 operator %(double2 lhs, double2 rhs) => new double2(lhs.x % rhs.x, lhs.y % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator *(double lhs, double2 rhs) => new double2(lhs * rhs.x, lhs * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator *(double2 lhs, double rhs) => new double2(lhs.x * rhs, lhs.y * rhs);

        [MethodImpl(Inlining.Always)]
        public static double2 operator *(double2 lhs, double2 rhs) => new double2(lhs.x * rhs.x, lhs.y * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator -(double lhs, double2 rhs) => new double2(lhs - rhs.x, lhs - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator -(double2 lhs, double rhs) => new double2(lhs.x - rhs, lhs.y - rhs);

        [MethodImpl(Inlining.Always)]
        public static double2 operator -(double2 lhs, double2 rhs) => new double2(lhs.x - rhs.x, lhs.y - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator -(double2 val) => new double2(-val.x, -val.y);

        [MethodImpl(Inlining.Always)]
        public static double2 operator +(double2 val) => new double2(+val.x, +val.y);

        public unsafe double this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (double* first = &x)
                    return first[index];
            }
            [MethodImpl(Inlining.Always)]
            set
            {
                CheckIndex(index);
                fixed (double* first = &x)
                    first[index] = value;
            }
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckIndex(int index)
        {
            if ((uint)index >= 2)
                throw new ArgumentException("index must be between[0...1]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(double2 rhs) => x == rhs.x && y == rhs.y;

        public override bool Equals(object o) => o is double2 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.fold_to_uint(x) * 0x9536A0F5u + math.fold_to_uint(y) * 0xAF816615u + 0x9AF8D62Du);

        public override string ToString() => $"double2({x}, {y})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "double2({0}, {1})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider));

        public double2 xx
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(x, x);
        }

        public double2 xy
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(x, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; }
        }

        public double2 yx
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(y, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; }
        }

        public double2 yy
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(y, y);
        }

        public double3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, x, x);
        }

        public double3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, y, y);
        }

        public double4 xxxx
        {
            [MethodImpl(Inlining.Always)]
            get => new double4(x, x, x, x);
        }

        public double4 yyyy
        {
            [MethodImpl(Inlining.Always)]
            get => new double4(y, y, y, y);
        }
    }
}
