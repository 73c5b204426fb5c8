// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct int4 : IEquatable<int4>, IFormattable
    {
        public int x;
        public int y;
        public int z;
        public int w;

        public static readonly int4 zero;

        [MethodImpl(Inlining.Always)]
        public int4(bool v)
        {
            this.x = v ? 1 : 0;
            this.y = v ? 1 : 0;
            this.z = v ? 1 : 0;
            this.w = v ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int4(double v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
            this.w = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int x, int y, int z, int w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int x, int y, int2 zw)
        {
            this.x = x;
            this.y = y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int x, int2 yz, int w)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int x, int3 yzw)
        {
            this.x = x;
            this.y = yzw.x;
            this.z = yzw.y;
            this.w = yzw.z;
        }

        [MethodImpl(Inlining.Always)]
        public int4(float v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
            this.w = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int4(uint v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
            this.w = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int4(bool4 v)
        {
            this.x = v.x ? 1 : 0;
            this.y = v.y ? 1 : 0;
            this.z = v.z ? 1 : 0;
            this.w = v.w ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int4(double4 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
            this.w = (int)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(float4 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
            this.w = (int)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int2 xy, int z, int w)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int2 xy, int2 zw)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int3 xyz, int w)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(int4 xyzw)
        {
            this.x = xyzw.x;
            this.y = xyzw.y;
            this.z = xyzw.z;
            this.w = xyzw.w;
        }

        [MethodImpl(Inlining.Always)]
        public int4(uint4 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
            this.w = (int)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(bool v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(double v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(float v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(uint v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(bool4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(double4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(float4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int4(uint4 v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator int4(int v) => new int4(v);

        [MethodImpl(Inlining.Always)]
        public static int4 operator +(int lhs, int4 rhs) => new int4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator +(int4 lhs, int rhs) => new int4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator +(int4 lhs, int4 rhs) => new int4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator &(int lhs, int4 rhs) => new int4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator &(int4 lhs, int rhs) => new int4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator &(int4 lhs, int4 rhs) => new int4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator |(int lhs, int4 rhs) => new int4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator |(int4 lhs, int rhs) => new int4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator |(int4 lhs, int4 rhs) => new int4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator --(int4 val) => new int4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

        [MethodImpl(Inlining.Always)]
        public static int4 operator /(int lhs, int4 rhs) => new int4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator /(int4 lhs, int rhs) => new int4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator /(int4 lhs, int4 rhs) => new int4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(int lhs, int4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(int4 lhs, int rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(int4 lhs, int4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator ^(int lhs, int4 rhs) => new int4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator ^(int4 lhs, int rhs) => new int4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator ^(int4 lhs, int4 rhs) => new int4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(int lhs, int4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(int4 lhs, int rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(int4 lhs, int4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(int lhs, int4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(int4 lhs, int rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(int4 lhs, int4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator ++(int4 val) => new int4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(int lhs, int4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(int4 lhs, int rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(int4 lhs, int4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator <<(int4 x, int n) => new int4(x.x << n, x.y << n, x.z << n, x.w << n);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(int lhs, int4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(int4 lhs, int rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(int4 lhs, int4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(int lhs, int4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(int4 lhs, int rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(int4 lhs, int4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator %(int lhs, int4 rhs) => new int4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator %(int4 lhs, int rhs) => new int4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator %(int4 lhs, int4 rhs) => new int4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator *(int lhs, int4 rhs) => new int4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator *(int4 lhs, int rhs) => new int4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator *(int4 lhs, int4 rhs) => new int4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator ~(int4 val) => new int4(~val.x, ~val.y, ~val.z, ~val.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator >>(int4 x, int n) => new int4(x.x >> n, x.y >> n, x.z >> n, x.w >> n);

        [MethodImpl(Inlining.Always)]
        public static int4 operator -(int lhs, int4 rhs) => new int4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator -(int4 lhs, int rhs) => new int4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);

        [MethodImpl(Inlining.Always)]
        public static int4 operator -(int4 lhs, int4 rhs) => new int4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator -(int4 val) => new int4(-val.x, -val.y, -val.z, -val.w);

        [MethodImpl(Inlining.Always)]
        public static int4 operator +(int4 val) => new int4(+val.x, +val.y, +val.z, +val.w);

        public unsafe int this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (int* first = &x)
                    return first[index];
            }
            [MethodImpl(Inlining.Always)]
            set
            {
                CheckIndex(index);
                fixed (int* first = &x)
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
        public bool Equals(int4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

        public override bool Equals(object o) => o is int4 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            (uint)x * 0x6E050B01u + (uint)y * 0x750FDBF5u +
            (uint)z * 0x7F3DD499u + (uint)w * 0x52EAAEBBu + 0x4599C793u);

        public override string ToString() => $"int4({x}, {y}, {z}, {w})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "int4({0}, {1}, {2}, {3})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider), w.ToString(format, formatProvider));

        public int2 xx
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(x, x);
        }

        public int2 xy
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(x, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; }
        }

        public int2 xz
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(x, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; }
        }

        public int2 xw
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(x, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; }
        }

        public int2 yx
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(y, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; }
        }

        public int2 yy
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(y, y);
        }

        public int2 yz
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(y, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; }
        }

        public int2 yw
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(y, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; }
        }

        public int2 zx
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(z, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; }
        }

        public int2 zy
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(z, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; }
        }

        public int2 zz
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(z, z);
        }

        public int2 zw
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(z, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; }
        }

        public int2 wx
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(w, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; }
        }

        public int2 wy
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(w, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; }
        }

        public int2 wz
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(w, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; }
        }

        public int2 ww
        {
            [MethodImpl(Inlining.Always)]
            get => new int2(w, w);
        }

        public int3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, x, x);
        }

        public int3 xyz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; }
        }

        public int3 xyw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; }
        }

        public int3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public int3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public int3 xwy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; }
        }

        public int3 xwz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; }
        }

        public int3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public int3 yxw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; }
        }

        public int3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, y, y);
        }

        public int3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public int3 yzw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; }
        }

        public int3 ywx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; }
        }

        public int3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public int3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public int3 zxw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; }
        }

        public int3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public int3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public int3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, z, z);
        }

        public int3 zwx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; }
        }

        public int3 zwy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; }
        }

        public int3 wxy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; }
        }

        public int3 wxz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; }
        }

        public int3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public int3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public int3 wzx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; }
        }

        public int3 wzy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; }
        }

        public int3 www
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(w, w, w);
        }

        public int4 xxxx
        {
            [MethodImpl(Inlining.Always)]
            get => new int4(x, x, x, x);
        }

        public int4 yyyy
        {
            [MethodImpl(Inlining.Always)]
            get => new int4(y, y, y, y);
        }

        public int4 zzzz
        {
            [MethodImpl(Inlining.Always)]
            get => new int4(z, z, z, z);
        }

        public int4 wwww
        {
            [MethodImpl(Inlining.Always)]
            get => new int4(w, w, w, w);
        }
    }
}
