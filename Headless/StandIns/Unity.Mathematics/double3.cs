// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct double3 : IEquatable<double3>, IFormattable
    {
        public double x;
        public double y;
        public double z;

        public static readonly double3 zero;

        [MethodImpl(Inlining.Always)]
        public double3(bool v)
        {
            this.x = v ? 1.0 : 0.0;
            this.y = v ? 1.0 : 0.0;
            this.z = v ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double3(double v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public double3(double x, double y, double z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public double3(double x, double2 yz)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
        }

        [MethodImpl(Inlining.Always)]
        public double3(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public double3(float v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public double3(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public double3(bool3 v)
        {
            this.x = v.x ? 1.0 : 0.0;
            this.y = v.y ? 1.0 : 0.0;
            this.z = v.z ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double3(double2 xy, double z)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public double3(double3 xyz)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
        }

        [MethodImpl(Inlining.Always)]
        public double3(float3 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
        }

        [MethodImpl(Inlining.Always)]
        public double3(int3 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
        }

        [MethodImpl(Inlining.Always)]
        public double3(uint3 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator double3(bool v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator double3(bool3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(double v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(int v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(float v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(uint v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(float3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(int3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double3(uint3 v) => new double3(v);

        [MethodImpl(Inlining.Always)]
        public static double3 operator +(double lhs, double3 rhs) => new double3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator +(double3 lhs, double rhs) => new double3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);

        [MethodImpl(Inlining.Always)]
        public static double3 operator +(double3 lhs, double3 rhs) => new double3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator --(double3 val) => new double3(val.x - 1, val.y - 1, val.z - 1);

        [MethodImpl(Inlining.Always)]
        public static double3 operator /(double lhs, double3 rhs) => new double3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator /(double3 lhs, double rhs) => new double3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

        [MethodImpl(Inlining.Always)]
        public static double3 operator /(double3 lhs, double3 rhs) => new double3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(double lhs, double3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(double3 lhs, double rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(double3 lhs, double3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(double lhs, double3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(double3 lhs, double rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(double3 lhs, double3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(double lhs, double3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(double3 lhs, double rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(double3 lhs, double3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator ++(double3 val) => new double3(val.x + 1, val.y + 1, val.z + 1);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(double lhs, double3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(double3 lhs, double rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(double3 lhs, double3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(double lhs, double3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(double3 lhs, double rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(double3 lhs, double3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(double lhs, double3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(double3 lhs, double rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(double3 lhs, double3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator %(double lhs, double3 rhs) => new double3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator %(double3 lhs, double rhs) => new double3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);

        [MethodImpl(Inlining.Always)]
        public static double3 operator %(double3 lhs, double3 rhs) => new double3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator *(double lhs, double3 rhs) => new double3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator *(double3 lhs, double rhs) => new double3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);

        [MethodImpl(Inlining.Always)]
        public static double3 operator *(double3 lhs, double3 rhs) => new double3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator -(double lhs, double3 rhs) => new double3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator -(double3 lhs, double rhs) => new double3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);

        [MethodImpl(Inlining.Always)]
        public static double3 operator -(double3 lhs, double3 rhs) => new double3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator -(double3 val) => new double3(-val.x, -val.y, -val.z);

        [MethodImpl(Inlining.Always)]
        public static double3 operator +(double3 val) => new double3(+val.x, +val.y, +val.z);

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
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(double3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

        public override bool Equals(object o) => o is double3 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.fold_to_uint(x) * 0xAF0F3103u + math.fold_to_uint(y) * 0xE4A056C7u +
            math.fold_to_uint(z) * 0x841D8225u + 0xC9393C7Du);

        public override string ToString() => $"double3({x}, {y}, {z})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "double3({0}, {1}, {2})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider));

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

        public double2 xz
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(x, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; }
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

        public double2 yz
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(y, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; }
        }

        public double2 zx
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(z, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; }
        }

        public double2 zy
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(z, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; }
        }

        public double2 zz
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(z, z);
        }

        public double3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, x, x);
        }

        public double3 xyz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; }
        }

        public double3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public double3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public double3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, y, y);
        }

        public double3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public double3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public double3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public double3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, z, z);
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

        public double4 zzzz
        {
            [MethodImpl(Inlining.Always)]
            get => new double4(z, z, z, z);
        }
    }
}
