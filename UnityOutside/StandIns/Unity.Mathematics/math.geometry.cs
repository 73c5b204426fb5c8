namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inline)] public static double dot(double x, double y) => x * y;
    [MethodImpl(Inline)] public static int dot(int x, int y) => x * y;
    [MethodImpl(Inline)] public static float dot(float x, float y) => x * y;
    [MethodImpl(Inline)] public static uint dot(uint x, uint y) => x * y;
    [MethodImpl(Inline)] internal static double dot(double2 x, double2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(Inline)] public static double dot(double3 x, double3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inline)] public static float dot(float2 x, float2 y) => x.x * y.x + x.y * y.y;
    [MethodImpl(Inline)] public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inline)] public static int dot(int3 x, int3 y) => x.x * y.x + x.y * y.y + x.z * y.z;
    [MethodImpl(Inline)] public static double3 cross(double3 x, double3 y) => (x * y.yzx - x.yzx * y).yzx;
    [MethodImpl(Inline)] public static float3 cross(float3 x, float3 y) => (x * y.yzx - x.yzx * y).yzx;
    [MethodImpl(Inline)] public static double length(double x) => abs(x);
    [MethodImpl(Inline)] public static float length(float x) => abs(x);
    [MethodImpl(Inline)] public static double length(double2 x) => sqrt(dot(x, x));
    [MethodImpl(Inline)] public static double length(double3 x) => sqrt(dot(x, x));
    [MethodImpl(Inline)] public static float length(float2 x) => sqrt(dot(x, x));
    [MethodImpl(Inline)] public static float length(float3 x) => sqrt(dot(x, x));
    [MethodImpl(Inline)] public static double lengthsq(double x) => x * x;
    [MethodImpl(Inline)] public static float lengthsq(float x) => x * x;
    [MethodImpl(Inline)] public static double lengthsq(double3 x) => dot(x, x);
    [MethodImpl(Inline)] public static float lengthsq(float3 x) => dot(x, x);
    [MethodImpl(Inline)] public static double distance(double x, double y) => abs(y - x);
    [MethodImpl(Inline)] public static float distance(float x, float y) => abs(y - x);
    [MethodImpl(Inline)] public static double distance(double3 x, double3 y) => length(y - x);
    [MethodImpl(Inline)] public static float distance(float3 x, float3 y) => length(y - x);
    [MethodImpl(Inline)] public static double distancesq(double x, double y) => (y - x) * (y - x);
    [MethodImpl(Inline)] public static float distancesq(float x, float y) => (y - x) * (y - x);
    [MethodImpl(Inline)] public static double distancesq(double3 x, double3 y) => lengthsq(y - x);
    [MethodImpl(Inline)] public static float distancesq(float3 x, float3 y) => lengthsq(y - x);
    [MethodImpl(Inline)] public static double3 normalize(double3 x) => rsqrt(dot(x, x)) * x;
    [MethodImpl(Inline)] public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;

    [MethodImpl(Inline)]
    public static float3 normalizesafe(float3 x, float3 defaultvalue = default)
    {
        float lengthSq = dot(x, x);
        return select(defaultvalue, x * rsqrt(lengthSq), lengthSq > FLT_MIN_NORMAL);
    }
}
