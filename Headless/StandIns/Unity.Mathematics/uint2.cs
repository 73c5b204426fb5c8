// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct uint2 : IEquatable<uint2>, IFormattable
    {
        public uint x;
        public uint y;

        public static readonly uint2 zero;

        [MethodImpl(Inlining.Always)]
        public uint2(bool v)
        {
            this.x = v ? 1u : 0u;
            this.y = v ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(double v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(int v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(float v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(uint v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(uint x, uint y)
        {
            this.x = x;
            this.y = y;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(bool2 v)
        {
            this.x = v.x ? 1u : 0u;
            this.y = v.y ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(double2 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(float2 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(int2 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint2(uint2 xy)
        {
            this.x = xy.x;
            this.y = xy.y;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(bool v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(double v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(int v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(float v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(bool2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(double2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(float2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint2(int2 v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator uint2(uint v) => new uint2(v);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator +(uint lhs, uint2 rhs) => new uint2(lhs + rhs.x, lhs + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator +(uint2 lhs, uint rhs) => new uint2(lhs.x + rhs, lhs.y + rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator +(uint2 lhs, uint2 rhs) => new uint2(lhs.x + rhs.x, lhs.y + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator &(uint lhs, uint2 rhs) => new uint2(lhs & rhs.x, lhs & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator &(uint2 lhs, uint rhs) => new uint2(lhs.x & rhs, lhs.y & rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator &(uint2 lhs, uint2 rhs) => new uint2(lhs.x & rhs.x, lhs.y & rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator |(uint lhs, uint2 rhs) => new uint2(lhs | rhs.x, lhs | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator |(uint2 lhs, uint rhs) => new uint2(lhs.x | rhs, lhs.y | rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator |(uint2 lhs, uint2 rhs) => new uint2(lhs.x | rhs.x, lhs.y | rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator --(uint2 val) => new uint2(val.x - 1, val.y - 1);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator /(uint lhs, uint2 rhs) => new uint2(lhs / rhs.x, lhs / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator /(uint2 lhs, uint rhs) => new uint2(lhs.x / rhs, lhs.y / rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator /(uint2 lhs, uint2 rhs) => new uint2(lhs.x / rhs.x, lhs.y / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(uint lhs, uint2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(uint2 lhs, uint rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(uint2 lhs, uint2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator ^(uint lhs, uint2 rhs) => new uint2(lhs ^ rhs.x, lhs ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator ^(uint2 lhs, uint rhs) => new uint2(lhs.x ^ rhs, lhs.y ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator ^(uint2 lhs, uint2 rhs) => new uint2(lhs.x ^ rhs.x, lhs.y ^ rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(uint lhs, uint2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(uint2 lhs, uint rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(uint2 lhs, uint2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(uint lhs, uint2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(uint2 lhs, uint rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(uint2 lhs, uint2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator ++(uint2 val) => new uint2(val.x + 1, val.y + 1);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(uint lhs, uint2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(uint2 lhs, uint rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(uint2 lhs, uint2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator <<(uint2 x, int n) => new uint2(x.x << n, x.y << n);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(uint lhs, uint2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(uint2 lhs, uint rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(uint2 lhs, uint2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(uint lhs, uint2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(uint2 lhs, uint rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(uint2 lhs, uint2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator %(uint lhs, uint2 rhs) => new uint2(lhs % rhs.x, lhs % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator %(uint2 lhs, uint rhs) => new uint2(lhs.x % rhs, lhs.y % rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator %(uint2 lhs, uint2 rhs) => new uint2(lhs.x % rhs.x, lhs.y % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator *(uint lhs, uint2 rhs) => new uint2(lhs * rhs.x, lhs * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator *(uint2 lhs, uint rhs) => new uint2(lhs.x * rhs, lhs.y * rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator *(uint2 lhs, uint2 rhs) => new uint2(lhs.x * rhs.x, lhs.y * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator ~(uint2 val) => new uint2(~val.x, ~val.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator >>(uint2 x, int n) => new uint2(x.x >> n, x.y >> n);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator -(uint lhs, uint2 rhs) => new uint2(lhs - rhs.x, lhs - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator -(uint2 lhs, uint rhs) => new uint2(lhs.x - rhs, lhs.y - rhs);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator -(uint2 lhs, uint2 rhs) => new uint2(lhs.x - rhs.x, lhs.y - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator -(uint2 val) => new uint2((uint)-val.x, (uint)-val.y);

        [MethodImpl(Inlining.Always)]
        public static uint2 operator +(uint2 val) => new uint2(+val.x, +val.y);

        public unsafe uint this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (uint* first = &x)
                    return first[index];
            }
            [MethodImpl(Inlining.Always)]
            set
            {
                CheckIndex(index);
                fixed (uint* first = &x)
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
        public bool Equals(uint2 rhs) => x == rhs.x && y == rhs.y;

        public override bool Equals(object o) => o is uint2 converted && Equals(converted);

        public override int GetHashCode() => (int)(x * 0x4473BBB1u + y * 0xCBA11D5Fu + 0x685835CFu);

        public override string ToString() => $"uint2({x}, {y})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "uint2({0}, {1})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider));

        public uint2 xx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(x, x);
        }

        public uint2 xy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(x, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; }
        }

        public uint2 yx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(y, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; }
        }

        public uint2 yy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(y, y);
        }

        public uint3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, x, x);
        }

        public uint3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, y, y);
        }

        public uint4 xxxx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, x, x, x);
        }

        public uint4 yyyy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, y, y, y);
        }
    }
}
