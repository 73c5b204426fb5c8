namespace Unity.Burst.Intrinsics;

public static unsafe partial class Common
{
    /// <summary>The low 64 bits of x * y, and the high ones.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ulong umul128(ulong x, ulong y, out ulong high)
    {
#if NET
        // Precompiled code would call Math.BigMul.
        if (System.Runtime.Intrinsics.X86.Bmi2.X64.IsSupported)
        {
            high = System.Runtime.Intrinsics.X86.Bmi2.X64.MultiplyNoFlags(x, y);
            return x * y;
        }
        high = System.Math.BigMul(x, y, out ulong low);
        return low;
#else
        ulong xl = (uint)x;
        ulong xh = x >> 32;
        ulong yl = (uint)y;
        ulong yh = y >> 32;
        ulong cross = xh * yl + ((xl * yl) >> 32);
        ulong carry = xl * yh + (uint)cross;
        high = xh * yh + (cross >> 32) + (carry >> 32);
        return x * y;
#endif
    }
}
