using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        /// <summary>Direction: without the translation.</summary>
        [MethodImpl(Inlining.Always)]
        public static float3 rotate(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;

        [MethodImpl(Inlining.Always)]
        public static double3 rotate(double4x4 a, double3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;

        /// <summary>Position: with the translation, without the division by w.</summary>
        [MethodImpl(Inlining.Always)]
        public static float3 transform(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;

        [MethodImpl(Inlining.Always)]
        public static double3 transform(double4x4 a, double3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;

        [MethodImpl(Inlining.Always)]
        public static float3x3 float3x3(float3 c0, float3 c1, float3 c2) => new float3x3(c0, c1, c2);

        [MethodImpl(Inlining.Always)]
        public static float3x3 float3x3(float4x4 f4x4) => new float3x3(f4x4);

        [MethodImpl(Inlining.Always)]
        public static float3x3 float3x3(quaternion rotation) => new float3x3(rotation);

        [MethodImpl(Inlining.Always)]
        public static float4x4 float4x4(float4 c0, float4 c1, float4 c2, float4 c3) => new float4x4(c0, c1, c2, c3);

        [MethodImpl(Inlining.Always)]
        public static float4x4 float4x4(float3x3 rotation, float3 translation) => new float4x4(rotation, translation);

        [MethodImpl(Inlining.Always)]
        public static float4x4 float4x4(quaternion rotation, float3 translation) => new float4x4(rotation, translation);

        [MethodImpl(Inlining.Always)]
        public static float4x4 float4x4(double4x4 v) => new float4x4(v);

        [MethodImpl(Inlining.Always)]
        public static double3x3 double3x3(double3 c0, double3 c1, double3 c2) => new double3x3(c0, c1, c2);

        [MethodImpl(Inlining.Always)]
        public static double4x4 double4x4(double4 c0, double4 c1, double4 c2, double4 c3) => new double4x4(c0, c1, c2, c3);

        [MethodImpl(Inlining.Always)]
        public static double4x4 double4x4(float4x4 v) => new double4x4(v);
    }
}
