// A plain reading of Unity's signatures, one line a component.
using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct float2 : IEquatable<float2>, IFormattable
    {
        public float x;
        public float y;

        public static readonly float2 zero;

        [MethodImpl(Inlining.Always)]
        public float2(bool v)
        {
            this.x = v ? 1.0f : 0.0f;
            this.y = v ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float2(double v)
        {
            this.x = (float)v;
            this.y = (float)v;
        }

        [MethodImpl(Inlining.Always)]
        public float2(int v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public float2(float v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public float2(float x, float y)
        {
            this.x = x;
            this.y = y;
        }

        [MethodImpl(Inlining.Always)]
        public float2(uint v)
        {
            this.x = v;
            this.y = v;
        }

        [MethodImpl(Inlining.Always)]
        public float2(bool2 v)
        {
            this.x = v.x ? 1.0f : 0.0f;
            this.y = v.y ? 1.0f : 0.0f;
        }

        [MethodImpl(Inlining.Always)]
        public float2(double2 v)
        {
            this.x = (float)v.x;
            this.y = (float)v.y;
        }

        [MethodImpl(Inlining.Always)]
        public float2(float2 xy)
        {
            this.x = xy.x;
            this.y = xy.y;
        }

        [MethodImpl(Inlining.Always)]
        public float2(int2 v)
        {
            this.x = v.x;
            this.y = v.y;
        }

        [MethodImpl(Inlining.Always)]
        public float2(uint2 v)
        {
            this.x = v.x;
            this.y = v.y;
        }

        [MethodImpl(Inlining.Always)]
        public static explicit operator float2(bool v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float2(double v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float2(bool2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static explicit operator float2(double2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float2(int v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float2(float v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float2(uint v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float2(int2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static implicit operator float2(uint2 v) => new float2(v);

        [MethodImpl(Inlining.Always)]
        public static float2 operator +(float lhs, float2 rhs) => new float2(lhs + rhs.x, lhs + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator +(float2 lhs, float rhs) => new float2(lhs.x + rhs, lhs.y + rhs);

        [MethodImpl(Inlining.Always)]
        public static float2 operator +(float2 lhs, float2 rhs) => new float2(lhs.x + rhs.x, lhs.y + rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator --(float2 val) => new float2(val.x - 1, val.y - 1);

        [MethodImpl(Inlining.Always)]
        public static float2 operator /(float lhs, float2 rhs) => new float2(lhs / rhs.x, lhs / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator /(float2 lhs, float rhs) => new float2(lhs.x / rhs, lhs.y / rhs);

        [MethodImpl(Inlining.Always)]
        public static float2 operator /(float2 lhs, float2 rhs) => new float2(lhs.x / rhs.x, lhs.y / rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(float lhs, float2 rhs) => new bool2(lhs == rhs.x, lhs == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(float2 lhs, float rhs) => new bool2(lhs.x == rhs, lhs.y == rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator ==(float2 lhs, float2 rhs) => new bool2(lhs.x == rhs.x, lhs.y == rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(float lhs, float2 rhs) => new bool2(lhs > rhs.x, lhs > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(float2 lhs, float rhs) => new bool2(lhs.x > rhs, lhs.y > rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >(float2 lhs, float2 rhs) => new bool2(lhs.x > rhs.x, lhs.y > rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(float lhs, float2 rhs) => new bool2(lhs >= rhs.x, lhs >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(float2 lhs, float rhs) => new bool2(lhs.x >= rhs, lhs.y >= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator >=(float2 lhs, float2 rhs) => new bool2(lhs.x >= rhs.x, lhs.y >= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator ++(float2 val) => new float2(val.x + 1, val.y + 1);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(float lhs, float2 rhs) => new bool2(lhs != rhs.x, lhs != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(float2 lhs, float rhs) => new bool2(lhs.x != rhs, lhs.y != rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator !=(float2 lhs, float2 rhs) => new bool2(lhs.x != rhs.x, lhs.y != rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(float lhs, float2 rhs) => new bool2(lhs < rhs.x, lhs < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(float2 lhs, float rhs) => new bool2(lhs.x < rhs, lhs.y < rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <(float2 lhs, float2 rhs) => new bool2(lhs.x < rhs.x, lhs.y < rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(float lhs, float2 rhs) => new bool2(lhs <= rhs.x, lhs <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(float2 lhs, float rhs) => new bool2(lhs.x <= rhs, lhs.y <= rhs);

        [MethodImpl(Inlining.Always)]
        public static bool2 operator <=(float2 lhs, float2 rhs) => new bool2(lhs.x <= rhs.x, lhs.y <= rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator %(float lhs, float2 rhs) => new float2(lhs % rhs.x, lhs % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator %(float2 lhs, float rhs) => new float2(lhs.x % rhs, lhs.y % rhs);

        [MethodImpl(Inlining.Always)]
        public static float2 operator %(float2 lhs, float2 rhs) => new float2(lhs.x % rhs.x, lhs.y % rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator *(float lhs, float2 rhs) => new float2(lhs * rhs.x, lhs * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator *(float2 lhs, float rhs) => new float2(lhs.x * rhs, lhs.y * rhs);

        [MethodImpl(Inlining.Always)]
        public static float2 operator *(float2 lhs, float2 rhs) => new float2(lhs.x * rhs.x, lhs.y * rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator -(float lhs, float2 rhs) => new float2(lhs - rhs.x, lhs - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator -(float2 lhs, float rhs) => new float2(lhs.x - rhs, lhs.y - rhs);

        [MethodImpl(Inlining.Always)]
        public static float2 operator -(float2 lhs, float2 rhs) => new float2(lhs.x - rhs.x, lhs.y - rhs.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator -(float2 val) => new float2(-val.x, -val.y);

        [MethodImpl(Inlining.Always)]
        public static float2 operator +(float2 val) => new float2(+val.x, +val.y);

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
            if ((uint)index >= 2)
                throw new ArgumentException("index must be between[0...1]");
        }

        [MethodImpl(Inlining.Always)]
        public bool Equals(float2 rhs) => x == rhs.x && y == rhs.y;

        public override bool Equals(object o) => o is float2 converted && Equals(converted);

        public override int GetHashCode() => (int)(math.asuint(x) * 0xFA3A3285u + math.asuint(y) * 0xAD55999Du + 0xDCDD5341u);

        public override string ToString() => $"float2({x}f, {y}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "float2({0}f, {1}f)",
                x.ToString(format, formatProvider), y.ToString(format, formatProvider));

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

        public float3 xxx
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(x, x, x);
        }

        public float3 yyy
        {
            [MethodImpl(Inlining.Always)]
            get => new float3(y, y, y);
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
    }
}
