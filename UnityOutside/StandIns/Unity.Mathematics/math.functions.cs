namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inline)] public static double sin(double x) => Math.Sin(x);
    [MethodImpl(Inline)] public static float sin(float x) => (float)Math.Sin(x);
    [MethodImpl(Inline)] public static double cos(double x) => Math.Cos(x);
    [MethodImpl(Inline)] public static float cos(float x) => (float)Math.Cos(x);
    [MethodImpl(Inline)] public static double tan(double x) => Math.Tan(x);
    [MethodImpl(Inline)] public static float tan(float x) => (float)Math.Tan(x);
    [MethodImpl(Inline)] public static float atan2(float y, float x) => (float)Math.Atan2(y, x);

    [MethodImpl(Inline)]
    public static void sincos(double x, out double s, out double c)
    {
        s = sin(x);
        c = cos(x);
    }

    [MethodImpl(Inline)] public static double exp(double x) => Math.Exp(x);
    [MethodImpl(Inline)] public static float exp(float x) => (float)Math.Exp(x);
    [MethodImpl(Inline)] public static double exp2(double x) => Math.Exp(x * 0.693147180559945309);
    [MethodImpl(Inline)] public static float exp2(float x) => (float)Math.Exp(x * 0.69314718f);
    [MethodImpl(Inline)] public static double3 exp2(double3 x) => new(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(Inline)] public static float3 exp2(float3 x) => new(exp2(x.x), exp2(x.y), exp2(x.z));
    [MethodImpl(Inline)] public static double log(double x) => Math.Log(x);
    [MethodImpl(Inline)] public static float log(float x) => (float)Math.Log(x);
    [MethodImpl(Inline)] public static float log2(float x) => (float)Math.Log(x, 2.0f);
    [MethodImpl(Inline)] public static double pow(double x, double y) => Math.Pow(x, y);
    [MethodImpl(Inline)] public static float pow(float x, float y) => (float)Math.Pow(x, y);
    [MethodImpl(Inline)] public static float3 pow(float3 x, float3 y) => new(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));
    [MethodImpl(Inline)] public static double sqrt(double x) => Math.Sqrt(x);
    [MethodImpl(Inline)] public static float sqrt(float x) => MathF.Sqrt(x);
    [MethodImpl(Inline)] internal static double rsqrt(double x) => 1.0 / sqrt(x);
    [MethodImpl(Inline)] internal static float rsqrt(float x) => 1.0f / sqrt(x);
    [MethodImpl(Inline)] public static double floor(double x) => Math.Floor(x);
    [MethodImpl(Inline)] public static float floor(float x) => MathF.Floor(x);
    [MethodImpl(Inline)] public static double3 floor(double3 x) => new(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(Inline)] public static float2 floor(float2 x) => new(floor(x.x), floor(x.y));
    [MethodImpl(Inline)] public static float3 floor(float3 x) => new(floor(x.x), floor(x.y), floor(x.z));
    [MethodImpl(Inline)] public static double ceil(double x) => Math.Ceiling(x);
    [MethodImpl(Inline)] public static float ceil(float x) => MathF.Ceiling(x);
    [MethodImpl(Inline)] public static double3 ceil(double3 x) => new(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(Inline)] public static float3 ceil(float3 x) => new(ceil(x.x), ceil(x.y), ceil(x.z));
    [MethodImpl(Inline)] public static double round(double x) => Math.Round(x);
    [MethodImpl(Inline)] public static float round(float x) => MathF.Round(x);
    [MethodImpl(Inline)] public static double3 round(double3 x) => new(round(x.x), round(x.y), round(x.z));
    [MethodImpl(Inline)] public static float3 round(float3 x) => new(round(x.x), round(x.y), round(x.z));
    [MethodImpl(Inline)] public static float frac(float x) => x - floor(x);
    [MethodImpl(Inline)] public static float2 frac(float2 x) => new(frac(x.x), frac(x.y));
    [MethodImpl(Inline)] public static float degrees(float x) => x * TODEGREES;
    [MethodImpl(Inline)] public static double radians(double x) => x * TORADIANS_DBL;
    [MethodImpl(Inline)] public static float radians(float x) => x * TORADIANS;
    [MethodImpl(Inline)] public static float lerp(float start, float end, float t) => start + t * (end - start);
    [MethodImpl(Inline)]
    public static float3 lerp(float3 start, float3 end, float t) =>
        new float3(lerp(start.x, end.x, t), lerp(start.y, end.y, t), lerp(start.z, end.z, t));
}
