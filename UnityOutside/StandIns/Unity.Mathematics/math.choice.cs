namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inline)] public static double min(double x, double y) => double.IsNaN(y) || x < y ? x : y;
    [MethodImpl(Inline)] public static int min(int x, int y) => x < y ? x : y;
    [MethodImpl(Inline)] public static long min(long x, long y) => x < y ? x : y;
    [MethodImpl(Inline)] public static float min(float x, float y) => float.IsNaN(y) || x < y ? x : y;
    [MethodImpl(Inline)] public static uint min(uint x, uint y) => x < y ? x : y;
    [MethodImpl(Inline)] public static ulong min(ulong x, ulong y) => x < y ? x : y;
    [MethodImpl(Inline)] public static double3 min(double3 x, double3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(Inline)] public static float2 min(float2 x, float2 y) => new(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(Inline)] public static float3 min(float3 x, float3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(Inline)] public static int2 min(int2 x, int2 y) => new(min(x.x, y.x), min(x.y, y.y));
    [MethodImpl(Inline)] public static int3 min(int3 x, int3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));
    [MethodImpl(Inline)] public static double max(double x, double y) => double.IsNaN(y) || x > y ? x : y;
    [MethodImpl(Inline)] public static int max(int x, int y) => x > y ? x : y;
    [MethodImpl(Inline)] public static long max(long x, long y) => x > y ? x : y;
    [MethodImpl(Inline)] public static float max(float x, float y) => float.IsNaN(y) || x > y ? x : y;
    [MethodImpl(Inline)] public static uint max(uint x, uint y) => x > y ? x : y;
    [MethodImpl(Inline)] public static ulong max(ulong x, ulong y) => x > y ? x : y;
    [MethodImpl(Inline)] public static double3 max(double3 x, double3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(Inline)] public static float2 max(float2 x, float2 y) => new(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(Inline)] public static float3 max(float3 x, float3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));
    [MethodImpl(Inline)] public static int2 max(int2 x, int2 y) => new(max(x.x, y.x), max(x.y, y.y));
    [MethodImpl(Inline)] public static int3 max(int3 x, int3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

    [MethodImpl(Inline)]
    public static double clamp(double valueToClamp, double lowerBound, double upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static int clamp(int valueToClamp, int lowerBound, int upperBound) => max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static long clamp(long valueToClamp, long lowerBound, long upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static float clamp(float valueToClamp, float lowerBound, float upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static uint clamp(uint valueToClamp, uint lowerBound, uint upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static ulong clamp(ulong valueToClamp, ulong lowerBound, ulong upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static double3 clamp(double3 valueToClamp, double3 lowerBound, double3 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static float3 clamp(float3 valueToClamp, float3 lowerBound, float3 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static int2 clamp(int2 valueToClamp, int2 lowerBound, int2 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));
    [MethodImpl(Inline)]
    public static int3 clamp(int3 valueToClamp, int3 lowerBound, int3 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(Inline)] public static float saturate(float x) => clamp(x, 0.0f, 1.0f);
    [MethodImpl(Inline)] public static float3 saturate(float3 x) => new(saturate(x.x), saturate(x.y), saturate(x.z));

    [MethodImpl(Inline)]
    internal static float select(float falseValue, float trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(Inline)] public static uint select(uint falseValue, uint trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(Inline)]
    internal static float3 select(float3 falseValue, float3 trueValue, bool test) => test ? trueValue : falseValue;
    [MethodImpl(Inline)]
    public static float3 select(float3 falseValue, float3 trueValue, bool3 test) =>
        new float3(
            select(falseValue.x, trueValue.x, test.x), select(falseValue.y, trueValue.y, test.y),
            select(falseValue.z, trueValue.z, test.z));

    [MethodImpl(Inline)] public static bool any(bool2 x) => x.x || x.y;
    [MethodImpl(Inline)] public static bool any(bool3 x) => x.x || x.y || x.z;
    [MethodImpl(Inline)] public static bool all(bool2 x) => x.x && x.y;
    [MethodImpl(Inline)] public static bool all(bool3 x) => x.x && x.y && x.z;
    [MethodImpl(Inline)] public static bool all(bool4 x) => x.x && x.y && x.z && x.w;
    [MethodImpl(Inline)] public static int sign(int x) => (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0);
    [MethodImpl(Inline)] public static float sign(float x) => (x > 0.0f ? 1.0f : 0.0f) - (x < 0.0f ? 1.0f : 0.0f);
    [MethodImpl(Inline)] public static float3 sign(float3 x) => new(sign(x.x), sign(x.y), sign(x.z));
    [MethodImpl(Inline)] public static double abs(double x) => asdouble(asulong(x) & 0x7FFFFFFFFFFFFFFFul);
    [MethodImpl(Inline)] public static int abs(int x) => max(-x, x);
    [MethodImpl(Inline)] public static long abs(long x) => max(-x, x);
    [MethodImpl(Inline)] public static float abs(float x) => asfloat(asuint(x) & 0x7FFFFFFFu);
    [MethodImpl(Inline)] public static double2 abs(double2 x) => new(abs(x.x), abs(x.y));
    [MethodImpl(Inline)] public static double3 abs(double3 x) => new(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(Inline)] public static float3 abs(float3 x) => new(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(Inline)] public static int3 abs(int3 x) => new(abs(x.x), abs(x.y), abs(x.z));
    [MethodImpl(Inline)] public static double cmin(double3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static float cmin(float2 x) => min(x.x, x.y);
    [MethodImpl(Inline)] public static float cmin(float3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static int cmin(int3 x) => min(min(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static double cmax(double2 x) => max(x.x, x.y);
    [MethodImpl(Inline)] public static double cmax(double3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static float cmax(float3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static int cmax(int3 x) => max(max(x.x, x.y), x.z);
    [MethodImpl(Inline)] public static double csum(double3 x) => x.x + x.y + x.z;
    [MethodImpl(Inline)] public static float csum(float3 x) => x.x + x.y + x.z;
    [MethodImpl(Inline)] public static int csum(int3 x) => x.x + x.y + x.z;
    [MethodImpl(Inline)] public static bool isfinite(double x) => abs(x) < double.PositiveInfinity;
    [MethodImpl(Inline)] public static bool isfinite(float x) => abs(x) < float.PositiveInfinity;
    [MethodImpl(Inline)] public static bool2 isfinite(double2 x) => new(isfinite(x.x), isfinite(x.y));
    [MethodImpl(Inline)] public static bool3 isfinite(double3 x) => new(isfinite(x.x), isfinite(x.y), isfinite(x.z));
    [MethodImpl(Inline)] public static bool3 isfinite(float3 x) => new(isfinite(x.x), isfinite(x.y), isfinite(x.z));
}
