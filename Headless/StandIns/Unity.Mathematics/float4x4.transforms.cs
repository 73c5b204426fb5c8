namespace Unity.Mathematics
{
    public partial struct float4x4
    {
        public float4x4(float3x3 rotation, float3 translation)
        {
            c0 = new float4(rotation.c0, 0.0f);
            c1 = new float4(rotation.c1, 0.0f);
            c2 = new float4(rotation.c2, 0.0f);
            c3 = new float4(translation, 1.0f);
        }

        public float4x4(quaternion rotation, float3 translation) : this(new float3x3(rotation), translation)
        {
        }

        public static float4x4 AxisAngle(float3 axis, float angle) => new float4x4(float3x3.AxisAngle(axis, angle), float3.zero);

        public static float4x4 RotateX(float angle) => new float4x4(float3x3.RotateX(angle), float3.zero);

        public static float4x4 RotateY(float angle) => new float4x4(float3x3.RotateY(angle), float3.zero);

        public static float4x4 RotateZ(float angle) => new float4x4(float3x3.RotateZ(angle), float3.zero);

        public static float4x4 Scale(float s) => Scale(new float3(s));

        public static float4x4 Scale(float x, float y, float z) => Scale(new float3(x, y, z));

        public static float4x4 Scale(float3 scales) => new float4x4(float3x3.Scale(scales), float3.zero);

        public static float4x4 Translate(float3 vector) => new float4x4(float3x3.identity, vector);

        public static float4x4 TRS(float3 translation, quaternion rotation, float3 scale)
        {
            var r = new float3x3(rotation);
            return new float4x4(new float3x3(r.c0 * scale.x, r.c1 * scale.y, r.c2 * scale.z), translation);
        }

        /// <summary>The pose of a viewer at eye: +Z towards target. Not a view matrix (that is its inverse).</summary>
        public static float4x4 LookAt(float3 eye, float3 target, float3 up) =>
            new float4x4(float3x3.LookRotation(math.normalize(target - eye), up), eye);

        /// <summary>OpenGL's clip space (z from -1 to 1, looking down -Z), as all projections here.</summary>
        public static float4x4 Ortho(float width, float height, float near, float far) =>
            OrthoOffCenter(-0.5f * width, 0.5f * width, -0.5f * height, 0.5f * height, near, far);

        public static float4x4 OrthoOffCenter(float left, float right, float bottom, float top, float near, float far)
        {
            float rcpdx = 1.0f / (right - left);
            float rcpdy = 1.0f / (top - bottom);
            float rcpdz = 1.0f / (far - near);
            return new float4x4(
                2.0f * rcpdx, 0.0f, 0.0f, -(right + left) * rcpdx,
                0.0f, 2.0f * rcpdy, 0.0f, -(top + bottom) * rcpdy,
                0.0f, 0.0f, -2.0f * rcpdz, -(far + near) * rcpdz,
                0.0f, 0.0f, 0.0f, 1.0f);
        }

        /// <param name="verticalFov">Radians.</param>
        public static float4x4 PerspectiveFov(float verticalFov, float aspect, float near, float far)
        {
            float cotangent = 1.0f / math.tan(verticalFov * 0.5f);
            float rcpdz = 1.0f / (near - far);
            return new float4x4(
                cotangent / aspect, 0.0f, 0.0f, 0.0f,
                0.0f, cotangent, 0.0f, 0.0f,
                0.0f, 0.0f, (far + near) * rcpdz, 2.0f * near * far * rcpdz,
                0.0f, 0.0f, -1.0f, 0.0f);
        }

        public static float4x4 PerspectiveOffCenter(float left, float right, float bottom, float top, float near, float far)
        {
            float rcpdx = 1.0f / (right - left);
            float rcpdy = 1.0f / (top - bottom);
            float rcpdz = 1.0f / (near - far);
            return new float4x4(
                2.0f * near * rcpdx, 0.0f, (left + right) * rcpdx, 0.0f,
                0.0f, 2.0f * near * rcpdy, (bottom + top) * rcpdy, 0.0f,
                0.0f, 0.0f, (far + near) * rcpdz, 2.0f * near * far * rcpdz,
                0.0f, 0.0f, -1.0f, 0.0f);
        }
    }
}
