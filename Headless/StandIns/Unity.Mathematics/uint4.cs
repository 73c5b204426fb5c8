// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct uint4 : IEquatable<uint4>, IFormattable
    {
        public uint x;
        public uint y;
        public uint z;
        public uint w;

        public static readonly uint4 zero;

        [MethodImpl(Inlining.Always)]
        public uint4(bool v)
        {
            this.x = v ? 1u : 0u;
            this.y = v ? 1u : 0u;
            this.z = v ? 1u : 0u;
            this.w = v ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(double v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
            this.w = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(int v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
            this.w = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(float v)
        {
            this.x = (uint)v;
            this.y = (uint)v;
            this.z = (uint)v;
            this.w = (uint)v;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint x, uint y, uint z, uint w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint x, uint y, uint2 zw)
        {
            this.x = x;
            this.y = y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint x, uint2 yz, uint w)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint x, uint3 yzw)
        {
            this.x = x;
            this.y = yzw.x;
            this.z = yzw.y;
            this.w = yzw.z;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(bool4 v)
        {
            this.x = v.x ? 1u : 0u;
            this.y = v.y ? 1u : 0u;
            this.z = v.z ? 1u : 0u;
            this.w = v.w ? 1u : 0u;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(double4 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
            this.w = (uint)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(float4 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
            this.w = (uint)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(int4 v)
        {
            this.x = (uint)v.x;
            this.y = (uint)v.y;
            this.z = (uint)v.z;
            this.w = (uint)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint2 xy, uint z, uint w)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint2 xy, uint2 zw)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint3 xyz, uint w)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public uint4(uint4 xyzw)
        {
            this.x = xyzw.x;
            this.y = xyzw.y;
            this.z = xyzw.z;
            this.w = xyzw.w;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(bool v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(double v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(int v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(float v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(bool4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(double4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(float4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator uint4(int4 v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator uint4(uint v) => new uint4(v);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator +(uint lhs, uint4 rhs) => new uint4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator +(uint4 lhs, uint rhs) => new uint4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator +(uint4 lhs, uint4 rhs) => new uint4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator &(uint lhs, uint4 rhs) => new uint4(lhs & rhs.x, lhs & rhs.y, lhs & rhs.z, lhs & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator &(uint4 lhs, uint rhs) => new uint4(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs, lhs.w & rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator &(uint4 lhs, uint4 rhs) => new uint4(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z, lhs.w & rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator |(uint lhs, uint4 rhs) => new uint4(lhs | rhs.x, lhs | rhs.y, lhs | rhs.z, lhs | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator |(uint4 lhs, uint rhs) => new uint4(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs, lhs.w | rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator |(uint4 lhs, uint4 rhs) => new uint4(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z, lhs.w | rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator --(uint4 val) => new uint4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator /(uint lhs, uint4 rhs) => new uint4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator /(uint4 lhs, uint rhs) => new uint4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator /(uint4 lhs, uint4 rhs) => new uint4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(uint lhs, uint4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(uint4 lhs, uint rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(uint4 lhs, uint4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator ^(uint lhs, uint4 rhs) => new uint4(lhs ^ rhs.x, lhs ^ rhs.y, lhs ^ rhs.z, lhs ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator ^(uint4 lhs, uint rhs) => new uint4(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs, lhs.w ^ rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator ^(uint4 lhs, uint4 rhs) => new uint4(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z, lhs.w ^ rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(uint lhs, uint4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(uint4 lhs, uint rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(uint4 lhs, uint4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(uint lhs, uint4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(uint4 lhs, uint rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(uint4 lhs, uint4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator ++(uint4 val) => new uint4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(uint lhs, uint4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(uint4 lhs, uint rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(uint4 lhs, uint4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator <<(uint4 x, int n) => new uint4(x.x << n, x.y << n, x.z << n, x.w << n);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(uint lhs, uint4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(uint4 lhs, uint rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(uint4 lhs, uint4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(uint lhs, uint4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(uint4 lhs, uint rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(uint4 lhs, uint4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator %(uint lhs, uint4 rhs) => new uint4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator %(uint4 lhs, uint rhs) => new uint4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator %(uint4 lhs, uint4 rhs) => new uint4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator *(uint lhs, uint4 rhs) => new uint4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator *(uint4 lhs, uint rhs) => new uint4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator *(uint4 lhs, uint4 rhs) => new uint4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator ~(uint4 val) => new uint4(~val.x, ~val.y, ~val.z, ~val.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator >>(uint4 x, int n) => new uint4(x.x >> n, x.y >> n, x.z >> n, x.w >> n);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator -(uint lhs, uint4 rhs) => new uint4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator -(uint4 lhs, uint rhs) => new uint4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator -(uint4 lhs, uint4 rhs) => new uint4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator -(uint4 val) => new uint4((uint)-val.x, (uint)-val.y, (uint)-val.z, (uint)-val.w);

        [MethodImpl(Inlining.Always)]
        public static uint4 operator +(uint4 val) => new uint4(+val.x, +val.y, +val.z, +val.w);

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
            if ((uint)index >= 4)
                throw new ArgumentException("index must be between[0...3]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(uint4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

        public override bool Equals(object o) => o is uint4 converted && Equals(converted);

        public override int GetHashCode() =>
            (int)(x * 0xB492BF15u + y * 0xD37220E3u + z * 0x7AA2C2BDu + w * 0xE16BC89Du + 0x7AA07CD3u);

        public override string ToString() => $"uint4({x}, {y}, {z}, {w})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "uint4({0}, {1}, {2}, {3})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider), w.ToString(format, formatProvider));

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

        public uint2 xw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(x, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; }
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

        public uint2 yw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(y, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; }
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

        public uint2 zw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(z, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; }
        }

        public uint2 wx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(w, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; }
        }

        public uint2 wy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(w, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; }
        }

        public uint2 wz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(w, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; }
        }

        public uint2 ww
        {
            [MethodImpl(Inlining.Always)]
            get => new uint2(w, w);
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

        public uint3 xyw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; }
        }

        public uint3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public uint3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public uint3 xwy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; }
        }

        public uint3 xwz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; }
        }

        public uint3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public uint3 yxw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; }
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

        public uint3 yzw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; }
        }

        public uint3 ywx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; }
        }

        public uint3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public uint3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public uint3 zxw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; }
        }

        public uint3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public uint3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public uint3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, z, z);
        }

        public uint3 zwx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; }
        }

        public uint3 zwy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; }
        }

        public uint3 wxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; }
        }

        public uint3 wxz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; }
        }

        public uint3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public uint3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public uint3 wzx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; }
        }

        public uint3 wzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; }
        }

        public uint3 www
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, w, w);
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

        public uint4 wwww
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, w, w, w);
        }
    }
}
