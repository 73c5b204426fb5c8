// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct int2 : IEquatable<int2>, IFormattable
    {
        public int x;
        public int y;

        public static readonly int2 zero;

        [MethodImpl(Inlining.Always)]
        public int2(bool v)
        {
            this.x = v ? 1 : 0;
            this.y = v ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int2(double v)
        {
            this.x = (int)v;
            this.y = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int2(int v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public int2(int x, int y)
        {
            this.x = x;
            this.y = y;
        }

        [MethodImpl(Inlining.Always)]
        public int2(float v)
        {
            this.x = (int)v;
            this.y = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int2(uint v)
        {
            this.x = (int)v;
            this.y = (int)v;
        }

        [MethodImpl(Inlining.Always)]
        public int2(bool2 v)
        {
            this.x = v.x ? 1 : 0;
            this.y = v.y ? 1 : 0;
        }

        [MethodImpl(Inlining.Always)]
        public int2(double2 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public int2(float2 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public int2(int2 xy)
        {
            this.x = xy.x;
            this.y = xy.y;
        }

        [MethodImpl(Inlining.Always)]
        public int2(uint2 v)
        {
            this.x = (int)v.x;
            this.y = (int)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(bool v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(double v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(float v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(uint v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(bool2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(double2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(float2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator int2(uint2 v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator int2(int v) => new int2(v);

        [MethodImpl(Inlining.Always)]
        public static int2 operator +(int lhs, int2 rhs) => new int2(lhs + rhs.x, lhs + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator +(int2 lhs, int rhs) => new int2(lhs.x + rhs, lhs.y + rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator +(int2 lhs, int2 rhs) => new int2(lhs.x + rhs.x, lhs.y + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator &(int lhs, int2 rhs) => new int2(lhs & rhs.x, lhs & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator &(int2 lhs, int rhs) => new int2(lhs.x & rhs, lhs.y & rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator &(int2 lhs, int2 rhs) => new int2(lhs.x & rhs.x, lhs.y & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator |(int lhs, int2 rhs) => new int2(lhs | rhs.x, lhs | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator |(int2 lhs, int rhs) => new int2(lhs.x | rhs, lhs.y | rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator |(int2 lhs, int2 rhs) => new int2(lhs.x | rhs.x, lhs.y | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator --(int2 val) => new int2(val.x - 1, val.y - 1);

        [MethodImpl(Inlining.Always)]
        public static int2 operator /(int lhs, int2 rhs) => new int2(lhs / rhs.x, lhs / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator /(int2 lhs, int rhs) => new int2(lhs.x / rhs, lhs.y / rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator /(int2 lhs, int2 rhs) => new int2(lhs.x / rhs.x, lhs.y / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(int lhs, int2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(int2 lhs, int rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(int2 lhs, int2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator ^(int lhs, int2 rhs) => new int2(lhs ^ rhs.x, lhs ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator ^(int2 lhs, int rhs) => new int2(lhs.x ^ rhs, lhs.y ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator ^(int2 lhs, int2 rhs) => new int2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(int lhs, int2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(int2 lhs, int rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(int2 lhs, int2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(int lhs, int2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(int2 lhs, int rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(int2 lhs, int2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator ++(int2 val) => new int2(val.x + 1, val.y + 1);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(int lhs, int2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(int2 lhs, int rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(int2 lhs, int2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator <<(int2 x, int n) => new int2(x.x << n, x.y << n);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(int lhs, int2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(int2 lhs, int rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(int2 lhs, int2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(int lhs, int2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(int2 lhs, int rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(int2 lhs, int2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator %(int lhs, int2 rhs) => new int2(lhs % rhs.x, lhs % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator %(int2 lhs, int rhs) => new int2(lhs.x % rhs, lhs.y % rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator %(int2 lhs, int2 rhs) => new int2(lhs.x % rhs.x, lhs.y % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator *(int lhs, int2 rhs) => new int2(lhs * rhs.x, lhs * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator *(int2 lhs, int rhs) => new int2(lhs.x * rhs, lhs.y * rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator *(int2 lhs, int2 rhs) => new int2(lhs.x * rhs.x, lhs.y * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator ~(int2 val) => new int2(~val.x, ~val.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator >>(int2 x, int n) => new int2(x.x >> n, x.y >> n);

        [MethodImpl(Inlining.Always)]
        public static int2 operator -(int lhs, int2 rhs) => new int2(lhs - rhs.x, lhs - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator -(int2 lhs, int rhs) => new int2(lhs.x - rhs, lhs.y - rhs);

        [MethodImpl(Inlining.Always)]
        public static int2 operator -(int2 lhs, int2 rhs) => new int2(lhs.x - rhs.x, lhs.y - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator -(int2 val) => new int2(-val.x, -val.y);

        [MethodImpl(Inlining.Always)]
        public static int2 operator +(int2 val) => new int2(+val.x, +val.y);

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
            if ((uint)index >= 2)
                throw new ArgumentException("index must be between[0...1]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;

        public override bool Equals(object o) => o is int2 converted && Equals(converted);

        public override int GetHashCode() => (int)((uint)x * 0x83B58237u + (uint)y * 0x833E3E29u + 0xA9D919BFu);

        public override string ToString() => $"int2({x}, {y})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "int2({0}, {1})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider));

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

        public int3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(x, x, x);
        }

        public int3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new int3(y, y, y);
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
    }
}
