// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct uint3 : IEquatable<uint3>, IFormattable
    {
        public uint x;
        public uint y;
        public uint z;

        public static readonly uint3 zero;

        [MethodImpl(Inlining.Always)]
        public uint3(bool v)
        {
            this.x = v ? 1u : 0u;
            this.y = v ? 1u : 0u;
            this.z = v ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(double v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(int v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(float v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(uint x, uint y, uint z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(uint x, uint2 yz)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(bool3 v)
        {
            this.x = v.x ? 1u : 0u;
            this.y = v.y ? 1u : 0u;
            this.z = v.z ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(double3 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(float3 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(int3 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(uint2 xy, uint z)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public uint3(uint3 xyz)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(bool v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(double v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(int v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(float v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(bool3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(double3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(float3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint3(int3 v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator uint3(uint v) => new uint3(v);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator +(uint lhs, uint3 rhs) => new uint3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator +(uint3 lhs, uint rhs) => new uint3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator +(uint3 lhs, uint3 rhs) => new uint3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator &(uint lhs, uint3 rhs) => new uint3(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator &(uint3 lhs, uint rhs) => new uint3(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator &(uint3 lhs, uint3 rhs) => new uint3(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator |(uint lhs, uint3 rhs) => new uint3(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator |(uint3 lhs, uint rhs) => new uint3(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator |(uint3 lhs, uint3 rhs) => new uint3(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator --(uint3 val) => new uint3(val.x - 1, val.y - 1, val.z - 1);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator /(uint lhs, uint3 rhs) => new uint3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator /(uint3 lhs, uint rhs) => new uint3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator /(uint3 lhs, uint3 rhs) => new uint3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(uint lhs, uint3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(uint3 lhs, uint rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(uint3 lhs, uint3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator ^(uint lhs, uint3 rhs) => new uint3(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator ^(uint3 lhs, uint rhs) => new uint3(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator ^(uint3 lhs, uint3 rhs) => new uint3(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(uint lhs, uint3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(uint3 lhs, uint rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(uint3 lhs, uint3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(uint lhs, uint3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(uint3 lhs, uint rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(uint3 lhs, uint3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator ++(uint3 val) => new uint3(val.x + 1, val.y + 1, val.z + 1);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(uint lhs, uint3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(uint3 lhs, uint rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(uint3 lhs, uint3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator <<(uint3 x, int n) => new uint3(x.x << n, x.y << n, x.z << n);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(uint lhs, uint3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(uint3 lhs, uint rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(uint3 lhs, uint3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(uint lhs, uint3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(uint3 lhs, uint rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(uint3 lhs, uint3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator %(uint lhs, uint3 rhs) => new uint3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator %(uint3 lhs, uint rhs) => new uint3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator %(uint3 lhs, uint3 rhs) => new uint3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator *(uint lhs, uint3 rhs) => new uint3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator *(uint3 lhs, uint rhs) => new uint3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator *(uint3 lhs, uint3 rhs) => new uint3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator ~(uint3 val) => new uint3(~val.x, ~val.y, ~val.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator >>(uint3 x, int n) => new uint3(x.x >> n, x.y >> n, x.z >> n);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator -(uint lhs, uint3 rhs) => new uint3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator -(uint3 lhs, uint rhs) => new uint3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator -(uint3 lhs, uint3 rhs) => new uint3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator -(uint3 val) => new uint3((uint)-val.x, (uint)-val.y, (uint)-val.z);

        [MethodImpl(Inlining.Always)]
        public static uint3 operator +(uint3 val) => new uint3(+val.x, +val.y, +val.z);

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
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(uint3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

        public override bool Equals(object o) => o is uint3 converted && Equals(converted);

        public override int GetHashCode() => (int)(x * 0xCD266C89u + y * 0xF1852A33u + z * 0x77E35E77u + 0x863E3729u);

        public override string ToString() => $"uint3({x}, {y}, {z})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "uint3({0}, {1}, {2})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider));

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

        public uint2 xz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(x, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; }
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

        public uint2 yz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(y, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; }
        }

        public uint2 zx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(z, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; }
        }

        public uint2 zy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(z, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; }
        }

        public uint2 zz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(z, z);
        }

        public uint3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, x, x);
        }

        public uint3 xyz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; }
        }

        public uint3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public uint3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public uint3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, y, y);
        }

        public uint3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public uint3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public uint3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public uint3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, z, z);
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

        public uint4 zzzz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, z, z, z);
        }
    }
}
