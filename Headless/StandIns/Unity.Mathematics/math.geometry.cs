// A plain reading of Unity's signatures, one line a component.
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static double dot(double x, double y) => x * y;

        [MethodImpl(Inlining.Always)]
        public static int dot(int x, int y) => x * y;

        [MethodImpl(Inlining.Always)]
        public static float dot(float x, float y) => x * y;

        [MethodImpl(Inlining.Always)]
        public static uint dot(uint x, uint y) => x * y;

        [MethodImpl(Inlining.Always)]
        public static double dot(double2 x, double2 y) => x.x * y.x + x.y * y.y;

        [MethodImpl(Inlining.Always)]
        public static double dot(double3 x, double3 y) => x.x * y.x + x.y * y.y + x.z * y.z;

        [MethodImpl(Inlining.Always)]
        public static double dot(double4 x, double4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;

        [MethodImpl(Inlining.Always)]
        public static float dot(float2 x, float2 y) => x.x * y.x + x.y * y.y;

        [MethodImpl(Inlining.Always)]
        public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;

        [MethodImpl(Inlining.Always)]
        public static float dot(float4 x, float4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;

        [MethodImpl(Inlining.Always)]
        public static int dot(int2 x, int2 y) => x.x * y.x + x.y * y.y;

        [MethodImpl(Inlining.Always)]
        public static int dot(int3 x, int3 y) => x.x * y.x + x.y * y.y + x.z * y.z;

        [MethodImpl(Inlining.Always)]
        public static int dot(int4 x, int4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;

        [MethodImpl(Inlining.Always)]
        public static uint dot(uint2 x, uint2 y) => x.x * y.x + x.y * y.y;

        [MethodImpl(Inlining.Always)]
        public static uint dot(uint3 x, uint3 y) => x.x * y.x + x.y * y.y + x.z * y.z;

        [MethodImpl(Inlining.Always)]
        public static uint dot(uint4 x, uint4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;

        [MethodImpl(Inlining.Always)]
        public static double3 cross(double3 x, double3 y) => (x * y.yzx - x.yzx * y).yzx;

        [MethodImpl(Inlining.Always)]
        public static float3 cross(float3 x, float3 y) => (x * y.yzx - x.yzx * y).yzx;

        [MethodImpl(Inlining.Always)]
        public static double length(double x) => abs(x);

        [MethodImpl(Inlining.Always)]
        public static float length(float x) => abs(x);

        [MethodImpl(Inlining.Always)]
        public static double length(double2 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static double length(double3 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static double length(double4 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static float length(float2 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static float length(float3 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static float length(float4 x) => sqrt(dot(x, x));

        [MethodImpl(Inlining.Always)]
        public static double lengthsq(double x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static float lengthsq(float x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static double lengthsq(double2 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static double lengthsq(double3 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static double lengthsq(double4 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static float lengthsq(float2 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static float lengthsq(float3 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static float lengthsq(float4 x) => dot(x, x);

        [MethodImpl(Inlining.Always)]
        public static double distance(double x, double y) => abs(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distance(float x, float y) => abs(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distance(double2 x, double2 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distance(double3 x, double3 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distance(double4 x, double4 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distance(float2 x, float2 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distance(float3 x, float3 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distance(float4 x, float4 y) => length(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distancesq(double x, double y) => (y - x) * (y - x);

        [MethodImpl(Inlining.Always)]
        public static float distancesq(float x, float y) => (y - x) * (y - x);

        [MethodImpl(Inlining.Always)]
        public static double distancesq(double2 x, double2 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distancesq(double3 x, double3 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static double distancesq(double4 x, double4 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distancesq(float2 x, float2 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distancesq(float3 x, float3 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static float distancesq(float4 x, float4 y) => lengthsq(y - x);

        [MethodImpl(Inlining.Always)]
        public static double2 normalize(double2 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static double3 normalize(double3 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static double4 normalize(double4 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static float2 normalize(float2 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static float4 normalize(float4 x) => rsqrt(dot(x, x)) * x;

        [MethodImpl(Inlining.Always)]
        public static double2 normalizesafe(double2 x, double2 defaultvalue = default)
        {
            double lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static double3 normalizesafe(double3 x, double3 defaultvalue = default)
        {
            double lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static double4 normalizesafe(double4 x, double4 defaultvalue = default)
        {
            double lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static float2 normalizesafe(float2 x, float2 defaultvalue = default)
        {
            float lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static float3 normalizesafe(float3 x, float3 defaultvalue = default)
        {
            float lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static float4 normalizesafe(float4 x, float4 defaultvalue = default)
        {
            float lengthSq = dot(x, x);
            return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
        }

        [MethodImpl(Inlining.Always)]
        public static double2 reflect(double2 i, double2 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static double3 reflect(double3 i, double3 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static double4 reflect(double4 i, double4 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static float2 reflect(float2 i, float2 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static float3 reflect(float3 i, float3 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static float4 reflect(float4 i, float4 n) => i - 2 * n * dot(i, n);

        [MethodImpl(Inlining.Always)]
        public static double2 project(double2 a, double2 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static double3 project(double3 a, double3 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static double4 project(double4 a, double4 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static float2 project(float2 a, float2 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static float3 project(float3 a, float3 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static float4 project(float4 a, float4 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

        [MethodImpl(Inlining.Always)]
        public static double mul(double a, double b) => a * b;

        [MethodImpl(Inlining.Always)]
        public static int mul(int a, int b) => a * b;

        [MethodImpl(Inlining.Always)]
        public static float mul(float a, float b) => a * b;

        [MethodImpl(Inlining.Always)]
        public static uint mul(uint a, uint b) => a * b;

        [MethodImpl(Inlining.Always)]
        public static double mul(double2 a, double2 b) => a.x * b.x + a.y * b.y;

        [MethodImpl(Inlining.Always)]
        public static double mul(double3 a, double3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        [MethodImpl(Inlining.Always)]
        public static double mul(double4 a, double4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        [MethodImpl(Inlining.Always)]
        public static float mul(float2 a, float2 b) => a.x * b.x + a.y * b.y;

        [MethodImpl(Inlining.Always)]
        public static float mul(float3 a, float3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        [MethodImpl(Inlining.Always)]
        public static float mul(float4 a, float4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        [MethodImpl(Inlining.Always)]
        public static int mul(int2 a, int2 b) => a.x * b.x + a.y * b.y;

        [MethodImpl(Inlining.Always)]
        public static int mul(int3 a, int3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        [MethodImpl(Inlining.Always)]
        public static int mul(int4 a, int4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

        [MethodImpl(Inlining.Always)]
        public static uint mul(uint2 a, uint2 b) => a.x * b.x + a.y * b.y;

        [MethodImpl(Inlining.Always)]
        public static uint mul(uint3 a, uint3 b) => a.x * b.x + a.y * b.y + a.z * b.z;

        [MethodImpl(Inlining.Always)]
        public static uint mul(uint4 a, uint4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    }
}
