// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct double4 : IEquatable<double4>, IFormattable
    {
        public double x;
        public double y;
        public double z;
        public double w;

        public static readonly double4 zero;

        [MethodImpl(Inlining.Always)]
        public double4(bool v)
        {
            this.x = v ? 1.0 : 0.0;
            this.y = v ? 1.0 : 0.0;
            this.z = v ? 1.0 : 0.0;
            this.w = v ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double x, double y, double z, double w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double x, double y, double2 zw)
        {
            this.x = x;
            this.y = y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double x, double2 yz, double w)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double x, double3 yzw)
        {
            this.x = x;
            this.y = yzw.x;
            this.z = yzw.y;
            this.w = yzw.z;
        }

        [MethodImpl(Inlining.Always)]
        public double4(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public double4(float v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public double4(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public double4(bool4 v)
        {
            this.x = v.x ? 1.0 : 0.0;
            this.y = v.y ? 1.0 : 0.0;
            this.z = v.z ? 1.0 : 0.0;
            this.w = v.w ? 1.0 : 0.0;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double2 xy, double z, double w)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double2 xy, double2 zw)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double3 xyz, double w)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(double4 xyzw)
        {
            this.x = xyzw.x;
            this.y = xyzw.y;
            this.z = xyzw.z;
            this.w = xyzw.w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(float4 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
            this.w = v.w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(int4 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
            this.w = v.w;
        }

        [MethodImpl(Inlining.Always)]
        public double4(uint4 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
            this.w = v.w;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator double4(bool v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator double4(bool4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(double v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(int v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(float v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(uint v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(float4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(int4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator double4(uint4 v) => new double4(v);

        [MethodImpl(Inlining.Always)]
        public static double4 operator +(double lhs, double4 rhs) => new double4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator +(double4 lhs, double rhs) => new double4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);

        [MethodImpl(Inlining.Always)]
        public static double4 operator +(double4 lhs, double4 rhs) => new double4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator --(double4 val) => new double4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

        [MethodImpl(Inlining.Always)]
        public static double4 operator /(double lhs, double4 rhs) => new double4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator /(double4 lhs, double rhs) => new double4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);

        [MethodImpl(Inlining.Always)]
        public static double4 operator /(double4 lhs, double4 rhs) => new double4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(double lhs, double4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(double4 lhs, double rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(double4 lhs, double4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(double lhs, double4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(double4 lhs, double rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(double4 lhs, double4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(double lhs, double4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(double4 lhs, double rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(double4 lhs, double4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator ++(double4 val) => new double4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(double lhs, double4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(double4 lhs, double rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(double4 lhs, double4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(double lhs, double4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(double4 lhs, double rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(double4 lhs, double4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(double lhs, double4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(double4 lhs, double rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(double4 lhs, double4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator %(double lhs, double4 rhs) => new double4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator %(double4 lhs, double rhs) => new double4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

        [MethodImpl(Inlining.Always)]
        public static double4 operator %(double4 lhs, double4 rhs) => new double4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator *(double lhs, double4 rhs) => new double4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator *(double4 lhs, double rhs) => new double4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);

        [MethodImpl(Inlining.Always)]
        public static double4 operator *(double4 lhs, double4 rhs) => new double4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator -(double lhs, double4 rhs) => new double4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator -(double4 lhs, double rhs) => new double4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);

        [MethodImpl(Inlining.Always)]
        public static double4 operator -(double4 lhs, double4 rhs) => new double4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator -(double4 val) => new double4(-val.x, -val.y, -val.z, -val.w);

        [MethodImpl(Inlining.Always)]
        public static double4 operator +(double4 val) => new double4(+val.x, +val.y, +val.z, +val.w);

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
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(double4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

        public override bool Equals(object o) => o is double4 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.fold_to_uint(x) * 0x9F1C739Bu + math.fold_to_uint(y) * 0x4B1BD187u +
            math.fold_to_uint(z) * 0x9DF50593u + math.fold_to_uint(w) * 0xF18EEB85u + 0x9E19BFC3u);

        public override string ToString() => $"double4({x}, {y}, {z}, {w})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "double4({0}, {1}, {2}, {3})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider), w.ToString(format, formatProvider));

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

        public double2 xw
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(x, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; }
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

        public double2 yw
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(y, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; }
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

        public double2 zw
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(z, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; }
        }

        public double2 wx
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(w, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; }
        }

        public double2 wy
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(w, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; }
        }

        public double2 wz
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(w, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; }
        }

        public double2 ww
        {
            [MethodImpl(Inlining.Always)]
            get => new double2(w, w);
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

        public double3 xyw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; }
        }

        public double3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public double3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public double3 xwy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; }
        }

        public double3 xwz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(x, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; }
        }

        public double3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public double3 yxw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; }
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

        public double3 yzw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; }
        }

        public double3 ywx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; }
        }

        public double3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public double3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public double3 zxw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; }
        }

        public double3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public double3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public double3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, z, z);
        }

        public double3 zwx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; }
        }

        public double3 zwy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(z, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; }
        }

        public double3 wxy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; }
        }

        public double3 wxz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; }
        }

        public double3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public double3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public double3 wzx
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; }
        }

        public double3 wzy
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; }
        }

        public double3 www
        {
            [MethodImpl(Inlining.Always)]
            get => new double3(w, w, w);
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

        public double4 wwww
        {
            [MethodImpl(Inlining.Always)]
            get => new double4(w, w, w, w);
        }
    }
}
