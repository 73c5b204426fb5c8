using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics
{
    /// <summary>Xorshift (13, 17, 5) of 32 bits; the sequence is Unity's for the same seed. A state of zero is a fixed
    /// point.</summary>
    public struct Random
    {
        public uint state;

        [MethodImpl(Inlining.Always)]
        public Random(uint seed)
        {
            state = seed;
            CheckInitState();
            NextState();
        }

        /// <summary>For neighbouring indices: they are hashed first, or the first numbers would be alike.</summary>
        public static Random CreateFromIndex(uint index)
        {
            if (index == uint.MaxValue)
                throw new ArgumentException("Index must not be uint.MaxValue");
            return new Random(WangHash(index + 62u));
        }

        public void InitState(uint seed = 0x6E624EB7u)
        {
            state = seed;
            NextState();
        }

        public bool NextBool() => (NextState() & 1) == 1;

        public int NextInt() => (int)NextState() ^ -2147483648;

        public int NextInt(int max)
        {
            CheckMax(max);
            return (int)((NextState() * (ulong)max) >> 32);
        }

        public int NextInt(int min, int max)
        {
            CheckMinMax(min, max);
            return (int)(uint)(NextState() * (ulong)(uint)(max - min) >> 32) + min;
        }

        public uint NextUInt() => NextState() - 1u;

        public uint NextUInt(uint max) => (uint)((NextState() * (ulong)max) >> 32);

        public uint NextUInt(uint min, uint max)
        {
            CheckMinMax(min, max);
            return (uint)(NextState() * (ulong)(max - min) >> 32) + min;
        }

        [MethodImpl(Inlining.Always)]
        public float NextFloat() => math.asfloat(0x3F800000u | (NextState() >> 9)) - 1.0f;

        public float NextFloat(float max) => NextFloat() * max;

        public float NextFloat(float min, float max) => NextFloat() * (max - min) + min;

        public double NextDouble()
        {
            ulong bits = ((ulong)NextState() << 20) ^ NextState();
            return math.asdouble(0x3FF0000000000000ul | bits) - 1.0;
        }

        public double NextDouble(double max) => NextDouble() * max;

        public double NextDouble(double min, double max) => NextDouble() * (max - min) + min;

        public float2 NextFloat2() => new float2(NextFloat(), NextFloat());

        public float2 NextFloat2(float2 max) => NextFloat2() * max;

        public float2 NextFloat2(float2 min, float2 max) => NextFloat2() * (max - min) + min;

        public float3 NextFloat3() => new float3(NextFloat(), NextFloat(), NextFloat());

        public float3 NextFloat3(float3 max) => NextFloat3() * max;

        public float3 NextFloat3(float3 min, float3 max) => NextFloat3() * (max - min) + min;

        public float4 NextFloat4() => new float4(NextFloat(), NextFloat(), NextFloat(), NextFloat());

        public float4 NextFloat4(float4 max) => NextFloat4() * max;

        public float4 NextFloat4(float4 min, float4 max) => NextFloat4() * (max - min) + min;

        public double2 NextDouble2() => new double2(NextDouble(), NextDouble());

        public double2 NextDouble2(double2 max) => NextDouble2() * max;

        public double2 NextDouble2(double2 min, double2 max) => NextDouble2() * (max - min) + min;

        public double3 NextDouble3() => new double3(NextDouble(), NextDouble(), NextDouble());

        public double3 NextDouble3(double3 max) => NextDouble3() * max;

        public double3 NextDouble3(double3 min, double3 max) => NextDouble3() * (max - min) + min;

        public double4 NextDouble4() => new double4(NextDouble(), NextDouble(), NextDouble(), NextDouble());

        public double4 NextDouble4(double4 max) => NextDouble4() * max;

        public double4 NextDouble4(double4 min, double4 max) => NextDouble4() * (max - min) + min;

        public int2 NextInt2() => new int2(NextInt(), NextInt());

        public int2 NextInt2(int2 max) => new int2(NextInt(max.x), NextInt(max.y));

        public int2 NextInt2(int2 min, int2 max) => new int2(NextInt(min.x, max.x), NextInt(min.y, max.y));

        public int3 NextInt3() => new int3(NextInt(), NextInt(), NextInt());

        public int3 NextInt3(int3 max) => new int3(NextInt(max.x), NextInt(max.y), NextInt(max.z));

        public int3 NextInt3(int3 min, int3 max) => new int3(NextInt(min.x, max.x), NextInt(min.y, max.y), NextInt(min.z, max.z));

        public int4 NextInt4() => new int4(NextInt(), NextInt(), NextInt(), NextInt());

        public int4 NextInt4(int4 max) => new int4(NextInt(max.x), NextInt(max.y), NextInt(max.z), NextInt(max.w));

        public int4 NextInt4(int4 min, int4 max) => new int4(NextInt(min.x, max.x), NextInt(min.y, max.y), NextInt(min.z, max.z), NextInt(min.w, max.w));

        public uint2 NextUInt2() => new uint2(NextUInt(), NextUInt());

        public uint2 NextUInt2(uint2 max) => new uint2(NextUInt(max.x), NextUInt(max.y));

        public uint2 NextUInt2(uint2 min, uint2 max) => new uint2(NextUInt(min.x, max.x), NextUInt(min.y, max.y));

        public uint3 NextUInt3() => new uint3(NextUInt(), NextUInt(), NextUInt());

        public uint3 NextUInt3(uint3 max) => new uint3(NextUInt(max.x), NextUInt(max.y), NextUInt(max.z));

        public uint3 NextUInt3(uint3 min, uint3 max) => new uint3(NextUInt(min.x, max.x), NextUInt(min.y, max.y), NextUInt(min.z, max.z));

        public uint4 NextUInt4() => new uint4(NextUInt(), NextUInt(), NextUInt(), NextUInt());

        public uint4 NextUInt4(uint4 max) => new uint4(NextUInt(max.x), NextUInt(max.y), NextUInt(max.z), NextUInt(max.w));

        public uint4 NextUInt4(uint4 min, uint4 max) => new uint4(NextUInt(min.x, max.x), NextUInt(min.y, max.y), NextUInt(min.z, max.z), NextUInt(min.w, max.w));

        private static uint WangHash(uint n)
        {
            n = (n ^ 61u) ^ (n >> 16);
            n *= 9u;
            n ^= n >> 4;
            n *= 0x27D4EB2Du;
            return n ^ (n >> 15);
        }

        [MethodImpl(Inlining.Always)]
        private uint NextState()
        {
            CheckState();
            uint t = state;
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            return t;
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private void CheckInitState()
        {
            if (state == 0)
                throw new ArgumentException("Seed must be non-zero");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private void CheckState()
        {
            if (state == 0)
                throw new ArgumentException("Invalid state 0. Random object has not been properly initialized");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckMax(int max)
        {
            if (max < 0)
                throw new ArgumentException("max must be positive");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        private static void CheckMinMax(long min, long max)
        {
            if (min > max)
                throw new ArgumentException("min must be less than or equal to max");
        }
    }
}
