using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static quaternion quaternion(float x, float y, float z, float w) => new quaternion(x, y, z, w);

        [MethodImpl(Inlining.Always)]
        public static quaternion quaternion(float4 value) => new quaternion(value);

        [MethodImpl(Inlining.Always)]
        public static quaternion quaternion(float3x3 m) => new quaternion(m);

        public static quaternion mul(quaternion a, quaternion b)
        {
            float4 p = a.value;
            float4 q = b.value;
            return new quaternion(new float4(p.w * q.xyz + q.w * p.xyz + cross(p.xyz, q.xyz), p.w * q.w - dot(p.xyz, q.xyz)));
        }

        [MethodImpl(Inlining.Always)]
        public static float3 mul(quaternion q, float3 v)
        {
            float3 t = 2 * cross(q.value.xyz, v);
            return v + q.value.w * t + cross(q.value.xyz, t);
        }

        [MethodImpl(Inlining.Always)]
        public static float3 rotate(quaternion q, float3 v) => mul(q, v);

        [MethodImpl(Inlining.Always)]
        public static float3 forward(quaternion q) => mul(q, new float3(0.0f, 0.0f, 1.0f));

        [MethodImpl(Inlining.Always)]
        public static float dot(quaternion a, quaternion b) => dot(a.value, b.value);

        [MethodImpl(Inlining.Always)]
        public static float length(quaternion q) => sqrt(dot(q.value, q.value));

        [MethodImpl(Inlining.Always)]
        public static quaternion normalize(quaternion q) => new quaternion(normalize(q.value));

        [MethodImpl(Inlining.Always)]
        public static quaternion conjugate(quaternion q) => new quaternion(q.value * new float4(-1.0f, -1.0f, -1.0f, 1.0f));

        [MethodImpl(Inlining.Always)]
        public static quaternion inverse(quaternion q) => new quaternion(conjugate(q).value * rcp(dot(q.value, q.value)));

        public static quaternion nlerp(quaternion q1, quaternion q2, float t)
        {
            float4 near = dot(q1, q2) < 0.0f ? -q2.value : q2.value;
            return new quaternion(normalize(lerp(q1.value, near, t)));
        }

        public static quaternion slerp(quaternion q1, quaternion q2, float t)
        {
            float cosAngle = dot(q1, q2);
            float4 near = cosAngle < 0.0f ? -q2.value : q2.value;
            cosAngle = abs(cosAngle);
            if (cosAngle >= 0.9995f)
                return nlerp(q1, new quaternion(near), t);
            float angle = acos(cosAngle);
            float rcpSin = rsqrt(1.0f - cosAngle * cosAngle);
            return new quaternion(q1.value * (sin(angle * (1.0f - t)) * rcpSin) + near * (sin(angle * t) * rcpSin));
        }
    }
}
