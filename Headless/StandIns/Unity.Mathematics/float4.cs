// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct float4 : IEquatable<float4>, IFormattable
    {
        public float x;
        public float y;
        public float z;
        public float w;

        public static readonly float4 zero;

        [MethodImpl(Inlining.Always)]
        public float4(bool v)
        {
            this.x = v ? 1.0f : 0.0f;
            this.y = v ? 1.0f : 0.0f;
            this.z = v ? 1.0f : 0.0f;
            this.w = v ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float4(double v)
        {
            this.x = (float)v;
            this.y = (float)v;
            this.z = (float)v;
            this.w = (float)v;
        }

        [MethodImpl(Inlining.Always)]
        public float4(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float x, float y, float z, float w)
        {
            this.x = x;
            this.y = y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float x, float y, float2 zw)
        {
            this.x = x;
            this.y = y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float x, float2 yz, float w)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float x, float3 yzw)
        {
            this.x = x;
            this.y = yzw.x;
            this.z = yzw.y;
            this.w = yzw.z;
        }

        [MethodImpl(Inlining.Always)]
        public float4(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
            this.w = v;
        }

        [MethodImpl(Inlining.Always)]
        public float4(bool4 v)
        {
            this.x = v.x ? 1.0f : 0.0f;
            this.y = v.y ? 1.0f : 0.0f;
            this.z = v.z ? 1.0f : 0.0f;
            this.w = v.w ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float4(double4 v)
        {
            this.x = (float)v.x;
            this.y = (float)v.y;
            this.z = (float)v.z;
            this.w = (float)v.w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float2 xy, float z, float w)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float2 xy, float2 zw)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = zw.x;
            this.w = zw.y;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float3 xyz, float w)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
            this.w = w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(float4 xyzw)
        {
            this.x = xyzw.x;
            this.y = xyzw.y;
            this.z = xyzw.z;
            this.w = xyzw.w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(int4 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
            this.w = v.w;
        }

        [MethodImpl(Inlining.Always)]
        public float4(uint4 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
            this.w = v.w;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator float4(bool v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float4(double v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float4(bool4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float4(double4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4(int v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4(float v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4(uint v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4(int4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float4(uint4 v) => new float4(v);

        [MethodImpl(Inlining.Always)]
        public static float4 operator +(float lhs, float4 rhs) => new float4(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z, lhs + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator +(float4 lhs, float rhs) => new float4(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs, lhs.w + rhs);

        [MethodImpl(Inlining.Always)]
        public static float4 operator +(float4 lhs, float4 rhs) => new float4(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z, lhs.w + rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator --(float4 val) => new float4(val.x - 1, val.y - 1, val.z - 1, val.w - 1);

        [MethodImpl(Inlining.Always)]
        public static float4 operator /(float lhs, float4 rhs) => new float4(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator /(float4 lhs, float rhs) => new float4(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);

        [MethodImpl(Inlining.Always)]
        public static float4 operator /(float4 lhs, float4 rhs) => new float4(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(float lhs, float4 rhs) => new bool4(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z, lhs == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(float4 lhs, float rhs) => new bool4(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs, lhs.w == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator ==(float4 lhs, float4 rhs) => new bool4(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z, lhs.w == rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(float lhs, float4 rhs) => new bool4(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z, lhs > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(float4 lhs, float rhs) => new bool4(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs, lhs.w > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >(float4 lhs, float4 rhs) => new bool4(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z, lhs.w > rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(float lhs, float4 rhs) => new bool4(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z, lhs >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(float4 lhs, float rhs) => new bool4(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs, lhs.w >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator >=(float4 lhs, float4 rhs) => new bool4(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z, lhs.w >= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator ++(float4 val) => new float4(val.x + 1, val.y + 1, val.z + 1, val.w + 1);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(float lhs, float4 rhs) => new bool4(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z, lhs != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(float4 lhs, float rhs) => new bool4(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs, lhs.w != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator !=(float4 lhs, float4 rhs) => new bool4(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z, lhs.w != rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(float lhs, float4 rhs) => new bool4(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z, lhs < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(float4 lhs, float rhs) => new bool4(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs, lhs.w < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <(float4 lhs, float4 rhs) => new bool4(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z, lhs.w < rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(float lhs, float4 rhs) => new bool4(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z, lhs <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(float4 lhs, float rhs) => new bool4(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs, lhs.w <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool4 operator <=(float4 lhs, float4 rhs) => new bool4(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z, lhs.w <= rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator %(float lhs, float4 rhs) => new float4(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator %(float4 lhs, float rhs) => new float4(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

        [MethodImpl(Inlining.Always)]
        public static float4 operator %(float4 lhs, float4 rhs) => new float4(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator *(float lhs, float4 rhs) => new float4(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z, lhs * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator *(float4 lhs, float rhs) => new float4(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs, lhs.w * rhs);

        [MethodImpl(Inlining.Always)]
        public static float4 operator *(float4 lhs, float4 rhs) => new float4(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z, lhs.w * rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator -(float lhs, float4 rhs) => new float4(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z, lhs - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator -(float4 lhs, float rhs) => new float4(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs, lhs.w - rhs);

        [MethodImpl(Inlining.Always)]
        public static float4 operator -(float4 lhs, float4 rhs) => new float4(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z, lhs.w - rhs.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator -(float4 val) => new float4(-val.x, -val.y, -val.z, -val.w);

        [MethodImpl(Inlining.Always)]
        public static float4 operator +(float4 val) => new float4(+val.x, +val.y, +val.z, +val.w);

        public unsafe float this[int index]
        {
            [MethodImpl(Inlining.Always)]
            get
            {
                CheckIndex(index);
                fixed (float* first = &x)
                    return first[index];
            }
            [MethodImpl(Inlining.Always)]
            set
            {
                CheckIndex(index);
                fixed (float* first = &x)
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
        public bool Equals(float4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

        public override bool Equals(object o) => o is float4 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.asuint(x) * 0xE69626FFu + math.asuint(y) * 0xBD010EEBu +
            math.asuint(z) * 0x9CEDE1D1u + math.asuint(w) * 0x43BE0B51u + 0xAF836EE1u);

        public override string ToString() => $"float4({x}f, {y}f, {z}f, {w}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "float4({0}f, {1}f, {2}f, {3}f)",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider), w.ToString(format, formatProvider));

        public float2 xx
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(x, x);
        }

        public float2 xy
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(x, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; }
        }

        public float2 xz
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(x, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; }
        }

        public float2 xw
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(x, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; }
        }

        public float2 yx
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(y, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; }
        }

        public float2 yy
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(y, y);
        }

        public float2 yz
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(y, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; }
        }

        public float2 yw
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(y, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; }
        }

        public float2 zx
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(z, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; }
        }

        public float2 zy
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(z, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; }
        }

        public float2 zz
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(z, z);
        }

        public float2 zw
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(z, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; }
        }

        public float2 wx
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(w, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; }
        }

        public float2 wy
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(w, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; }
        }

        public float2 wz
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(w, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; }
        }

        public float2 ww
        {
            [MethodImpl(Inlining.Always)]
            get => new float2(w, w);
        }

        public float3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, x, x);
        }

        public float3 xyz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, y, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; z = value.z; }
        }

        public float3 xyw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, y, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; y = value.y; w = value.z; }
        }

        public float3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public float3 xzw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, z, w);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; w = value.z; }
        }

        public float3 xwy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, w, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; y = value.z; }
        }

        public float3 xwz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, w, z);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; w = value.y; z = value.z; }
        }

        public float3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
        }

        public float3 yxw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, x, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; w = value.z; }
        }

        public float3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, y, y);
        }

        public float3 yzx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, z, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; x = value.z; }
        }

        public float3 yzw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, z, w);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; z = value.y; w = value.z; }
        }

        public float3 ywx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, w, x);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; x = value.z; }
        }

        public float3 ywz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, w, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; w = value.y; z = value.z; }
        }

        public float3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public float3 zxw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, x, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; w = value.z; }
        }

        public float3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public float3 zyw
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, y, w);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; w = value.z; }
        }

        public float3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, z, z);
        }

        public float3 zwx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, w, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; x = value.z; }
        }

        public float3 zwy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, w, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; w = value.y; y = value.z; }
        }

        public float3 wxy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, x, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; y = value.z; }
        }

        public float3 wxz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, x, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; x = value.y; z = value.z; }
        }

        public float3 wyx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, y, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; x = value.z; }
        }

        public float3 wyz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, y, z);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; y = value.y; z = value.z; }
        }

        public float3 wzx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, z, x);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; x = value.z; }
        }

        public float3 wzy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, z, y);
            [MethodImpl(Inlining.Always)]
            set { w = value.x; z = value.y; y = value.z; }
        }

        public float3 www
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(w, w, w);
        }

        public float4 xxxx
        {
            [MethodImpl(Inlining.Always)]
            get => new float4(x, x, x, x);
        }

        public float4 yyyy
        {
            [MethodImpl(Inlining.Always)]
            get => new float4(y, y, y, y);
        }

        public float4 zzzz
        {
            [MethodImpl(Inlining.Always)]
            get => new float4(z, z, z, z);
        }

        public float4 wwww
        {
            [MethodImpl(Inlining.Always)]
            get => new float4(w, w, w, w);
        }
    }
}
