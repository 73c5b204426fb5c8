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

        public override int GetHashCode() => HashCode.Combine(x, y, z, w);

        public override string ToString() => $"uint4({x}, {y}, {z}, {w})";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "uint4({0}, {1}, {2}, {3})",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider), w.ToString(format, formatProvider));

        public uint2 xx { [MethodImpl(Inlining.Always)] get => new uint2(x, x); }

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

        public uint2 yy { [MethodImpl(Inlining.Always)] get => new uint2(y, y); }

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

        public uint2 zz { [MethodImpl(Inlining.Always)] get => new uint2(z, z); }

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

        public uint2 ww { [MethodImpl(Inlining.Always)] get => new uint2(w, w); }

        public uint3 xxx { [MethodImpl(Inlining.Always)] get => new uint3(x, x, x); }

        public uint3 xxy { [MethodImpl(Inlining.Always)] get => new uint3(x, x, y); }

        public uint3 xxz { [MethodImpl(Inlining.Always)] get => new uint3(x, x, z); }

        public uint3 xxw { [MethodImpl(Inlining.Always)] get => new uint3(x, x, w); }

        public uint3 xyx { [MethodImpl(Inlining.Always)] get => new uint3(x, y, x); }

        public uint3 xyy { [MethodImpl(Inlining.Always)] get => new uint3(x, y, y); }

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

        public uint3 xzx { [MethodImpl(Inlining.Always)] get => new uint3(x, z, x); }

        public uint3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public uint3 xzz { [MethodImpl(Inlining.Always)] get => new uint3(x, z, z); }

        public uint3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public uint3 xwx { [MethodImpl(Inlining.Always)] get => new uint3(x, w, x); }

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

        public uint3 xww { [MethodImpl(Inlining.Always)] get => new uint3(x, w, w); }

        public uint3 yxx { [MethodImpl(Inlining.Always)] get => new uint3(y, x, x); }

        public uint3 yxy { [MethodImpl(Inlining.Always)] get => new uint3(y, x, y); }

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

        public uint3 yyx { [MethodImpl(Inlining.Always)] get => new uint3(y, y, x); }

        public uint3 yyy { [MethodImpl(Inlining.Always)] get => new uint3(y, y, y); }

        public uint3 yyz { [MethodImpl(Inlining.Always)] get => new uint3(y, y, z); }

        public uint3 yyw { [MethodImpl(Inlining.Always)] get => new uint3(y, y, w); }

        public uint3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public uint3 yzy { [MethodImpl(Inlining.Always)] get => new uint3(y, z, y); }

        public uint3 yzz { [MethodImpl(Inlining.Always)] get => new uint3(y, z, z); }

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

        public uint3 ywy { [MethodImpl(Inlining.Always)] get => new uint3(y, w, y); }

        public uint3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public uint3 yww { [MethodImpl(Inlining.Always)] get => new uint3(y, w, w); }

        public uint3 zxx { [MethodImpl(Inlining.Always)] get => new uint3(z, x, x); }

        public uint3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public uint3 zxz { [MethodImpl(Inlining.Always)] get => new uint3(z, x, z); }

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

        public uint3 zyy { [MethodImpl(Inlining.Always)] get => new uint3(z, y, y); }

        public uint3 zyz { [MethodImpl(Inlining.Always)] get => new uint3(z, y, z); }

        public uint3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public uint3 zzx { [MethodImpl(Inlining.Always)] get => new uint3(z, z, x); }

        public uint3 zzy { [MethodImpl(Inlining.Always)] get => new uint3(z, z, y); }

        public uint3 zzz { [MethodImpl(Inlining.Always)] get => new uint3(z, z, z); }

        public uint3 zzw { [MethodImpl(Inlining.Always)] get => new uint3(z, z, w); }

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

        public uint3 zwz { [MethodImpl(Inlining.Always)] get => new uint3(z, w, z); }

        public uint3 zww { [MethodImpl(Inlining.Always)] get => new uint3(z, w, w); }

        public uint3 wxx { [MethodImpl(Inlining.Always)] get => new uint3(w, x, x); }

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

        public uint3 wxw { [MethodImpl(Inlining.Always)] get => new uint3(w, x, w); }

        public uint3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public uint3 wyy { [MethodImpl(Inlining.Always)] get => new uint3(w, y, y); }

        public uint3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public uint3 wyw { [MethodImpl(Inlining.Always)] get => new uint3(w, y, w); }

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

        public uint3 wzz { [MethodImpl(Inlining.Always)] get => new uint3(w, z, z); }

        public uint3 wzw { [MethodImpl(Inlining.Always)] get => new uint3(w, z, w); }

        public uint3 wwx { [MethodImpl(Inlining.Always)] get => new uint3(w, w, x); }

        public uint3 wwy { [MethodImpl(Inlining.Always)] get => new uint3(w, w, y); }

        public uint3 wwz { [MethodImpl(Inlining.Always)] get => new uint3(w, w, z); }

        public uint3 www { [MethodImpl(Inlining.Always)] get => new uint3(w, w, w); }

        public uint4 xxxx { [MethodImpl(Inlining.Always)] get => new uint4(x, x, x, x); }

        public uint4 xyzw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, y, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; w = value.w; }
        }

        public uint4 xywz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, y, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; z = value.w; }
        }

        public uint4 xzyw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, z, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; w = value.w; }
        }

        public uint4 xzwy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, z, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; y = value.w; }
        }

        public uint4 xwyz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, w, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; z = value.w; }
        }

        public uint4 xwzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(x, w, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; y = value.w; }
        }

        public uint4 yxzw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, x, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; w = value.w; }
        }

        public uint4 yxwz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, x, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; z = value.w; }
        }

        public uint4 yyyy { [MethodImpl(Inlining.Always)] get => new uint4(y, y, y, y); }

        public uint4 yzxw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, z, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; w = value.w; }
        }

        public uint4 yzwx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, z, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; x = value.w; }
        }

        public uint4 ywxz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, w, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; z = value.w; }
        }

        public uint4 ywzx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(y, w, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; x = value.w; }
        }

        public uint4 zxyw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, x, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; w = value.w; }
        }

        public uint4 zxwy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, x, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; y = value.w; }
        }

        public uint4 zyxw
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, y, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; w = value.w; }
        }

        public uint4 zywx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, y, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; x = value.w; }
        }

        public uint4 zzzz { [MethodImpl(Inlining.Always)] get => new uint4(z, z, z, z); }

        public uint4 zwxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, w, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; y = value.w; }
        }

        public uint4 zwyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(z, w, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; x = value.w; }
        }

        public uint4 wxyz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, x, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; z = value.w; }
        }

        public uint4 wxzy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, x, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; y = value.w; }
        }

        public uint4 wyxz
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, y, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; z = value.w; }
        }

        public uint4 wyzx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, y, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; x = value.w; }
        }

        public uint4 wzxy
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, z, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; y = value.w; }
        }

        public uint4 wzyx
        {
            [MethodImpl(Inlining.Always)]
            get => new uint4(w, z, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; x = value.w; }
        }

        public uint4 wwww { [MethodImpl(Inlining.Always)] get => new uint4(w, w, w, w); }
    }
}
