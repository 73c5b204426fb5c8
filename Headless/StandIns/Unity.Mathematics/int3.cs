// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct int3 : IEquatable<int3>, IFormattable
    {
        public int x;
        public int y;
        public int z;

        public static readonly int3 zero;

        [MethodImpl(Inlining.Always)]
        public int3(bool v)
        {
            this.x = v ? 1 : 0;
            this.y = v ? 1 : 0;
            this.z = v ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int3(double v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int3(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public int3(int x, int y, int z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public int3(int x, int2 yz)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
        }

        [MethodImpl(Inlining.Always)]
        public int3(float v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int3(uint v)
        {
            this.x = (int)v;
            this.y = (int)v;
            this.z = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int3(bool3 v)
        {
            this.x = v.x ? 1 : 0;
            this.y = v.y ? 1 : 0;
            this.z = v.z ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int3(double3 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public int3(float3 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public int3(int2 xy, int z)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public int3(int3 xyz)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
        }

        [MethodImpl(Inlining.Always)]
        public int3(uint3 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
            this.z = (int)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(bool v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(double v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(float v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(uint v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(bool3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(double3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(float3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int3(uint3 v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator int3(int v) => new int3(v);

        [MethodImpl(Inlining.Always)]
        public static int3 operator +(int lhs, int3 rhs) => new int3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator +(int3 lhs, int rhs) => new int3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator +(int3 lhs, int3 rhs) => new int3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator &(int lhs, int3 rhs) => new int3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator &(int3 lhs, int rhs) => new int3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator &(int3 lhs, int3 rhs) => new int3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator |(int lhs, int3 rhs) => new int3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator |(int3 lhs, int rhs) => new int3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator |(int3 lhs, int3 rhs) => new int3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator --(int3 val) => new int3(val.x - 1, val.y - 1, val.z - 1);

        [MethodImpl(Inlining.Always)]
        public static int3 operator /(int lhs, int3 rhs) => new int3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator /(int3 lhs, int rhs) => new int3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator /(int3 lhs, int3 rhs) => new int3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(int lhs, int3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(int3 lhs, int rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(int3 lhs, int3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator ^(int lhs, int3 rhs) => new int3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator ^(int3 lhs, int rhs) => new int3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator ^(int3 lhs, int3 rhs) => new int3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(int lhs, int3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(int3 lhs, int rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(int3 lhs, int3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(int lhs, int3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(int3 lhs, int rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(int3 lhs, int3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator ++(int3 val) => new int3(val.x + 1, val.y + 1, val.z + 1);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(int lhs, int3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(int3 lhs, int rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(int3 lhs, int3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator <<(int3 x, int n) => new int3(x.x << n, x.y << n, x.z << n);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(int lhs, int3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(int3 lhs, int rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(int3 lhs, int3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(int lhs, int3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(int3 lhs, int rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(int3 lhs, int3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator %(int lhs, int3 rhs) => new int3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator %(int3 lhs, int rhs) => new int3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator %(int3 lhs, int3 rhs) => new int3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator *(int lhs, int3 rhs) => new int3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator *(int3 lhs, int rhs) => new int3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator *(int3 lhs, int3 rhs) => new int3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator ~(int3 val) => new int3(~val.x, ~val.y, ~val.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator >>(int3 x, int n) => new int3(x.x >> n, x.y >> n, x.z >> n);

        [MethodImpl(Inlining.Always)]
        public static int3 operator -(int lhs, int3 rhs) => new int3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator -(int3 lhs, int rhs) => new int3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);

        [MethodImpl(Inlining.Always)]
        public static int3 operator -(int3 lhs, int3 rhs) => new int3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator -(int3 val) => new int3(-val.x, -val.y, -val.z);

        [MethodImpl(Inlining.Always)]
        public static int3 operator +(int3 val) => new int3(+val.x, +val.y, +val.z);

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
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

        public override bool Equals(object o) => o is int3 converted && Equals(converted);

        public override int GetHashCode() =>
            (int)((uint)x * 0x4C7F6DD1u + (uint)y * 0x4822A3E9u + (uint)z * 0xAAC3C25Du + 0xD21D0945u);

        public override string ToString() => $"int3({x}, {y}, {z})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "int3({0}, {1}, {2})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider));

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

        public int3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public int3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
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

        public int3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public int3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public int3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(z, z, z);
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
    }
}
