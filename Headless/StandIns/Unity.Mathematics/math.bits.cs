// A plain reading of Unity's signatures, one line a component.
using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    public static partial class math
    {
        [MethodImpl(Inlining.Always)]
        public static float asfloat(int x) => BitConverter.Int32BitsToSingle(x);

        [MethodImpl(Inlining.Always)]
        public static float asfloat(uint x) => BitConverter.Int32BitsToSingle((int)x);

        [MethodImpl(Inlining.Always)]
        public static float2 asfloat(int2 x) =>
            new float2(asfloat(x.x), asfloat(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 asfloat(int3 x) =>
            new float3(asfloat(x.x), asfloat(x.y), asfloat(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 asfloat(int4 x) =>
            new float4(asfloat(x.x), asfloat(x.y), asfloat(x.z), asfloat(x.w));

        [MethodImpl(Inlining.Always)]
        public static float2 asfloat(uint2 x) =>
            new float2(asfloat(x.x), asfloat(x.y));

        [MethodImpl(Inlining.Always)]
        public static float3 asfloat(uint3 x) =>
            new float3(asfloat(x.x), asfloat(x.y), asfloat(x.z));

        [MethodImpl(Inlining.Always)]
        public static float4 asfloat(uint4 x) =>
            new float4(asfloat(x.x), asfloat(x.y), asfloat(x.z), asfloat(x.w));

        [MethodImpl(Inlining.Always)]
        public static int asint(float x) => BitConverter.SingleToInt32Bits(x);

        [MethodImpl(Inlining.Always)]
        public static int asint(uint x) => (int)x;

        [MethodImpl(Inlining.Always)]
        public static int2 asint(float2 x) =>
            new int2(asint(x.x), asint(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 asint(float3 x) =>
            new int3(asint(x.x), asint(x.y), asint(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 asint(float4 x) =>
            new int4(asint(x.x), asint(x.y), asint(x.z), asint(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 asint(uint2 x) =>
            new int2(asint(x.x), asint(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 asint(uint3 x) =>
            new int3(asint(x.x), asint(x.y), asint(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 asint(uint4 x) =>
            new int4(asint(x.x), asint(x.y), asint(x.z), asint(x.w));

        [MethodImpl(Inlining.Always)]
        public static uint asuint(int x) => (uint)x;

        [MethodImpl(Inlining.Always)]
        public static uint asuint(float x) => (uint)BitConverter.SingleToInt32Bits(x);

        [MethodImpl(Inlining.Always)]
        public static uint2 asuint(float2 x) =>
            new uint2(asuint(x.x), asuint(x.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 asuint(float3 x) =>
            new uint3(asuint(x.x), asuint(x.y), asuint(x.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 asuint(float4 x) =>
            new uint4(asuint(x.x), asuint(x.y), asuint(x.z), asuint(x.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 asuint(int2 x) =>
            new uint2(asuint(x.x), asuint(x.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 asuint(int3 x) =>
            new uint3(asuint(x.x), asuint(x.y), asuint(x.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 asuint(int4 x) =>
            new uint4(asuint(x.x), asuint(x.y), asuint(x.z), asuint(x.w));

        [MethodImpl(Inlining.Always)]
        public static long aslong(double x) => BitConverter.DoubleToInt64Bits(x);

        [MethodImpl(Inlining.Always)]
        public static long aslong(ulong x) => (long)x;

        [MethodImpl(Inlining.Always)]
        public static ulong asulong(double x) => (ulong)BitConverter.DoubleToInt64Bits(x);

        [MethodImpl(Inlining.Always)]
        public static ulong asulong(long x) => (ulong)x;

        [MethodImpl(Inlining.Always)]
        public static double asdouble(long x) => BitConverter.Int64BitsToDouble(x);

        [MethodImpl(Inlining.Always)]
        public static double asdouble(ulong x) => BitConverter.Int64BitsToDouble((long)x);

        [MethodImpl(Inlining.Always)]
        public static int lzcnt(int x) => lzcnt((uint)x);

        [MethodImpl(Inlining.Always)]
        public static int lzcnt(long x) => lzcnt((ulong)x);

        [MethodImpl(Inlining.Always)]
        public static int lzcnt(uint x) => BitCount.LeadingZeros(x);

        [MethodImpl(Inlining.Always)]
        public static int lzcnt(ulong x) => BitCount.LeadingZeros(x);

        [MethodImpl(Inlining.Always)]
        public static int2 lzcnt(int2 x) =>
            new int2(lzcnt(x.x), lzcnt(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 lzcnt(int3 x) =>
            new int3(lzcnt(x.x), lzcnt(x.y), lzcnt(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 lzcnt(int4 x) =>
            new int4(lzcnt(x.x), lzcnt(x.y), lzcnt(x.z), lzcnt(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 lzcnt(uint2 x) =>
            new int2(lzcnt(x.x), lzcnt(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 lzcnt(uint3 x) =>
            new int3(lzcnt(x.x), lzcnt(x.y), lzcnt(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 lzcnt(uint4 x) =>
            new int4(lzcnt(x.x), lzcnt(x.y), lzcnt(x.z), lzcnt(x.w));

        [MethodImpl(Inlining.Always)]
        public static int tzcnt(int x) => tzcnt((uint)x);

        [MethodImpl(Inlining.Always)]
        public static int tzcnt(long x) => tzcnt((ulong)x);

        [MethodImpl(Inlining.Always)]
        public static int tzcnt(uint x) => BitCount.TrailingZeros(x);

        [MethodImpl(Inlining.Always)]
        public static int tzcnt(ulong x) => BitCount.TrailingZeros(x);

        [MethodImpl(Inlining.Always)]
        public static int2 tzcnt(int2 x) =>
            new int2(tzcnt(x.x), tzcnt(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 tzcnt(int3 x) =>
            new int3(tzcnt(x.x), tzcnt(x.y), tzcnt(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 tzcnt(int4 x) =>
            new int4(tzcnt(x.x), tzcnt(x.y), tzcnt(x.z), tzcnt(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 tzcnt(uint2 x) =>
            new int2(tzcnt(x.x), tzcnt(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 tzcnt(uint3 x) =>
            new int3(tzcnt(x.x), tzcnt(x.y), tzcnt(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 tzcnt(uint4 x) =>
            new int4(tzcnt(x.x), tzcnt(x.y), tzcnt(x.z), tzcnt(x.w));

        [MethodImpl(Inlining.Always)]
        public static int countbits(int x) => countbits((uint)x);

        [MethodImpl(Inlining.Always)]
        public static int countbits(long x) => countbits((ulong)x);

        [MethodImpl(Inlining.Always)]
        public static int countbits(uint x) => BitCount.Ones(x);

        [MethodImpl(Inlining.Always)]
        public static int countbits(ulong x) => BitCount.Ones(x);

        [MethodImpl(Inlining.Always)]
        public static int2 countbits(int2 x) =>
            new int2(countbits(x.x), countbits(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 countbits(int3 x) =>
            new int3(countbits(x.x), countbits(x.y), countbits(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 countbits(int4 x) =>
            new int4(countbits(x.x), countbits(x.y), countbits(x.z), countbits(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 countbits(uint2 x) =>
            new int2(countbits(x.x), countbits(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 countbits(uint3 x) =>
            new int3(countbits(x.x), countbits(x.y), countbits(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 countbits(uint4 x) =>
            new int4(countbits(x.x), countbits(x.y), countbits(x.z), countbits(x.w));

        [MethodImpl(Inlining.Always)]
        public static int reversebits(int x) => (int)BitCount.Reverse((uint)x);

        [MethodImpl(Inlining.Always)]
        public static long reversebits(long x) => (long)BitCount.Reverse((ulong)x);

        [MethodImpl(Inlining.Always)]
        public static uint reversebits(uint x) => BitCount.Reverse(x);

        [MethodImpl(Inlining.Always)]
        public static ulong reversebits(ulong x) => BitCount.Reverse(x);

        [MethodImpl(Inlining.Always)]
        public static int2 reversebits(int2 x) =>
            new int2(reversebits(x.x), reversebits(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 reversebits(int3 x) =>
            new int3(reversebits(x.x), reversebits(x.y), reversebits(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 reversebits(int4 x) =>
            new int4(reversebits(x.x), reversebits(x.y), reversebits(x.z), reversebits(x.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 reversebits(uint2 x) =>
            new uint2(reversebits(x.x), reversebits(x.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 reversebits(uint3 x) =>
            new uint3(reversebits(x.x), reversebits(x.y), reversebits(x.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 reversebits(uint4 x) =>
            new uint4(reversebits(x.x), reversebits(x.y), reversebits(x.z), reversebits(x.w));

        [MethodImpl(Inlining.Always)]
        public static int rol(int x, int n) => (int)rol((uint)x, n);

        [MethodImpl(Inlining.Always)]
        public static long rol(long x, int n) => (long)rol((ulong)x, n);

        [MethodImpl(Inlining.Always)]
        public static uint rol(uint x, int n) => (x << n) | (x >> (32 - n));

        [MethodImpl(Inlining.Always)]
        public static ulong rol(ulong x, int n) => (x << n) | (x >> (64 - n));

        [MethodImpl(Inlining.Always)]
        public static int2 rol(int2 x, int n) =>
            new int2(rol(x.x, n), rol(x.y, n));

        [MethodImpl(Inlining.Always)]
        public static int3 rol(int3 x, int n) =>
            new int3(rol(x.x, n), rol(x.y, n), rol(x.z, n));

        [MethodImpl(Inlining.Always)]
        public static int4 rol(int4 x, int n) =>
            new int4(rol(x.x, n), rol(x.y, n), rol(x.z, n), rol(x.w, n));

        [MethodImpl(Inlining.Always)]
        public static uint2 rol(uint2 x, int n) =>
            new uint2(rol(x.x, n), rol(x.y, n));

        [MethodImpl(Inlining.Always)]
        public static uint3 rol(uint3 x, int n) =>
            new uint3(rol(x.x, n), rol(x.y, n), rol(x.z, n));

        [MethodImpl(Inlining.Always)]
        public static uint4 rol(uint4 x, int n) =>
            new uint4(rol(x.x, n), rol(x.y, n), rol(x.z, n), rol(x.w, n));

        [MethodImpl(Inlining.Always)]
        public static int ror(int x, int n) => (int)ror((uint)x, n);

        [MethodImpl(Inlining.Always)]
        public static long ror(long x, int n) => (long)ror((ulong)x, n);

        [MethodImpl(Inlining.Always)]
        public static uint ror(uint x, int n) => (x >> n) | (x << (32 - n));

        [MethodImpl(Inlining.Always)]
        public static ulong ror(ulong x, int n) => (x >> n) | (x << (64 - n));

        [MethodImpl(Inlining.Always)]
        public static int2 ror(int2 x, int n) =>
            new int2(ror(x.x, n), ror(x.y, n));

        [MethodImpl(Inlining.Always)]
        public static int3 ror(int3 x, int n) =>
            new int3(ror(x.x, n), ror(x.y, n), ror(x.z, n));

        [MethodImpl(Inlining.Always)]
        public static int4 ror(int4 x, int n) =>
            new int4(ror(x.x, n), ror(x.y, n), ror(x.z, n), ror(x.w, n));

        [MethodImpl(Inlining.Always)]
        public static uint2 ror(uint2 x, int n) =>
            new uint2(ror(x.x, n), ror(x.y, n));

        [MethodImpl(Inlining.Always)]
        public static uint3 ror(uint3 x, int n) =>
            new uint3(ror(x.x, n), ror(x.y, n), ror(x.z, n));

        [MethodImpl(Inlining.Always)]
        public static uint4 ror(uint4 x, int n) =>
            new uint4(ror(x.x, n), ror(x.y, n), ror(x.z, n), ror(x.w, n));

        [MethodImpl(Inlining.Always)]
        public static int ceilpow2(int x) => (int)BitCount.CeilPowerOfTwo((uint)x);

        [MethodImpl(Inlining.Always)]
        public static long ceilpow2(long x) => (long)BitCount.CeilPowerOfTwo((ulong)x);

        [MethodImpl(Inlining.Always)]
        public static uint ceilpow2(uint x) => BitCount.CeilPowerOfTwo(x);

        [MethodImpl(Inlining.Always)]
        public static ulong ceilpow2(ulong x) => BitCount.CeilPowerOfTwo(x);

        [MethodImpl(Inlining.Always)]
        public static int2 ceilpow2(int2 x) =>
            new int2(ceilpow2(x.x), ceilpow2(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 ceilpow2(int3 x) =>
            new int3(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 ceilpow2(int4 x) =>
            new int4(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z), ceilpow2(x.w));

        [MethodImpl(Inlining.Always)]
        public static uint2 ceilpow2(uint2 x) =>
            new uint2(ceilpow2(x.x), ceilpow2(x.y));

        [MethodImpl(Inlining.Always)]
        public static uint3 ceilpow2(uint3 x) =>
            new uint3(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z));

        [MethodImpl(Inlining.Always)]
        public static uint4 ceilpow2(uint4 x) =>
            new uint4(ceilpow2(x.x), ceilpow2(x.y), ceilpow2(x.z), ceilpow2(x.w));

        [MethodImpl(Inlining.Always)]
        public static int floorlog2(int x) => 31 - lzcnt((uint)x);

        [MethodImpl(Inlining.Always)]
        public static int floorlog2(uint x) => 31 - lzcnt(x);

        [MethodImpl(Inlining.Always)]
        public static int2 floorlog2(int2 x) =>
            new int2(floorlog2(x.x), floorlog2(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 floorlog2(int3 x) =>
            new int3(floorlog2(x.x), floorlog2(x.y), floorlog2(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 floorlog2(int4 x) =>
            new int4(floorlog2(x.x), floorlog2(x.y), floorlog2(x.z), floorlog2(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 floorlog2(uint2 x) =>
            new int2(floorlog2(x.x), floorlog2(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 floorlog2(uint3 x) =>
            new int3(floorlog2(x.x), floorlog2(x.y), floorlog2(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 floorlog2(uint4 x) =>
            new int4(floorlog2(x.x), floorlog2(x.y), floorlog2(x.z), floorlog2(x.w));

        [MethodImpl(Inlining.Always)]
        public static int ceillog2(int x) => 32 - lzcnt((uint)x - 1);

        [MethodImpl(Inlining.Always)]
        public static int ceillog2(uint x) => 32 - lzcnt(x - 1);

        [MethodImpl(Inlining.Always)]
        public static int2 ceillog2(int2 x) =>
            new int2(ceillog2(x.x), ceillog2(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 ceillog2(int3 x) =>
            new int3(ceillog2(x.x), ceillog2(x.y), ceillog2(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 ceillog2(int4 x) =>
            new int4(ceillog2(x.x), ceillog2(x.y), ceillog2(x.z), ceillog2(x.w));

        [MethodImpl(Inlining.Always)]
        public static int2 ceillog2(uint2 x) =>
            new int2(ceillog2(x.x), ceillog2(x.y));

        [MethodImpl(Inlining.Always)]
        public static int3 ceillog2(uint3 x) =>
            new int3(ceillog2(x.x), ceillog2(x.y), ceillog2(x.z));

        [MethodImpl(Inlining.Always)]
        public static int4 ceillog2(uint4 x) =>
            new int4(ceillog2(x.x), ceillog2(x.y), ceillog2(x.z), ceillog2(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool ispow2(int x) => x > 0 && (x & (x - 1)) == 0;

        [MethodImpl(Inlining.Always)]
        public static bool ispow2(uint x) => x > 0 && (x & (x - 1)) == 0;

        [MethodImpl(Inlining.Always)]
        public static bool2 ispow2(int2 x) =>
            new bool2(ispow2(x.x), ispow2(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 ispow2(int3 x) =>
            new bool3(ispow2(x.x), ispow2(x.y), ispow2(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 ispow2(int4 x) =>
            new bool4(ispow2(x.x), ispow2(x.y), ispow2(x.z), ispow2(x.w));

        [MethodImpl(Inlining.Always)]
        public static bool2 ispow2(uint2 x) =>
            new bool2(ispow2(x.x), ispow2(x.y));

        [MethodImpl(Inlining.Always)]
        public static bool3 ispow2(uint3 x) =>
            new bool3(ispow2(x.x), ispow2(x.y), ispow2(x.z));

        [MethodImpl(Inlining.Always)]
        public static bool4 ispow2(uint4 x) =>
            new bool4(ispow2(x.x), ispow2(x.y), ispow2(x.z), ispow2(x.w));

        [MethodImpl(Inlining.Always)]
        public static int bitmask(bool4 value) => (value.x ? 1 : 0) | (value.y ? 2 : 0) | (value.z ? 4 : 0) | (value.w ? 8 : 0);
    }
}
