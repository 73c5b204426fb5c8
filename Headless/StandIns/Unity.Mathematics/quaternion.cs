using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public struct quaternion : IEquatable<quaternion>, IFormattable
    {
        public float4 value;

        public static readonly quaternion identity = new quaternion(0.0f, 0.0f, 0.0f, 1.0f);

        [MethodImpl(Inlining.Always)]
        public quaternion(float x, float y, float z, float w)
        {
            value = new float4(x, y, z, w);
        }

        [MethodImpl(Inlining.Always)]
        public quaternion(float4 value)
        {
            this.value = value;
        }

        /// <summary>From an orthonormal rotation matrix, after Shepperd: the largest of w, x, y, z is taken from the
        /// diagonal.</summary>
        public quaternion(float3x3 m)
        {
            float3 u = m.c0;
            float3 v = m.c1;
            float3 w = m.c2;
            float trace = u.x + v.y + w.z;
            if (trace >= 0.0f)
            {
                float t = 1.0f + trace;
                value = new float4(v.z - w.y, w.x - u.z, u.y - v.x, t) * (0.5f * math.rsqrt(t));
            }
            else if (u.x >= v.y && u.x >= w.z)
            {
                float t = 1.0f + u.x - v.y - w.z;
                value = new float4(t, u.y + v.x, w.x + u.z, v.z - w.y) * (0.5f * math.rsqrt(t));
            }
            else if (v.y >= w.z)
            {
                float t = 1.0f - u.x + v.y - w.z;
                value = new float4(u.y + v.x, t, v.z + w.y, w.x - u.z) * (0.5f * math.rsqrt(t));
            }
            else
            {
                float t = 1.0f - u.x - v.y + w.z;
                value = new float4(w.x + u.z, v.z + w.y, t, u.y - v.x) * (0.5f * math.rsqrt(t));
            }
        }

        [MethodImpl(Inlining.Always)]
        public static implicit operator quaternion(float4 v) => new quaternion(v);

        public static quaternion AxisAngle(float3 axis, float angle)
        {
            math.sincos(0.5f * angle, out float s, out float c);
            return new quaternion(new float4(axis * s, c));
        }

        public static quaternion RotateX(float angle) => AxisAngle(new float3(1.0f, 0.0f, 0.0f), angle);

        public static quaternion RotateY(float angle) => AxisAngle(new float3(0.0f, 1.0f, 0.0f), angle);

        public static quaternion RotateZ(float angle) => AxisAngle(new float3(0.0f, 0.0f, 1.0f), angle);

        /// <summary>About Z first, then X, then Y: Unity's own order.</summary>
        public static quaternion EulerZXY(float3 xyz) =>
            math.mul(RotateY(xyz.y), math.mul(RotateX(xyz.x), RotateZ(xyz.z)));

        public static quaternion EulerZXY(float x, float y, float z) => EulerZXY(new float3(x, y, z));

        public static quaternion LookRotation(float3 forward, float3 up)
        {
            float3 side = math.normalize(math.cross(up, forward));
            return new quaternion(new float3x3(side, math.cross(forward, side), forward));
        }

        public bool Equals(quaternion x) => value.Equals(x.value);

        public override bool Equals(object x) => x is quaternion converted && Equals(converted);

        public override int GetHashCode() => value.GetHashCode();

        public override string ToString() => $"quaternion({value.x}f, {value.y}f, {value.z}f, {value.w}f)";

        public string ToString(string format, IFormatProvider formatProvider) =>
            string.Format(formatProvider, "quaternion({0}f, {1}f, {2}f, {3}f)", value.x.ToString(format, formatProvider),
                value.y.ToString(format, formatProvider), value.z.ToString(format, formatProvider),
                value.w.ToString(format, formatProvider));
    }
}
