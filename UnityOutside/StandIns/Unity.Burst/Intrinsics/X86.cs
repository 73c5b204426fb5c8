#if NET
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Net = System.Runtime.Intrinsics.X86.Avx2;
#endif

namespace Unity.Burst.Intrinsics
{
    /// <summary>256 bits. Burst's has a field for each way to see them; nothing here looks into it but the functions
    /// below.</summary>
    public struct v256
    {
#if NET
        internal Vector256<uint> Bits;

        internal v256(Vector256<uint> bits) => Bits = bits;
#endif
    }

    /// <summary>In Unity the functions are there in managed code as well, if slowly; here, without .NET's own, nothing calls
    /// them.</summary>
    public static unsafe partial class X86
    {
#if NET
#pragma warning disable CA1857 // Callers give constants, and all is inlined.
        // Precompiled code calls what is not inlined, and what is no instruction in the framework (Vector256.Load).
        const MethodImplOptions Inline = MethodImplOptions.AggressiveInlining;
#endif

        public static class Avx
        {
#if NET
            [MethodImpl(Inline)] public static v256 mm256_loadu_si256(void* ptr) => new v256(Net.LoadVector256((uint*)ptr));
            [MethodImpl(Inline)] public static v256 mm256_set1_epi32(int a) => new v256(Vector256.Create((uint)a));
            [MethodImpl(Inline)] public static void mm256_storeu_si256(void* ptr, v256 v) => Net.Store((uint*)ptr, v.Bits);
            [MethodImpl(Inline)]
            public static v256 mm256_loadu_ps(void* ptr) => new v256(Net.LoadVector256((float*)ptr).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_set1_ps(float a) => new v256(Vector256.Create(a).AsUInt32());
            [MethodImpl(Inline)] public static void mm256_storeu_ps(void* ptr, v256 a) => Net.Store((uint*)ptr, a.Bits);
            [MethodImpl(Inline)]
            public static v256 mm256_add_ps(v256 a, v256 b) =>
                new v256(Net.Add(a.Bits.AsSingle(), b.Bits.AsSingle()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_sub_ps(v256 a, v256 b) =>
                new v256(Net.Subtract(a.Bits.AsSingle(), b.Bits.AsSingle()).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_and_ps(v256 a, v256 b) => new v256(Net.And(a.Bits, b.Bits));
            [MethodImpl(Inline)]
            public static v256 mm256_mul_ps(v256 a, v256 b) =>
                new v256(Net.Multiply(a.Bits.AsSingle(), b.Bits.AsSingle()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_max_ps(v256 a, v256 b) =>
                new v256(Net.Max(a.Bits.AsSingle(), b.Bits.AsSingle()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_min_ps(v256 a, v256 b) =>
                new v256(Net.Min(a.Bits.AsSingle(), b.Bits.AsSingle()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_cvtepi32_ps(v256 a) =>
                new v256(Net.ConvertToVector256Single(a.Bits.AsInt32()).AsUInt32());
            [MethodImpl(Inline)] public static int mm256_movemask_ps(v256 a) => Net.MoveMask(a.Bits.AsSingle());
#else
            public static v256 mm256_loadu_si256(void* ptr) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_set1_epi32(int a) => throw new System.PlatformNotSupportedException();
            public static void mm256_storeu_si256(void* ptr, v256 v) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_loadu_ps(void* ptr) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_set1_ps(float a) => throw new System.PlatformNotSupportedException();
            public static void mm256_storeu_ps(void* ptr, v256 a) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_add_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_sub_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_and_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_mul_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_max_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_min_ps(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_cvtepi32_ps(v256 a) => throw new System.PlatformNotSupportedException();
            public static int mm256_movemask_ps(v256 a) => throw new System.PlatformNotSupportedException();
#endif
        }

        public static class Avx2
        {
            // Known when code is compiled, so that the other branch is left out. In Unity it is false where Burst does not
            // compile; here it says what the processor has, so that what runs is what Burst makes.
#if NET
            public static bool IsAvx2Supported => Net.IsSupported;
            [MethodImpl(Inline)] public static int mm256_movemask_epi8(v256 a) => Net.MoveMask(a.Bits.AsByte());
            [MethodImpl(Inline)] public static v256 mm256_add_epi32(v256 a, v256 b) => new v256(Net.Add(a.Bits, b.Bits));
            [MethodImpl(Inline)]
            public static v256 mm256_cmpgt_epi32(v256 a, v256 b) =>
                new v256(Net.CompareGreaterThan(a.Bits.AsInt32(), b.Bits.AsInt32()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_madd_epi16(v256 a, v256 b) =>
                new v256(Net.MultiplyAddAdjacent(a.Bits.AsInt16(), b.Bits.AsInt16()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_max_epu8(v256 a, v256 b) => new v256(Net.Max(a.Bits.AsByte(), b.Bits.AsByte()).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_max_epu32(v256 a, v256 b) => new v256(Net.Max(a.Bits, b.Bits));
            [MethodImpl(Inline)]
            public static v256 mm256_min_epi32(v256 a, v256 b) =>
                new v256(Net.Min(a.Bits.AsInt32(), b.Bits.AsInt32()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_min_epu8(v256 a, v256 b) => new v256(Net.Min(a.Bits.AsByte(), b.Bits.AsByte()).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_min_epu32(v256 a, v256 b) => new v256(Net.Min(a.Bits, b.Bits));
            [MethodImpl(Inline)]
            public static v256 mm256_sub_epi16(v256 a, v256 b) =>
                new v256(Net.Subtract(a.Bits.AsUInt16(), b.Bits.AsUInt16()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_max_epu16(v256 a, v256 b) =>
                new v256(Net.Max(a.Bits.AsUInt16(), b.Bits.AsUInt16()).AsUInt32());
            [MethodImpl(Inline)]
            public static v256 mm256_min_epu16(v256 a, v256 b) =>
                new v256(Net.Min(a.Bits.AsUInt16(), b.Bits.AsUInt16()).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_or_si256(v256 a, v256 b) => new v256(Net.Or(a.Bits, b.Bits));
            [MethodImpl(Inline)]
            public static v256 mm256_srli_epi16(v256 a, [ConstantExpected] int imm8) =>
                new v256(Net.ShiftRightLogical(a.Bits.AsUInt16(), (byte)imm8).AsUInt32());
            [MethodImpl(Inline)] public static v256 mm256_xor_si256(v256 a, v256 b) => new v256(Net.Xor(a.Bits, b.Bits));
#else
            public static bool IsAvx2Supported => false;
            public static int mm256_movemask_epi8(v256 a) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_add_epi32(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_cmpgt_epi32(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_madd_epi16(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_max_epu8(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_max_epu32(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_min_epi32(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_min_epu8(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_min_epu32(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_sub_epi16(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_max_epu16(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_min_epu16(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_or_si256(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_srli_epi16(v256 a, int imm8) => throw new System.PlatformNotSupportedException();
            public static v256 mm256_xor_si256(v256 a, v256 b) => throw new System.PlatformNotSupportedException();
#endif
        }
    }
}
