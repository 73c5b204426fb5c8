using System.Diagnostics;

namespace Unity.Mathematics;

/// <summary>Xorshift (13, 17, 5) of 32 bits; the sequence is Unity's for the same seed. A state of zero is a fixed
/// point.</summary>
public struct Random
{
    public uint state;

    [MethodImpl(Inline)]
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

    public bool NextBool() => (NextState() & 1) == 1;

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
    [MethodImpl(Inline)] public float NextFloat() => math.asfloat(0x3F800000u | (NextState() >> 9)) - 1.0f;
    public float NextFloat(float max) => NextFloat() * max;
    public float NextFloat(float min, float max) => NextFloat() * (max - min) + min;

    public double NextDouble()
    {
        ulong bits = ((ulong)NextState() << 20) ^ NextState();
        return math.asdouble(0x3FF0000000000000ul | bits) - 1.0;
    }

    public double NextDouble(double max) => NextDouble() * max;
    public double NextDouble(double min, double max) => NextDouble() * (max - min) + min;
    internal float2 NextFloat2() => new float2(NextFloat(), NextFloat());
    public float2 NextFloat2(float2 max) => NextFloat2() * max;
    internal double2 NextDouble2() => new double2(NextDouble(), NextDouble());
    public double2 NextDouble2(double2 min, double2 max) => NextDouble2() * (max - min) + min;
    public double3 NextDouble3() => new double3(NextDouble(), NextDouble(), NextDouble());
    public double3 NextDouble3(double3 max) => NextDouble3() * max;
    public double3 NextDouble3(double3 min, double3 max) => NextDouble3() * (max - min) + min;
    public int2 NextInt2(int2 max) => new int2(NextInt(max.x), NextInt(max.y));
    public int3 NextInt3(int3 max) => new int3(NextInt(max.x), NextInt(max.y), NextInt(max.z));
    public int3 NextInt3(int3 min, int3 max) => new int3(NextInt(min.x, max.x), NextInt(min.y, max.y), NextInt(min.z, max.z));

    private static uint WangHash(uint n)
    {
        n = (n ^ 61u) ^ (n >> 16);
        n *= 9u;
        n ^= n >> 4;
        n *= 0x27D4EB2Du;
        return n ^ (n >> 15);
    }

    [MethodImpl(Inline)]
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
