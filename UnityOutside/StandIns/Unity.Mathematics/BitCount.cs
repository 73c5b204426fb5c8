#if NET
using System.Numerics;
#endif

namespace Unity.Mathematics;

/// <summary>Bit counts by instruction where the runtime has them, by arithmetic for netstandard2.1.</summary>
internal static class BitCount
{
#if NET
    [MethodImpl(Inline)] internal static int LeadingZeros(uint x) => BitOperations.LeadingZeroCount(x);
    [MethodImpl(Inline)] internal static int LeadingZeros(ulong x) => BitOperations.LeadingZeroCount(x);
    [MethodImpl(Inline)] internal static int TrailingZeros(uint x) => BitOperations.TrailingZeroCount(x);
    [MethodImpl(Inline)] internal static int TrailingZeros(ulong x) => BitOperations.TrailingZeroCount(x);
    [MethodImpl(Inline)] internal static int Ones(uint x) => BitOperations.PopCount(x);
    [MethodImpl(Inline)] internal static int Ones(ulong x) => BitOperations.PopCount(x);
#else
    internal static int LeadingZeros(uint x) => 32 - Ones(Smear(x));
    internal static int LeadingZeros(ulong x) => 64 - Ones(Smear(x));
    internal static int TrailingZeros(uint x) => Ones(~x & (x - 1));
    internal static int TrailingZeros(ulong x) => Ones(~x & (x - 1));

    internal static int Ones(uint x)
    {
        x -= (x >> 1) & 0x55555555u;
        x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
        return (int)((((x + (x >> 4)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24);
    }

    internal static int Ones(ulong x) => Ones((uint)x) + Ones((uint)(x >> 32));

    private static ulong Smear(ulong x)
    {
        x |= x >> 1;
        x |= x >> 2;
        x |= x >> 4;
        x |= x >> 8;
        x |= x >> 16;
        return x | (x >> 32);
    }
#endif

    internal static uint CeilPowerOfTwo(uint x) => Smear(x - 1) + 1;

    private static uint Smear(uint x)
    {
        x |= x >> 1;
        x |= x >> 2;
        x |= x >> 4;
        x |= x >> 8;
        return x | (x >> 16);
    }
}
