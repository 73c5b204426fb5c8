// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct float3 : IEquatable<float3>, IFormattable
    {
        public float x;
        public float y;
        public float z;

        public static readonly float3 zero;

        [MethodImpl(Inlining.Always)]
        public float3(bool v)
        {
            this.x = v ? 1.0f : 0.0f;
            this.y = v ? 1.0f : 0.0f;
            this.z = v ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float3(double v)
        {
            this.x = (float)v;
            this.y = (float)v;
            this.z = (float)v;
        }

        [MethodImpl(Inlining.Always)]
        public float3(int v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public float3(float v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public float3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public float3(float x, float2 yz)
        {
            this.x = x;
            this.y = yz.x;
            this.z = yz.y;
        }

        [MethodImpl(Inlining.Always)]
        public float3(uint v)
        {
            this.x = v;
            this.y = v;
            this.z = v;
        }

        [MethodImpl(Inlining.Always)]
        public float3(bool3 v)
        {
            this.x = v.x ? 1.0f : 0.0f;
            this.y = v.y ? 1.0f : 0.0f;
            this.z = v.z ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float3(double3 v)
        {
            this.x = (float)v.x;
            this.y = (float)v.y;
            this.z = (float)v.z;
        }

        [MethodImpl(Inlining.Always)]
        public float3(float2 xy, float z)
        {
            this.x = xy.x;
            this.y = xy.y;
            this.z = z;
        }

        [MethodImpl(Inlining.Always)]
        public float3(float3 xyz)
        {
            this.x = xyz.x;
            this.y = xyz.y;
            this.z = xyz.z;
        }

        [MethodImpl(Inlining.Always)]
        public float3(int3 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
        }

        [MethodImpl(Inlining.Always)]
        public float3(uint3 v)
        {
            this.x = v.x;
            this.y = v.y;
            this.z = v.z;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator float3(bool v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float3(double v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float3(bool3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float3(double3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3(int v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3(float v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3(uint v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3(int3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float3(uint3 v) => new float3(v);

        [MethodImpl(Inlining.Always)]
        public static float3 operator +(float lhs, float3 rhs) => new float3(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator +(float3 lhs, float rhs) => new float3(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);

        [MethodImpl(Inlining.Always)]
        public static float3 operator +(float3 lhs, float3 rhs) => new float3(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator --(float3 val) => new float3(val.x - 1, val.y - 1, val.z - 1);

        [MethodImpl(Inlining.Always)]
        public static float3 operator /(float lhs, float3 rhs) => new float3(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator /(float3 lhs, float rhs) => new float3(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

        [MethodImpl(Inlining.Always)]
        public static float3 operator /(float3 lhs, float3 rhs) => new float3(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(float lhs, float3 rhs) => new bool3(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(float3 lhs, float rhs) => new bool3(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator ==(float3 lhs, float3 rhs) => new bool3(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(float lhs, float3 rhs) => new bool3(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(float3 lhs, float rhs) => new bool3(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >(float3 lhs, float3 rhs) => new bool3(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(float lhs, float3 rhs) => new bool3(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(float3 lhs, float rhs) => new bool3(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator >=(float3 lhs, float3 rhs) => new bool3(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator ++(float3 val) => new float3(val.x + 1, val.y + 1, val.z + 1);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(float lhs, float3 rhs) => new bool3(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(float3 lhs, float rhs) => new bool3(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator !=(float3 lhs, float3 rhs) => new bool3(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(float lhs, float3 rhs) => new bool3(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(float3 lhs, float rhs) => new bool3(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <(float3 lhs, float3 rhs) => new bool3(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(float lhs, float3 rhs) => new bool3(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(float3 lhs, float rhs) => new bool3(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool3 operator <=(float3 lhs, float3 rhs) => new bool3(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator %(float lhs, float3 rhs) => new float3(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator %(float3 lhs, float rhs) => new float3(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);

        [MethodImpl(Inlining.Always)]
        public static float3 operator %(float3 lhs, float3 rhs) => new float3(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator *(float lhs, float3 rhs) => new float3(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator *(float3 lhs, float rhs) => new float3(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);

        [MethodImpl(Inlining.Always)]
        public static float3 operator *(float3 lhs, float3 rhs) => new float3(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator -(float lhs, float3 rhs) => new float3(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator -(float3 lhs, float rhs) => new float3(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);

        [MethodImpl(Inlining.Always)]
        public static float3 operator -(float3 lhs, float3 rhs) => new float3(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator -(float3 val) => new float3(-val.x, -val.y, -val.z);

        [MethodImpl(Inlining.Always)]
        public static float3 operator +(float3 val) => new float3(+val.x, +val.y, +val.z);

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
            if ((uint)index >= 3)
                throw new ArgumentException("index must be between[0...2]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

        public override bool Equals(object o) => o is float3 converted && Equals(converted);

        public override int GetHashCode() => (int)(
            math.asuint(x) * 0x9B13B92Du + math.asuint(y) * 0x4ABF0813u + math.asuint(z) * 0x86068063u + 0xD75513F9u);

        public override string ToString() => $"float3({x}f, {y}f, {z}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "float3({0}f, {1}f, {2}f)",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider), z.ToString(format, formatProvider));

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

        public float3 xzy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, z, y);
            [MethodImpl(Inlining.Always)]
            set { x = value.x; z = value.y; y = value.z; }
        }

        public float3 yxz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, x, z);
            [MethodImpl(Inlining.Always)]
            set { y = value.x; x = value.y; z = value.z; }
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

        public float3 zxy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, x, y);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; x = value.y; y = value.z; }
        }

        public float3 zyx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, y, x);
            [MethodImpl(Inlining.Always)]
            set { z = value.x; y = value.y; x = value.z; }
        }

        public float3 zzz
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(z, z, z);
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
    }
}
