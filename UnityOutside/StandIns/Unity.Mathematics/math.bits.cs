namespace Unity.Mathematics;

public static partial class math
{
    [MethodImpl(Inline)] public static float asfloat(uint x) => BitConverter.Int32BitsToSingle((int)x);
    [MethodImpl(Inline)] public static uint asuint(int x) => (uint)x;
    [MethodImpl(Inline)] public static uint asuint(float x) => (uint)BitConverter.SingleToInt32Bits(x);
    [MethodImpl(Inline)] public static long aslong(double x) => BitConverter.DoubleToInt64Bits(x);
    [MethodImpl(Inline)] public static long aslong(ulong x) => (long)x;
    [MethodImpl(Inline)] public static ulong asulong(double x) => (ulong)BitConverter.DoubleToInt64Bits(x);
    [MethodImpl(Inline)] public static ulong asulong(long x) => (ulong)x;
    [MethodImpl(Inline)] public static double asdouble(ulong x) => BitConverter.Int64BitsToDouble((long)x);

    internal static uint fold_to_uint(double x) => (uint)(asulong(x) >> 32) ^ (uint)asulong(x);

    [MethodImpl(Inline)] public static int lzcnt(int x) => lzcnt((uint)x);
    [MethodImpl(Inline)] public static int lzcnt(uint x) => BitCount.LeadingZeros(x);
    [MethodImpl(Inline)] public static int lzcnt(ulong x) => BitCount.LeadingZeros(x);
    [MethodImpl(Inline)] public static int tzcnt(int x) => tzcnt((uint)x);
    [MethodImpl(Inline)] public static int tzcnt(uint x) => BitCount.TrailingZeros(x);
    [MethodImpl(Inline)] public static int tzcnt(ulong x) => BitCount.TrailingZeros(x);
    [MethodImpl(Inline)] public static int countbits(uint x) => BitCount.Ones(x);
    [MethodImpl(Inline)] public static int countbits(ulong x) => BitCount.Ones(x);
    [MethodImpl(Inline)] public static uint rol(uint x, int n) => (x << n) | (x >> (32 - n));
    [MethodImpl(Inline)] public static uint ror(uint x, int n) => (x >> n) | (x << (32 - n));
    [MethodImpl(Inline)] public static int ceilpow2(int x) => (int)BitCount.CeilPowerOfTwo((uint)x);
}
