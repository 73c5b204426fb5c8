// A plain reading of Unity's signatures, one line a component.
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static double min(double x, double y) => double.IsNaN(y) || x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static int min(int x, int y) => x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static long min(long x, long y) => x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static float min(float x, float y) => float.IsNaN(y) || x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static uint min(uint x, uint y) => x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static ulong min(ulong x, ulong y) => x < y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static double2 min(double2 x, double2 y) =>
            new double2(min(x.x, y.x), min(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static double3 min(double3 x, double3 y) =>
            new double3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static double4 min(double4 x, double4 y) =>
            new double4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static float2 min(float2 x, float2 y) =>
            new float2(min(x.x, y.x), min(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static float3 min(float3 x, float3 y) =>
            new float3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static float4 min(float4 x, float4 y) =>
            new float4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static int2 min(int2 x, int2 y) =>
            new int2(min(x.x, y.x), min(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static int3 min(int3 x, int3 y) =>
            new int3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static int4 min(int4 x, int4 y) =>
            new int4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 min(uint2 x, uint2 y) =>
            new uint2(min(x.x, y.x), min(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 min(uint3 x, uint3 y) =>
            new uint3(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 min(uint4 x, uint4 y) =>
            new uint4(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z), min(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static double max(double x, double y) => double.IsNaN(y) || x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static int max(int x, int y) => x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static long max(long x, long y) => x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static float max(float x, float y) => float.IsNaN(y) || x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static uint max(uint x, uint y) => x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static ulong max(ulong x, ulong y) => x > y ? x : y;

        [MethodImpl(Inlining.Always)]
        public static double2 max(double2 x, double2 y) =>
            new double2(max(x.x, y.x), max(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static double3 max(double3 x, double3 y) =>
            new double3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static double4 max(double4 x, double4 y) =>
            new double4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static float2 max(float2 x, float2 y) =>
            new float2(max(x.x, y.x), max(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static float3 max(float3 x, float3 y) =>
            new float3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static float4 max(float4 x, float4 y) =>
            new float4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static int2 max(int2 x, int2 y) =>
            new int2(max(x.x, y.x), max(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static int3 max(int3 x, int3 y) =>
            new int3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static int4 max(int4 x, int4 y) =>
            new int4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 max(uint2 x, uint2 y) =>
            new uint2(max(x.x, y.x), max(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 max(uint3 x, uint3 y) =>
            new uint3(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 max(uint4 x, uint4 y) =>
            new uint4(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z), max(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static double clamp(double valueToClamp, double lowerBound, double upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static int clamp(int valueToClamp, int lowerBound, int upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static long clamp(long valueToClamp, long lowerBound, long upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static float clamp(float valueToClamp, float lowerBound, float upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static uint clamp(uint valueToClamp, uint lowerBound, uint upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static ulong clamp(ulong valueToClamp, ulong lowerBound, ulong upperBound) => max(lowerBound, min(upperBound, valueToClamp));

        [MethodImpl(Inlining.Always)]
        public static double2 clamp(double2 valueToClamp, double2 lowerBound, double2 upperBound) =>
            new double2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));

        [MethodImpl(Inlining.Always)]
        public static double3 clamp(double3 valueToClamp, double3 lowerBound, double3 upperBound) =>
            new double3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));

        [MethodImpl(Inlining.Always)]
        public static double4 clamp(double4 valueToClamp, double4 lowerBound, double4 upperBound) =>
            new double4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));

        [MethodImpl(Inlining.Always)]
        public static float2 clamp(float2 valueToClamp, float2 lowerBound, float2 upperBound) =>
            new float2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));

        [MethodImpl(Inlining.Always)]
        public static float3 clamp(float3 valueToClamp, float3 lowerBound, float3 upperBound) =>
            new float3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));

        [MethodImpl(Inlining.Always)]
        public static float4 clamp(float4 valueToClamp, float4 lowerBound, float4 upperBound) =>
            new float4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));

        [MethodImpl(Inlining.Always)]
        public static int2 clamp(int2 valueToClamp, int2 lowerBound, int2 upperBound) =>
            new int2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));

        [MethodImpl(Inlining.Always)]
        public static int3 clamp(int3 valueToClamp, int3 lowerBound, int3 upperBound) =>
            new int3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));

        [MethodImpl(Inlining.Always)]
        public static int4 clamp(int4 valueToClamp, int4 lowerBound, int4 upperBound) =>
            new int4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 clamp(uint2 valueToClamp, uint2 lowerBound, uint2 upperBound) =>
            new uint2(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 clamp(uint3 valueToClamp, uint3 lowerBound, uint3 upperBound) =>
            new uint3(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 clamp(uint4 valueToClamp, uint4 lowerBound, uint4 upperBound) =>
            new uint4(clamp(valueToClamp.x, lowerBound.x, upperBound.x), clamp(valueToClamp.y, lowerBound.y, upperBound.y), clamp(valueToClamp.z, lowerBound.z, upperBound.z), clamp(valueToClamp.w, lowerBound.w, upperBound.w));

        [MethodImpl(Inlining.Always)]
        public static double saturate(double x) => clamp(x, 0.0, 1.0);

        [MethodImpl(Inlining.Always)]
        public static float saturate(float x) => clamp(x, 0.0f, 1.0f);

        [MethodImpl(Inlining.Always)]
        public static double2 saturate(double2 x) =>
            new double2(saturate(x.x), saturate(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 saturate(double3 x) =>
            new double3(saturate(x.x), saturate(x.y), saturate(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 saturate(double4 x) =>
            new double4(saturate(x.x), saturate(x.y), saturate(x.z), saturate(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 saturate(float2 x) =>
            new float2(saturate(x.x), saturate(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 saturate(float3 x) =>
            new float3(saturate(x.x), saturate(x.y), saturate(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 saturate(float4 x) =>
            new float4(saturate(x.x), saturate(x.y), saturate(x.z), saturate(x.w));

        [MethodImpl(Inlining.Always)]
        public static double select(double falseValue, double trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static int select(int falseValue, int trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static long select(long falseValue, long trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static float select(float falseValue, float trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static uint select(uint falseValue, uint trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static ulong select(ulong falseValue, ulong trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static double2 select(double2 falseValue, double2 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static double2 select(double2 falseValue, double2 trueValue, bool2 test) =>
            new double2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));

        [MethodImpl(Inlining.Always)]
        public static double3 select(double3 falseValue, double3 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static double3 select(double3 falseValue, double3 trueValue, bool3 test) =>
            new double3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));

        [MethodImpl(Inlining.Always)]
        public static double4 select(double4 falseValue, double4 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static double4 select(double4 falseValue, double4 trueValue, bool4 test) =>
            new double4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));

        [MethodImpl(Inlining.Always)]
        public static float2 select(float2 falseValue, float2 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static float2 select(float2 falseValue, float2 trueValue, bool2 test) =>
            new float2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));

        [MethodImpl(Inlining.Always)]
        public static float3 select(float3 falseValue, float3 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static float3 select(float3 falseValue, float3 trueValue, bool3 test) =>
            new float3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));

        [MethodImpl(Inlining.Always)]
        public static float4 select(float4 falseValue, float4 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static float4 select(float4 falseValue, float4 trueValue, bool4 test) =>
            new float4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));

        [MethodImpl(Inlining.Always)]
        public static int2 select(int2 falseValue, int2 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static int2 select(int2 falseValue, int2 trueValue, bool2 test) =>
            new int2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));

        [MethodImpl(Inlining.Always)]
        public static int3 select(int3 falseValue, int3 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static int3 select(int3 falseValue, int3 trueValue, bool3 test) =>
            new int3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));

        [MethodImpl(Inlining.Always)]
        public static int4 select(int4 falseValue, int4 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static int4 select(int4 falseValue, int4 trueValue, bool4 test) =>
            new int4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 select(uint2 falseValue, uint2 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static uint2 select(uint2 falseValue, uint2 trueValue, bool2 test) =>
            new uint2(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 select(uint3 falseValue, uint3 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static uint3 select(uint3 falseValue, uint3 trueValue, bool3 test) =>
            new uint3(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 select(uint4 falseValue, uint4 trueValue, bool test) => test ? trueValue : falseValue;

        [MethodImpl(Inlining.Always)]
        public static uint4 select(uint4 falseValue, uint4 trueValue, bool4 test) =>
            new uint4(select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y), select(falseValue.z, trueValue.z, test.z), select(falseValue.w, trueValue.w, test.w));

        [MethodImpl(Inlining.Always)]
        public static bool any(bool2 x) => x.x || x.y;

        [MethodImpl(Inlining.Always)]
        public static bool any(bool3 x) => x.x || x.y || x.z;

        [MethodImpl(Inlining.Always)]
        public static bool any(bool4 x) => x.x || x.y || x.z || x.w;

        [MethodImpl(Inlining.Always)]
        public static bool any(double2 x) => x.x != 0 || x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(double3 x) => x.x != 0 || x.y != 0 || x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(double4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(float2 x) => x.x != 0 || x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(float3 x) => x.x != 0 || x.y != 0 || x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(float4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(int2 x) => x.x != 0 || x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(int3 x) => x.x != 0 || x.y != 0 || x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(int4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(uint2 x) => x.x != 0 || x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(uint3 x) => x.x != 0 || x.y != 0 || x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool any(uint4 x) => x.x != 0 || x.y != 0 || x.z != 0 || x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(bool2 x) => x.x && x.y;

        [MethodImpl(Inlining.Always)]
        public static bool all(bool3 x) => x.x && x.y && x.z;

        [MethodImpl(Inlining.Always)]
        public static bool all(bool4 x) => x.x && x.y && x.z && x.w;

        [MethodImpl(Inlining.Always)]
        public static bool all(double2 x) => x.x != 0 && x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(double3 x) => x.x != 0 && x.y != 0 && x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(double4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(float2 x) => x.x != 0 && x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(float3 x) => x.x != 0 && x.y != 0 && x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(float4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(int2 x) => x.x != 0 && x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(int3 x) => x.x != 0 && x.y != 0 && x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(int4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(uint2 x) => x.x != 0 && x.y != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(uint3 x) => x.x != 0 && x.y != 0 && x.z != 0;

        [MethodImpl(Inlining.Always)]
        public static bool all(uint4 x) => x.x != 0 && x.y != 0 && x.z != 0 && x.w != 0;

        [MethodImpl(Inlining.Always)]
        public static double step(double threshold, double x) => select(0.0, 1.0, x >= threshold);

        [MethodImpl(Inlining.Always)]
        public static float step(float threshold, float x) => select(0.0f, 1.0f, x >= threshold);

        [MethodImpl(Inlining.Always)]
        public static double2 step(double2 threshold, double2 x) =>
            new double2(step(threshold.x, x.x), step(threshold.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 step(double3 threshold, double3 x) =>
            new double3(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 step(double4 threshold, double4 x) =>
            new double4(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z), step(threshold.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 step(float2 threshold, float2 x) =>
            new float2(step(threshold.x, x.x), step(threshold.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 step(float3 threshold, float3 x) =>
            new float3(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 step(float4 threshold, float4 x) =>
            new float4(step(threshold.x, x.x), step(threshold.y, x.y), step(threshold.z, x.z), step(threshold.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static double sign(double x) => x == 0 ? 0 : (x > 0.0 ? 1.0 : 0.0) - (x < 0.0 ? 1.0 : 0.0);

        [MethodImpl(Inlining.Always)]
        public static int sign(int x) => (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);

        [MethodImpl(Inlining.Always)]
        public static float sign(float x) => (x > 0.0f ? 1.0f : 0.0f) - (x < 0.0f ? 1.0f : 0.0f);

        [MethodImpl(Inlining.Always)]
        public static double2 sign(double2 x) =>
            new double2(sign(x.x), sign(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 sign(double3 x) =>
            new double3(sign(x.x), sign(x.y), sign(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 sign(double4 x) =>
            new double4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 sign(float2 x) =>
            new float2(sign(x.x), sign(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 sign(float3 x) =>
            new float3(sign(x.x), sign(x.y), sign(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 sign(float4 x) =>
            new float4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 sign(int2 x) =>
            new int2(sign(x.x), sign(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 sign(int3 x) =>
            new int3(sign(x.x), sign(x.y), sign(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 sign(int4 x) =>
            new int4(sign(x.x), sign(x.y), sign(x.z), sign(x.w));

        [MethodImpl(Inlining.Always)]
        public static double abs(double x) => asdouble(asulong(x) & 0x7FFFFFFFFFFFFFFFul);

        [MethodImpl(Inlining.Always)]
        public static int abs(int x) => max(-x, x);

        [MethodImpl(Inlining.Always)]
        public static long abs(long x) => max(-x, x);

        [MethodImpl(Inlining.Always)]
        public static float abs(float x) => asfloat(asuint(x) & 0x7FFFFFFFu);

        [MethodImpl(Inlining.Always)]
        public static double2 abs(double2 x) =>
            new double2(abs(x.x), abs(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 abs(double3 x) =>
            new double3(abs(x.x), abs(x.y), abs(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 abs(double4 x) =>
            new double4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 abs(float2 x) =>
            new float2(abs(x.x), abs(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 abs(float3 x) =>
            new float3(abs(x.x), abs(x.y), abs(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 abs(float4 x) =>
            new float4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 abs(int2 x) =>
            new int2(abs(x.x), abs(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 abs(int3 x) =>
            new int3(abs(x.x), abs(x.y), abs(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 abs(int4 x) =>
            new int4(abs(x.x), abs(x.y), abs(x.z), abs(x.w));

        [MethodImpl(Inlining.Always)]
        public static double cmin(double2 x) => min(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static double cmin(double3 x) => min(min(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static double cmin(double4 x) => min(min(min(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static float cmin(float2 x) => min(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static float cmin(float3 x) => min(min(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static float cmin(float4 x) => min(min(min(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static int cmin(int2 x) => min(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static int cmin(int3 x) => min(min(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static int cmin(int4 x) => min(min(min(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static uint cmin(uint2 x) => min(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static uint cmin(uint3 x) => min(min(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static uint cmin(uint4 x) => min(min(min(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static double cmax(double2 x) => max(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static double cmax(double3 x) => max(max(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static double cmax(double4 x) => max(max(max(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static float cmax(float2 x) => max(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static float cmax(float3 x) => max(max(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static float cmax(float4 x) => max(max(max(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static int cmax(int2 x) => max(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static int cmax(int3 x) => max(max(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static int cmax(int4 x) => max(max(max(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static uint cmax(uint2 x) => max(x.x, x.y);

        [MethodImpl(Inlining.Always)]
        public static uint cmax(uint3 x) => max(max(x.x, x.y), x.z);

        [MethodImpl(Inlining.Always)]
        public static uint cmax(uint4 x) => max(max(max(x.x, x.y), x.z), x.w);

        [MethodImpl(Inlining.Always)]
        public static double csum(double2 x) => x.x + x.y;

        [MethodImpl(Inlining.Always)]
        public static double csum(double3 x) => x.x + x.y + x.z;

        [MethodImpl(Inlining.Always)]
        public static double csum(double4 x) => (x.x + x.y) + (x.z + x.w);

        [MethodImpl(Inlining.Always)]
        public static float csum(float2 x) => x.x + x.y;

        [MethodImpl(Inlining.Always)]
        public static float csum(float3 x) => x.x + x.y + x.z;

        [MethodImpl(Inlining.Always)]
        public static float csum(float4 x) => (x.x + x.y) + (x.z + x.w);

        [MethodImpl(Inlining.Always)]
        public static int csum(int2 x) => x.x + x.y;

        [MethodImpl(Inlining.Always)]
        public static int csum(int3 x) => x.x + x.y + x.z;

        [MethodImpl(Inlining.Always)]
        public static int csum(int4 x) => x.x + x.y + x.z + x.w;

        [MethodImpl(Inlining.Always)]
        public static uint csum(uint2 x) => x.x + x.y;

        [MethodImpl(Inlining.Always)]
        public static uint csum(uint3 x) => x.x + x.y + x.z;

        [MethodImpl(Inlining.Always)]
        public static uint csum(uint4 x) => x.x + x.y + x.z + x.w;

        [MethodImpl(Inlining.Always)]
        public static bool isfinite(double x) => abs(x) < double.PositiveInfinity;

        [MethodImpl(Inlining.Always)]
        public static bool isfinite(float x) => abs(x) < float.PositiveInfinity;

        [MethodImpl(Inlining.Always)]
        public static bool2 isfinite(double2 x) =>
            new bool2(isfinite(x.x), isfinite(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isfinite(double3 x) =>
            new bool3(isfinite(x.x), isfinite(x.y), isfinite(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isfinite(double4 x) =>
            new bool4(isfinite(x.x), isfinite(x.y), isfinite(x.z), isfinite(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool2 isfinite(float2 x) =>
            new bool2(isfinite(x.x), isfinite(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isfinite(float3 x) =>
            new bool3(isfinite(x.x), isfinite(x.y), isfinite(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isfinite(float4 x) =>
            new bool4(isfinite(x.x), isfinite(x.y), isfinite(x.z), isfinite(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool isinf(double x) => abs(x) == double.PositiveInfinity;

        [MethodImpl(Inlining.Always)]
        public static bool isinf(float x) => abs(x) == float.PositiveInfinity;

        [MethodImpl(Inlining.Always)]
        public static bool2 isinf(double2 x) =>
            new bool2(isinf(x.x), isinf(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isinf(double3 x) =>
            new bool3(isinf(x.x), isinf(x.y), isinf(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isinf(double4 x) =>
            new bool4(isinf(x.x), isinf(x.y), isinf(x.z), isinf(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool2 isinf(float2 x) =>
            new bool2(isinf(x.x), isinf(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isinf(float3 x) =>
            new bool3(isinf(x.x), isinf(x.y), isinf(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isinf(float4 x) =>
            new bool4(isinf(x.x), isinf(x.y), isinf(x.z), isinf(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool isnan(double x) => (asulong(x) & 0x7FFFFFFFFFFFFFFFul) > 0x7FF0000000000000ul;

        [MethodImpl(Inlining.Always)]
        public static bool isnan(float x) => (asuint(x) & 0x7FFFFFFFu) > 0x7F800000u;

        [MethodImpl(Inlining.Always)]
        public static bool2 isnan(double2 x) =>
            new bool2(isnan(x.x), isnan(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isnan(double3 x) =>
            new bool3(isnan(x.x), isnan(x.y), isnan(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isnan(double4 x) =>
            new bool4(isnan(x.x), isnan(x.y), isnan(x.z), isnan(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool2 isnan(float2 x) =>
            new bool2(isnan(x.x), isnan(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 isnan(float3 x) =>
            new bool3(isnan(x.x), isnan(x.y), isnan(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 isnan(float4 x) =>
            new bool4(isnan(x.x), isnan(x.y), isnan(x.z), isnan(x.w));
    }
}
