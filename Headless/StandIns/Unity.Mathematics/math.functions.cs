namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inlining.Always)] public static double sin(double x) => Math.Sin(x);
    [MethodImpl(Inlining.Always)] public static float sin(float x) => (float)Math.Sin(x);
    [MethodImpl(Inlining.Always)] public static double cos(double x) => Math.Cos(x);
    [MethodImpl(Inlining.Always)] public static float cos(float x) => (float)Math.Cos(x);
    [MethodImpl(Inlining.Always)] public static double tan(double x) => Math.Tan(x);
    [MethodImpl(Inlining.Always)] public static float tan(float x) => (float)Math.Tan(x);
    [MethodImpl(Inlining.Always)] public static float atan2(float y, float x) => (float)Math.Atan2(y, x);

    [MethodImpl(Inlining.Always)]
    public static void sincos(double x, out double s, out double c)
    {
        s = sin(x);
        c = cos(x);
    }

    [MethodImpl(Inlining.Always)] public static double exp(double x) => Math.Exp(x);
    [MethodImpl(Inlining.Always)] public static float exp(float x) => (float)Math.Exp(x);
    [MethodImpl(Inlining.Always)] public static double exp2(double x) => Math.Exp(x * 0.693147180559945309);
    [MethodImpl(Inlining.Always)] public static float exp2(float x) => (float)Math.Exp(x * 0.69314718f);
    [MethodImpl(Inlining.Always)] public static double3 exp2(double3 x) => new double3(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(Inlining.Always)] public static float3 exp2(float3 x) => new float3(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(Inlining.Always)] public static double log(double x) => Math.Log(x);
    [MethodImpl(Inlining.Always)] public static float log(float x) => (float)Math.Log(x);
    [MethodImpl(Inlining.Always)] public static float log2(float x) => (float)Math.Log(x, 2.0f);
    [MethodImpl(Inlining.Always)] public static double pow(double x, double y) => Math.Pow(x, y);
    [MethodImpl(Inlining.Always)] public static float pow(float x, float y) => (float)Math.Pow(x, y);
    [MethodImpl(Inlining.Always)]
    public static float3 pow(float3 x, float3 y) => new float3(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));

    [MethodImpl(Inlining.Always)] public static double sqrt(double x) => Math.Sqrt(x);
    [MethodImpl(Inlining.Always)] public static float sqrt(float x) => MathF.Sqrt(x);
    [MethodImpl(Inlining.Always)] internal static double rsqrt(double x) => 1.0 / sqrt(x);
    [MethodImpl(Inlining.Always)] internal static float rsqrt(float x) => 1.0f / sqrt(x);
    [MethodImpl(Inlining.Always)] public static double floor(double x) => Math.Floor(x);
    [MethodImpl(Inlining.Always)] public static float floor(float x) => MathF.Floor(x);
    [MethodImpl(Inlining.Always)] public static double3 floor(double3 x) => new double3(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(Inlining.Always)] public static float2 floor(float2 x) => new float2(floor(x.x), floor(x.y));
    [MethodImpl(Inlining.Always)] public static float3 floor(float3 x) => new float3(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(Inlining.Always)] public static double ceil(double x) => Math.Ceiling(x);
    [MethodImpl(Inlining.Always)] public static float ceil(float x) => MathF.Ceiling(x);
    [MethodImpl(Inlining.Always)] public static double3 ceil(double3 x) => new double3(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(Inlining.Always)] public static float3 ceil(float3 x) => new float3(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(Inlining.Always)] public static double round(double x) => Math.Round(x);
    [MethodImpl(Inlining.Always)] public static float round(float x) => MathF.Round(x);
    [MethodImpl(Inlining.Always)] public static double3 round(double3 x) => new double3(round(x.x), round(x.y), round(x.z));
    [MethodImpl(Inlining.Always)] public static float3 round(float3 x) => new float3(round(x.x), round(x.y), round(x.z));
    [MethodImpl(Inlining.Always)] public static float frac(float x) => x - floor(x);
    [MethodImpl(Inlining.Always)] public static float2 frac(float2 x) => new float2(frac(x.x), frac(x.y));
    [MethodImpl(Inlining.Always)] public static float degrees(float x) => x * TODEGREES;
    [MethodImpl(Inlining.Always)] public static double radians(double x) => x * TORADIANS_DBL;
    [MethodImpl(Inlining.Always)] public static float radians(float x) => x * TORADIANS;
    [MethodImpl(Inlining.Always)] public static float lerp(float start, float end, float t) => start + t * (end - start);
    [MethodImpl(Inlining.Always)]
    public static float3 lerp(float3 start, float3 end, float t) =>
        new float3(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t));
}
