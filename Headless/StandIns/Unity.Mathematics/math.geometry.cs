namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inlining.Always)] public static double dot(double x, double y) => x * y;
    [MethodImpl(Inlining.Always)] public static int dot(int x, int y) => x * y;
    [MethodImpl(Inlining.Always)] public static float dot(float x, float y) => x * y;
    [MethodImpl(Inlining.Always)] public static uint dot(uint x, uint y) => x * y;
    [MethodImpl(Inlining.Always)] internal static double dot(double2 x, double2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(Inlining.Always)] public static double dot(double3 x, double3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inlining.Always)] public static float dot(float2 x, float2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(Inlining.Always)] public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inlining.Always)] public static int dot(int3 x, int3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inlining.Always)] public static double3 cross(double3 x, double3 y) => (x * y.yzx - x.yzx * y).yzx;
    [MethodImpl(Inlining.Always)] public static float3 cross(float3 x, float3 y) => (x * y.yzx - x.yzx * y).yzx;
    [MethodImpl(Inlining.Always)] public static double length(double x) => abs(x);
    [MethodImpl(Inlining.Always)] public static float length(float x) => abs(x);
    [MethodImpl(Inlining.Always)] public static double length(double2 x) => sqrt(dot(x, x));
    [MethodImpl(Inlining.Always)] public static double length(double3 x) => sqrt(dot(x, x));
    [MethodImpl(Inlining.Always)] public static float length(float2 x) => sqrt(dot(x, x));
    [MethodImpl(Inlining.Always)] public static float length(float3 x) => sqrt(dot(x, x));
    [MethodImpl(Inlining.Always)] public static double lengthsq(double x) => x * x;
    [MethodImpl(Inlining.Always)] public static float lengthsq(float x) => x * x;
    [MethodImpl(Inlining.Always)] public static double lengthsq(double3 x) => dot(x, x);
    [MethodImpl(Inlining.Always)] public static float lengthsq(float3 x) => dot(x, x);
    [MethodImpl(Inlining.Always)] public static double distance(double x, double y) => abs(y - x);
    [MethodImpl(Inlining.Always)] public static float distance(float x, float y) => abs(y - x);
    [MethodImpl(Inlining.Always)] public static double distance(double3 x, double3 y) => length(y - x);
    [MethodImpl(Inlining.Always)] public static float distance(float3 x, float3 y) => length(y - x);
    [MethodImpl(Inlining.Always)] public static double distancesq(double x, double y) => (y - x) * (y - x);
    [MethodImpl(Inlining.Always)] public static float distancesq(float x, float y) => (y - x) * (y - x);
    [MethodImpl(Inlining.Always)] public static double distancesq(double3 x, double3 y) => lengthsq(y - x);
    [MethodImpl(Inlining.Always)] public static float distancesq(float3 x, float3 y) => lengthsq(y - x);
    [MethodImpl(Inlining.Always)] public static double3 normalize(double3 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(Inlining.Always)] public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;

    [MethodImpl(Inlining.Always)]
    public static float3 normalizesafe(float3 x, float3 defaultvalue = default)
    {
        float lengthSq = dot(x, x);
        return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
    }
}
