// A plain reading of Unity's signatures, one line a component.
using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static double sin(double x) => Math.Sin(x);

        [MethodImpl(Inlining.Always)]
        public static float sin(float x) => (float)Math.Sin(x);

        [MethodImpl(Inlining.Always)]
        public static double2 sin(double2 x) =>
            new double2(sin(x.x), sin(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 sin(double3 x) =>
            new double3(sin(x.x), sin(x.y), sin(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 sin(double4 x) =>
            new double4(sin(x.x), sin(x.y), sin(x.z), sin(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 sin(float2 x) =>
            new float2(sin(x.x), sin(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 sin(float3 x) =>
            new float3(sin(x.x), sin(x.y), sin(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 sin(float4 x) =>
            new float4(sin(x.x), sin(x.y), sin(x.z), sin(x.w));

        [MethodImpl(Inlining.Always)]
        public static double cos(double x) => Math.Cos(x);

        [MethodImpl(Inlining.Always)]
        public static float cos(float x) => (float)Math.Cos(x);

        [MethodImpl(Inlining.Always)]
        public static double2 cos(double2 x) =>
            new double2(cos(x.x), cos(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 cos(double3 x) =>
            new double3(cos(x.x), cos(x.y), cos(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 cos(double4 x) =>
            new double4(cos(x.x), cos(x.y), cos(x.z), cos(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 cos(float2 x) =>
            new float2(cos(x.x), cos(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 cos(float3 x) =>
            new float3(cos(x.x), cos(x.y), cos(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 cos(float4 x) =>
            new float4(cos(x.x), cos(x.y), cos(x.z), cos(x.w));

        [MethodImpl(Inlining.Always)]
        public static double tan(double x) => Math.Tan(x);

        [MethodImpl(Inlining.Always)]
        public static float tan(float x) => (float)Math.Tan(x);

        [MethodImpl(Inlining.Always)]
        public static double2 tan(double2 x) =>
            new double2(tan(x.x), tan(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 tan(double3 x) =>
            new double3(tan(x.x), tan(x.y), tan(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 tan(double4 x) =>
            new double4(tan(x.x), tan(x.y), tan(x.z), tan(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 tan(float2 x) =>
            new float2(tan(x.x), tan(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 tan(float3 x) =>
            new float3(tan(x.x), tan(x.y), tan(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 tan(float4 x) =>
            new float4(tan(x.x), tan(x.y), tan(x.z), tan(x.w));

        [MethodImpl(Inlining.Always)]
        public static double asin(double x) => Math.Asin(x);

        [MethodImpl(Inlining.Always)]
        public static float asin(float x) => (float)Math.Asin(x);

        [MethodImpl(Inlining.Always)]
        public static double2 asin(double2 x) =>
            new double2(asin(x.x), asin(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 asin(double3 x) =>
            new double3(asin(x.x), asin(x.y), asin(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 asin(double4 x) =>
            new double4(asin(x.x), asin(x.y), asin(x.z), asin(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 asin(float2 x) =>
            new float2(asin(x.x), asin(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 asin(float3 x) =>
            new float3(asin(x.x), asin(x.y), asin(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 asin(float4 x) =>
            new float4(asin(x.x), asin(x.y), asin(x.z), asin(x.w));

        [MethodImpl(Inlining.Always)]
        public static double acos(double x) => Math.Acos(x);

        [MethodImpl(Inlining.Always)]
        public static float acos(float x) => (float)Math.Acos(x);

        [MethodImpl(Inlining.Always)]
        public static double2 acos(double2 x) =>
            new double2(acos(x.x), acos(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 acos(double3 x) =>
            new double3(acos(x.x), acos(x.y), acos(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 acos(double4 x) =>
            new double4(acos(x.x), acos(x.y), acos(x.z), acos(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 acos(float2 x) =>
            new float2(acos(x.x), acos(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 acos(float3 x) =>
            new float3(acos(x.x), acos(x.y), acos(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 acos(float4 x) =>
            new float4(acos(x.x), acos(x.y), acos(x.z), acos(x.w));

        [MethodImpl(Inlining.Always)]
        public static double atan(double x) => Math.Atan(x);

        [MethodImpl(Inlining.Always)]
        public static float atan(float x) => (float)Math.Atan(x);

        [MethodImpl(Inlining.Always)]
        public static double2 atan(double2 x) =>
            new double2(atan(x.x), atan(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 atan(double3 x) =>
            new double3(atan(x.x), atan(x.y), atan(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 atan(double4 x) =>
            new double4(atan(x.x), atan(x.y), atan(x.z), atan(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 atan(float2 x) =>
            new float2(atan(x.x), atan(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 atan(float3 x) =>
            new float3(atan(x.x), atan(x.y), atan(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 atan(float4 x) =>
            new float4(atan(x.x), atan(x.y), atan(x.z), atan(x.w));

        [MethodImpl(Inlining.Always)]
        public static double atan2(double y, double x) => Math.Atan2(y, x);

        [MethodImpl(Inlining.Always)]
        public static float atan2(float y, float x) => (float)Math.Atan2(y, x);

        [MethodImpl(Inlining.Always)]
        public static double2 atan2(double2 y, double2 x) =>
            new double2(atan2(y.x, x.x), atan2(y.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 atan2(double3 y, double3 x) =>
            new double3(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 atan2(double4 y, double4 x) =>
            new double4(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z), atan2(y.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 atan2(float2 y, float2 x) =>
            new float2(atan2(y.x, x.x), atan2(y.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 atan2(float3 y, float3 x) =>
            new float3(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 atan2(float4 y, float4 x) =>
            new float4(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z), atan2(y.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static void sincos(double x, out double s, out double c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(float x, out float s, out float c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(double2 x, out double2 s, out double2 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(double3 x, out double3 s, out double3 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(double4 x, out double4 s, out double4 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(float2 x, out float2 s, out float2 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(float3 x, out float3 s, out float3 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static void sincos(float4 x, out float4 s, out float4 c)
        {
            s = sin(x);
            c = cos(x);
        }

        [MethodImpl(Inlining.Always)]
        public static double sinh(double x) => Math.Sinh(x);

        [MethodImpl(Inlining.Always)]
        public static float sinh(float x) => (float)Math.Sinh(x);

        [MethodImpl(Inlining.Always)]
        public static double2 sinh(double2 x) =>
            new double2(sinh(x.x), sinh(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 sinh(double3 x) =>
            new double3(sinh(x.x), sinh(x.y), sinh(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 sinh(double4 x) =>
            new double4(sinh(x.x), sinh(x.y), sinh(x.z), sinh(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 sinh(float2 x) =>
            new float2(sinh(x.x), sinh(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 sinh(float3 x) =>
            new float3(sinh(x.x), sinh(x.y), sinh(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 sinh(float4 x) =>
            new float4(sinh(x.x), sinh(x.y), sinh(x.z), sinh(x.w));

        [MethodImpl(Inlining.Always)]
        public static double cosh(double x) => Math.Cosh(x);

        [MethodImpl(Inlining.Always)]
        public static float cosh(float x) => (float)Math.Cosh(x);

        [MethodImpl(Inlining.Always)]
        public static double2 cosh(double2 x) =>
            new double2(cosh(x.x), cosh(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 cosh(double3 x) =>
            new double3(cosh(x.x), cosh(x.y), cosh(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 cosh(double4 x) =>
            new double4(cosh(x.x), cosh(x.y), cosh(x.z), cosh(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 cosh(float2 x) =>
            new float2(cosh(x.x), cosh(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 cosh(float3 x) =>
            new float3(cosh(x.x), cosh(x.y), cosh(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 cosh(float4 x) =>
            new float4(cosh(x.x), cosh(x.y), cosh(x.z), cosh(x.w));

        [MethodImpl(Inlining.Always)]
        public static double tanh(double x) => Math.Tanh(x);

        [MethodImpl(Inlining.Always)]
        public static float tanh(float x) => (float)Math.Tanh(x);

        [MethodImpl(Inlining.Always)]
        public static double2 tanh(double2 x) =>
            new double2(tanh(x.x), tanh(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 tanh(double3 x) =>
            new double3(tanh(x.x), tanh(x.y), tanh(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 tanh(double4 x) =>
            new double4(tanh(x.x), tanh(x.y), tanh(x.z), tanh(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 tanh(float2 x) =>
            new float2(tanh(x.x), tanh(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 tanh(float3 x) =>
            new float3(tanh(x.x), tanh(x.y), tanh(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 tanh(float4 x) =>
            new float4(tanh(x.x), tanh(x.y), tanh(x.z), tanh(x.w));

        [MethodImpl(Inlining.Always)]
        public static double exp(double x) => Math.Exp(x);

        [MethodImpl(Inlining.Always)]
        public static float exp(float x) => (float)Math.Exp(x);

        [MethodImpl(Inlining.Always)]
        public static double2 exp(double2 x) =>
            new double2(exp(x.x), exp(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 exp(double3 x) =>
            new double3(exp(x.x), exp(x.y), exp(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 exp(double4 x) =>
            new double4(exp(x.x), exp(x.y), exp(x.z), exp(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 exp(float2 x) =>
            new float2(exp(x.x), exp(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 exp(float3 x) =>
            new float3(exp(x.x), exp(x.y), exp(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 exp(float4 x) =>
            new float4(exp(x.x), exp(x.y), exp(x.z), exp(x.w));

        [MethodImpl(Inlining.Always)]
        public static double exp2(double x) => Math.Exp(x * 0.693147180559945309);

        [MethodImpl(Inlining.Always)]
        public static float exp2(float x) => (float)Math.Exp(x * 0.69314718f);

        [MethodImpl(Inlining.Always)]
        public static double2 exp2(double2 x) =>
            new double2(exp2(x.x), exp2(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 exp2(double3 x) =>
            new double3(exp2(x.x), exp2(x.y), exp2(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 exp2(double4 x) =>
            new double4(exp2(x.x), exp2(x.y), exp2(x.z), exp2(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 exp2(float2 x) =>
            new float2(exp2(x.x), exp2(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 exp2(float3 x) =>
            new float3(exp2(x.x), exp2(x.y), exp2(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 exp2(float4 x) =>
            new float4(exp2(x.x), exp2(x.y), exp2(x.z), exp2(x.w));

        [MethodImpl(Inlining.Always)]
        public static double exp10(double x) => Math.Exp(x * 2.302585092994045684);

        [MethodImpl(Inlining.Always)]
        public static float exp10(float x) => (float)Math.Exp(x * 2.30258509f);

        [MethodImpl(Inlining.Always)]
        public static double2 exp10(double2 x) =>
            new double2(exp10(x.x), exp10(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 exp10(double3 x) =>
            new double3(exp10(x.x), exp10(x.y), exp10(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 exp10(double4 x) =>
            new double4(exp10(x.x), exp10(x.y), exp10(x.z), exp10(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 exp10(float2 x) =>
            new float2(exp10(x.x), exp10(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 exp10(float3 x) =>
            new float3(exp10(x.x), exp10(x.y), exp10(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 exp10(float4 x) =>
            new float4(exp10(x.x), exp10(x.y), exp10(x.z), exp10(x.w));

        [MethodImpl(Inlining.Always)]
        public static double log(double x) => Math.Log(x);

        [MethodImpl(Inlining.Always)]
        public static float log(float x) => (float)Math.Log(x);

        [MethodImpl(Inlining.Always)]
        public static double2 log(double2 x) =>
            new double2(log(x.x), log(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 log(double3 x) =>
            new double3(log(x.x), log(x.y), log(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 log(double4 x) =>
            new double4(log(x.x), log(x.y), log(x.z), log(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 log(float2 x) =>
            new float2(log(x.x), log(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 log(float3 x) =>
            new float3(log(x.x), log(x.y), log(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 log(float4 x) =>
            new float4(log(x.x), log(x.y), log(x.z), log(x.w));

        [MethodImpl(Inlining.Always)]
        public static double log2(double x) => Math.Log(x, 2.0);

        [MethodImpl(Inlining.Always)]
        public static float log2(float x) => (float)Math.Log(x, 2.0f);

        [MethodImpl(Inlining.Always)]
        public static double2 log2(double2 x) =>
            new double2(log2(x.x), log2(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 log2(double3 x) =>
            new double3(log2(x.x), log2(x.y), log2(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 log2(double4 x) =>
            new double4(log2(x.x), log2(x.y), log2(x.z), log2(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 log2(float2 x) =>
            new float2(log2(x.x), log2(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 log2(float3 x) =>
            new float3(log2(x.x), log2(x.y), log2(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 log2(float4 x) =>
            new float4(log2(x.x), log2(x.y), log2(x.z), log2(x.w));

        [MethodImpl(Inlining.Always)]
        public static double log10(double x) => Math.Log10(x);

        [MethodImpl(Inlining.Always)]
        public static float log10(float x) => (float)Math.Log10(x);

        [MethodImpl(Inlining.Always)]
        public static double2 log10(double2 x) =>
            new double2(log10(x.x), log10(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 log10(double3 x) =>
            new double3(log10(x.x), log10(x.y), log10(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 log10(double4 x) =>
            new double4(log10(x.x), log10(x.y), log10(x.z), log10(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 log10(float2 x) =>
            new float2(log10(x.x), log10(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 log10(float3 x) =>
            new float3(log10(x.x), log10(x.y), log10(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 log10(float4 x) =>
            new float4(log10(x.x), log10(x.y), log10(x.z), log10(x.w));

        [MethodImpl(Inlining.Always)]
        public static double pow(double x, double y) => Math.Pow(x, y);

        [MethodImpl(Inlining.Always)]
        public static float pow(float x, float y) => (float)Math.Pow(x, y);

        [MethodImpl(Inlining.Always)]
        public static double2 pow(double2 x, double2 y) =>
            new double2(pow(x.x, y.x), pow(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static double3 pow(double3 x, double3 y) =>
            new double3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static double4 pow(double4 x, double4 y) =>
            new double4(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z), pow(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static float2 pow(float2 x, float2 y) =>
            new float2(pow(x.x, y.x), pow(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static float3 pow(float3 x, float3 y) =>
            new float3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static float4 pow(float4 x, float4 y) =>
            new float4(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z), pow(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static double sqrt(double x) => Math.Sqrt(x);

        [MethodImpl(Inlining.Always)]
        public static float sqrt(float x) => MathF.Sqrt(x);

        [MethodImpl(Inlining.Always)]
        public static double2 sqrt(double2 x) =>
            new double2(sqrt(x.x), sqrt(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 sqrt(double3 x) =>
            new double3(sqrt(x.x), sqrt(x.y), sqrt(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 sqrt(double4 x) =>
            new double4(sqrt(x.x), sqrt(x.y), sqrt(x.z), sqrt(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 sqrt(float2 x) =>
            new float2(sqrt(x.x), sqrt(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 sqrt(float3 x) =>
            new float3(sqrt(x.x), sqrt(x.y), sqrt(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 sqrt(float4 x) =>
            new float4(sqrt(x.x), sqrt(x.y), sqrt(x.z), sqrt(x.w));

        [MethodImpl(Inlining.Always)]
        public static double rsqrt(double x) => 1.0 / sqrt(x);

        [MethodImpl(Inlining.Always)]
        public static float rsqrt(float x) => 1.0f / sqrt(x);

        [MethodImpl(Inlining.Always)]
        public static double2 rsqrt(double2 x) =>
            new double2(rsqrt(x.x), rsqrt(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 rsqrt(double3 x) =>
            new double3(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 rsqrt(double4 x) =>
            new double4(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z), rsqrt(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 rsqrt(float2 x) =>
            new float2(rsqrt(x.x), rsqrt(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 rsqrt(float3 x) =>
            new float3(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 rsqrt(float4 x) =>
            new float4(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z), rsqrt(x.w));

        [MethodImpl(Inlining.Always)]
        public static double rcp(double x) => 1.0 / x;

        [MethodImpl(Inlining.Always)]
        public static float rcp(float x) => 1.0f / x;

        [MethodImpl(Inlining.Always)]
        public static double2 rcp(double2 x) =>
            new double2(rcp(x.x), rcp(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 rcp(double3 x) =>
            new double3(rcp(x.x), rcp(x.y), rcp(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 rcp(double4 x) =>
            new double4(rcp(x.x), rcp(x.y), rcp(x.z), rcp(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 rcp(float2 x) =>
            new float2(rcp(x.x), rcp(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 rcp(float3 x) =>
            new float3(rcp(x.x), rcp(x.y), rcp(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 rcp(float4 x) =>
            new float4(rcp(x.x), rcp(x.y), rcp(x.z), rcp(x.w));

        [MethodImpl(Inlining.Always)]
        public static double floor(double x) => Math.Floor(x);

        [MethodImpl(Inlining.Always)]
        public static float floor(float x) => MathF.Floor(x);

        [MethodImpl(Inlining.Always)]
        public static double2 floor(double2 x) =>
            new double2(floor(x.x), floor(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 floor(double3 x) =>
            new double3(floor(x.x), floor(x.y), floor(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 floor(double4 x) =>
            new double4(floor(x.x), floor(x.y), floor(x.z), floor(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 floor(float2 x) =>
            new float2(floor(x.x), floor(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 floor(float3 x) =>
            new float3(floor(x.x), floor(x.y), floor(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 floor(float4 x) =>
            new float4(floor(x.x), floor(x.y), floor(x.z), floor(x.w));

        [MethodImpl(Inlining.Always)]
        public static double ceil(double x) => Math.Ceiling(x);

        [MethodImpl(Inlining.Always)]
        public static float ceil(float x) => MathF.Ceiling(x);

        [MethodImpl(Inlining.Always)]
        public static double2 ceil(double2 x) =>
            new double2(ceil(x.x), ceil(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 ceil(double3 x) =>
            new double3(ceil(x.x), ceil(x.y), ceil(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 ceil(double4 x) =>
            new double4(ceil(x.x), ceil(x.y), ceil(x.z), ceil(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 ceil(float2 x) =>
            new float2(ceil(x.x), ceil(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 ceil(float3 x) =>
            new float3(ceil(x.x), ceil(x.y), ceil(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 ceil(float4 x) =>
            new float4(ceil(x.x), ceil(x.y), ceil(x.z), ceil(x.w));

        [MethodImpl(Inlining.Always)]
        public static double round(double x) => Math.Round(x);

        [MethodImpl(Inlining.Always)]
        public static float round(float x) => MathF.Round(x);

        [MethodImpl(Inlining.Always)]
        public static double2 round(double2 x) =>
            new double2(round(x.x), round(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 round(double3 x) =>
            new double3(round(x.x), round(x.y), round(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 round(double4 x) =>
            new double4(round(x.x), round(x.y), round(x.z), round(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 round(float2 x) =>
            new float2(round(x.x), round(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 round(float3 x) =>
            new float3(round(x.x), round(x.y), round(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 round(float4 x) =>
            new float4(round(x.x), round(x.y), round(x.z), round(x.w));

        [MethodImpl(Inlining.Always)]
        public static double trunc(double x) => Math.Truncate(x);

        [MethodImpl(Inlining.Always)]
        public static float trunc(float x) => MathF.Truncate(x);

        [MethodImpl(Inlining.Always)]
        public static double2 trunc(double2 x) =>
            new double2(trunc(x.x), trunc(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 trunc(double3 x) =>
            new double3(trunc(x.x), trunc(x.y), trunc(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 trunc(double4 x) =>
            new double4(trunc(x.x), trunc(x.y), trunc(x.z), trunc(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 trunc(float2 x) =>
            new float2(trunc(x.x), trunc(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 trunc(float3 x) =>
            new float3(trunc(x.x), trunc(x.y), trunc(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 trunc(float4 x) =>
            new float4(trunc(x.x), trunc(x.y), trunc(x.z), trunc(x.w));

        [MethodImpl(Inlining.Always)]
        public static double frac(double x) => x - floor(x);

        [MethodImpl(Inlining.Always)]
        public static float frac(float x) => x - floor(x);

        [MethodImpl(Inlining.Always)]
        public static double2 frac(double2 x) =>
            new double2(frac(x.x), frac(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 frac(double3 x) =>
            new double3(frac(x.x), frac(x.y), frac(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 frac(double4 x) =>
            new double4(frac(x.x), frac(x.y), frac(x.z), frac(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 frac(float2 x) =>
            new float2(frac(x.x), frac(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 frac(float3 x) =>
            new float3(frac(x.x), frac(x.y), frac(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 frac(float4 x) =>
            new float4(frac(x.x), frac(x.y), frac(x.z), frac(x.w));

        [MethodImpl(Inlining.Always)]
        public static double fmod(double x, double y) => x % y;

        [MethodImpl(Inlining.Always)]
        public static float fmod(float x, float y) => x % y;

        [MethodImpl(Inlining.Always)]
        public static double2 fmod(double2 x, double2 y) =>
            new double2(fmod(x.x, y.x), fmod(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static double3 fmod(double3 x, double3 y) =>
            new double3(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static double4 fmod(double4 x, double4 y) =>
            new double4(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z), fmod(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static float2 fmod(float2 x, float2 y) =>
            new float2(fmod(x.x, y.x), fmod(x.y, y.y));

        [MethodImpl(Inlining.Always)]
        public static float3 fmod(float3 x, float3 y) =>
            new float3(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z));

        [MethodImpl(Inlining.Always)]
        public static float4 fmod(float4 x, float4 y) =>
            new float4(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z), fmod(x.w, y.w));

        [MethodImpl(Inlining.Always)]
        public static double modf(double x, out double i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static float modf(float x, out float i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static double2 modf(double2 x, out double2 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static double3 modf(double3 x, out double3 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static double4 modf(double4 x, out double4 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static float2 modf(float2 x, out float2 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static float3 modf(float3 x, out float3 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static float4 modf(float4 x, out float4 i)
        {
            i = trunc(x);
            return x - i;
        }

        [MethodImpl(Inlining.Always)]
        public static double degrees(double x) => x * TODEGREES_DBL;

        [MethodImpl(Inlining.Always)]
        public static float degrees(float x) => x * TODEGREES;

        [MethodImpl(Inlining.Always)]
        public static double2 degrees(double2 x) =>
            new double2(degrees(x.x), degrees(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 degrees(double3 x) =>
            new double3(degrees(x.x), degrees(x.y), degrees(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 degrees(double4 x) =>
            new double4(degrees(x.x), degrees(x.y), degrees(x.z), degrees(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 degrees(float2 x) =>
            new float2(degrees(x.x), degrees(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 degrees(float3 x) =>
            new float3(degrees(x.x), degrees(x.y), degrees(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 degrees(float4 x) =>
            new float4(degrees(x.x), degrees(x.y), degrees(x.z), degrees(x.w));

        [MethodImpl(Inlining.Always)]
        public static double radians(double x) => x * TORADIANS_DBL;

        [MethodImpl(Inlining.Always)]
        public static float radians(float x) => x * TORADIANS;

        [MethodImpl(Inlining.Always)]
        public static double2 radians(double2 x) =>
            new double2(radians(x.x), radians(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 radians(double3 x) =>
            new double3(radians(x.x), radians(x.y), radians(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 radians(double4 x) =>
            new double4(radians(x.x), radians(x.y), radians(x.z), radians(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 radians(float2 x) =>
            new float2(radians(x.x), radians(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 radians(float3 x) =>
            new float3(radians(x.x), radians(x.y), radians(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 radians(float4 x) =>
            new float4(radians(x.x), radians(x.y), radians(x.z), radians(x.w));

        [MethodImpl(Inlining.Always)]
        public static double square(double x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static int square(int x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static float square(float x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static uint square(uint x) => x * x;

        [MethodImpl(Inlining.Always)]
        public static double2 square(double2 x) =>
            new double2(square(x.x), square(x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 square(double3 x) =>
            new double3(square(x.x), square(x.y), square(x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 square(double4 x) =>
            new double4(square(x.x), square(x.y), square(x.z), square(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 square(float2 x) =>
            new float2(square(x.x), square(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 square(float3 x) =>
            new float3(square(x.x), square(x.y), square(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 square(float4 x) =>
            new float4(square(x.x), square(x.y), square(x.z), square(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 square(int2 x) =>
            new int2(square(x.x), square(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 square(int3 x) =>
            new int3(square(x.x), square(x.y), square(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 square(int4 x) =>
            new int4(square(x.x), square(x.y), square(x.z), square(x.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 square(uint2 x) =>
            new uint2(square(x.x), square(x.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 square(uint3 x) =>
            new uint3(square(x.x), square(x.y), square(x.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 square(uint4 x) =>
            new uint4(square(x.x), square(x.y), square(x.z), square(x.w));

        [MethodImpl(Inlining.Always)]
        public static double mad(double mulA, double mulB, double addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static int mad(int mulA, int mulB, int addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static long mad(long mulA, long mulB, long addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static float mad(float mulA, float mulB, float addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static uint mad(uint mulA, uint mulB, uint addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static ulong mad(ulong mulA, ulong mulB, ulong addC) => mulA * mulB + addC;

        [MethodImpl(Inlining.Always)]
        public static double2 mad(double2 mulA, double2 mulB, double2 addC) =>
            new double2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));

        [MethodImpl(Inlining.Always)]
        public static double3 mad(double3 mulA, double3 mulB, double3 addC) =>
            new double3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));

        [MethodImpl(Inlining.Always)]
        public static double4 mad(double4 mulA, double4 mulB, double4 addC) =>
            new double4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));

        [MethodImpl(Inlining.Always)]
        public static float2 mad(float2 mulA, float2 mulB, float2 addC) =>
            new float2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));

        [MethodImpl(Inlining.Always)]
        public static float3 mad(float3 mulA, float3 mulB, float3 addC) =>
            new float3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));

        [MethodImpl(Inlining.Always)]
        public static float4 mad(float4 mulA, float4 mulB, float4 addC) =>
            new float4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));

        [MethodImpl(Inlining.Always)]
        public static int2 mad(int2 mulA, int2 mulB, int2 addC) =>
            new int2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));

        [MethodImpl(Inlining.Always)]
        public static int3 mad(int3 mulA, int3 mulB, int3 addC) =>
            new int3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));

        [MethodImpl(Inlining.Always)]
        public static int4 mad(int4 mulA, int4 mulB, int4 addC) =>
            new int4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 mad(uint2 mulA, uint2 mulB, uint2 addC) =>
            new uint2(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 mad(uint3 mulA, uint3 mulB, uint3 addC) =>
            new uint3(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 mad(uint4 mulA, uint4 mulB, uint4 addC) =>
            new uint4(mad(mulA.x, mulB.x, addC.x), mad(mulA.y, mulB.y, addC.y), mad(mulA.z, mulB.z, addC.z), mad(mulA.w, mulB.w, addC.w));

        [MethodImpl(Inlining.Always)]
        public static double lerp(double start, double end, double t) => start + t * (end - start);

        [MethodImpl(Inlining.Always)]
        public static float lerp(float start, float end, float t) => start + t * (end - start);

        [MethodImpl(Inlining.Always)]
        public static double2 lerp(double2 start, double2 end, double t) =>
            new double2(lerp(start.x, end.x, t), lerp(start.y, end.y, t));

        [MethodImpl(Inlining.Always)]
        public static double2 lerp(double2 start, double2 end, double2 t) =>
            new double2(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y));

        [MethodImpl(Inlining.Always)]
        public static double3 lerp(double3 start, double3 end, double t) =>
            new double3(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t));

        [MethodImpl(Inlining.Always)]
        public static double3 lerp(double3 start, double3 end, double3 t) =>
            new double3(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z));

        [MethodImpl(Inlining.Always)]
        public static double4 lerp(double4 start, double4 end, double t) =>
            new double4(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t), lerp(start.w, end.w, t));

        [MethodImpl(Inlining.Always)]
        public static double4 lerp(double4 start, double4 end, double4 t) =>
            new double4(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z), lerp(start.w, end.w, t.w));

        [MethodImpl(Inlining.Always)]
        public static float2 lerp(float2 start, float2 end, float t) =>
            new float2(lerp(start.x, end.x, t), lerp(start.y, end.y, t));

        [MethodImpl(Inlining.Always)]
        public static float2 lerp(float2 start, float2 end, float2 t) =>
            new float2(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y));

        [MethodImpl(Inlining.Always)]
        public static float3 lerp(float3 start, float3 end, float t) =>
            new float3(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t));

        [MethodImpl(Inlining.Always)]
        public static float3 lerp(float3 start, float3 end, float3 t) =>
            new float3(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z));

        [MethodImpl(Inlining.Always)]
        public static float4 lerp(float4 start, float4 end, float t) =>
            new float4(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t), lerp(start.w, end.w, t));

        [MethodImpl(Inlining.Always)]
        public static float4 lerp(float4 start, float4 end, float4 t) =>
            new float4(lerp(start.x, end.x, t.x), lerp(start.y, end.y, t.y), lerp(start.z, end.z, t.z), lerp(start.w, end.w, t.w));

        [MethodImpl(Inlining.Always)]
        public static double unlerp(double start, double end, double x) => (x - start) / (end - start);

        [MethodImpl(Inlining.Always)]
        public static float unlerp(float start, float end, float x) => (x - start) / (end - start);

        [MethodImpl(Inlining.Always)]
        public static double2 unlerp(double2 start, double2 end, double2 x) =>
            new double2(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 unlerp(double3 start, double3 end, double3 x) =>
            new double3(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 unlerp(double4 start, double4 end, double4 x) =>
            new double4(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z), unlerp(start.w, end.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 unlerp(float2 start, float2 end, float2 x) =>
            new float2(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 unlerp(float3 start, float3 end, float3 x) =>
            new float3(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 unlerp(float4 start, float4 end, float4 x) =>
            new float4(unlerp(start.x, end.x, x.x), unlerp(start.y, end.y, x.y), unlerp(start.z, end.z, x.z), unlerp(start.w, end.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static double remap(double srcStart, double srcEnd, double dstStart, double dstEnd, double x) => lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

        [MethodImpl(Inlining.Always)]
        public static float remap(float srcStart, float srcEnd, float dstStart, float dstEnd, float x) => lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

        [MethodImpl(Inlining.Always)]
        public static double2 remap(double2 srcStart, double2 srcEnd, double2 dstStart, double2 dstEnd, double2 x) =>
            new double2(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static double3 remap(double3 srcStart, double3 srcEnd, double3 dstStart, double3 dstEnd, double3 x) =>
            new double3(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static double4 remap(double4 srcStart, double4 srcEnd, double4 dstStart, double4 dstEnd, double4 x) =>
            new double4(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z), remap(srcStart.w, srcEnd.w, dstStart.w, dstEnd.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 remap(float2 srcStart, float2 srcEnd, float2 dstStart, float2 dstEnd, float2 x) =>
            new float2(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 remap(float3 srcStart, float3 srcEnd, float3 dstStart, float3 dstEnd, float3 x) =>
            new float3(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 remap(float4 srcStart, float4 srcEnd, float4 dstStart, float4 dstEnd, float4 x) =>
            new float4(remap(srcStart.x, srcEnd.x, dstStart.x, dstEnd.x, x.x), remap(srcStart.y, srcEnd.y, dstStart.y, dstEnd.y, x.y), remap(srcStart.z, srcEnd.z, dstStart.z, dstEnd.z, x.z), remap(srcStart.w, srcEnd.w, dstStart.w, dstEnd.w, x.w));

        [MethodImpl(Inlining.Always)]
        public static double smoothstep(double xMin, double xMax, double x)
        {
            double t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static float smoothstep(float xMin, float xMax, float x)
        {
            float t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static double2 smoothstep(double2 xMin, double2 xMax, double2 x)
        {
            double2 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static double3 smoothstep(double3 xMin, double3 xMax, double3 x)
        {
            double3 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static double4 smoothstep(double4 xMin, double4 xMax, double4 x)
        {
            double4 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static float2 smoothstep(float2 xMin, float2 xMax, float2 x)
        {
            float2 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static float3 smoothstep(float3 xMin, float3 xMax, float3 x)
        {
            float3 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }

        [MethodImpl(Inlining.Always)]
        public static float4 smoothstep(float4 xMin, float4 xMax, float4 x)
        {
            float4 t = saturate((x - xMin) / (xMax - xMin));
            return t * t * (3 - 2 * t);
        }
    }
}
