namespace Unity.Mathematics
{
    public partial struct float3x3
    {
        /// <summary>The rotation of a unit quaternion.</summary>
        public float3x3(quaternion q)
        {
            float4 v = q.value;
            float4 v2 = v + v;
            c0 = new float3(1.0f - v2.y * v.y - v2.z * v.z, v2.x * v.y + v2.w * v.z, v2.x * v.z - v2.w * v.y);
            c1 = new float3(v2.x * v.y - v2.w * v.z, 1.0f - v2.x * v.x - v2.z * v.z, v2.y * v.z + v2.w * v.x);
            c2 = new float3(v2.x * v.z + v2.w * v.y, v2.y * v.z - v2.w * v.x, 1.0f - v2.x * v.x - v2.y * v.y);
        }

        public float3x3(float4x4 f4x4)
        {
            c0 = f4x4.c0.xyz;
            c1 = f4x4.c1.xyz;
            c2 = f4x4.c2.xyz;
        }

        public static explicit operator float3x3(float4x4 f4x4) => new float3x3(f4x4);

        public static float3x3 AxisAngle(float3 axis, float angle) => new float3x3(quaternion.AxisAngle(axis, angle));

        public static float3x3 RotateX(float angle)
        {
            math.sincos(angle, out float s, out float c);
            return new float3x3(1.0f, 0.0f, 0.0f, 0.0f, c, -s, 0.0f, s, c);
        }

        public static float3x3 RotateY(float angle)
        {
            math.sincos(angle, out float s, out float c);
            return new float3x3(c, 0.0f, s, 0.0f, 1.0f, 0.0f, -s, 0.0f, c);
        }

        public static float3x3 RotateZ(float angle)
        {
            math.sincos(angle, out float s, out float c);
            return new float3x3(c, -s, 0.0f, s, c, 0.0f, 0.0f, 0.0f, 1.0f);
        }

        public static float3x3 Scale(float3 v) => new float3x3(v.x, 0.0f, 0.0f, 0.0f, v.y, 0.0f, 0.0f, 0.0f, v.z);

        public static float3x3 LookRotation(float3 forward, float3 up)
        {
            float3 side = math.normalize(math.cross(up, forward));
            return new float3x3(side, math.cross(forward, side), forward);
        }
    }
}
