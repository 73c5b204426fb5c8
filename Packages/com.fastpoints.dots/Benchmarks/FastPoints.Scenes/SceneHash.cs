using Unity.Mathematics;

namespace FastPoints.Scenes
{
    /// <summary>Counter-based random numbers: a value depends only on its purpose (seed, line, ray, use), never on the order in
    /// which threads ask. The mixer is the 32-bit finaliser of MurmurHash3.</summary>
    internal static class SceneHash
    {
        public static uint Mix(uint x)
        {
            x ^= x >> 16;
            x *= 0x85EBCA6Bu;
            x ^= x >> 13;
            x *= 0xC2B2AE35u;
            return x ^ (x >> 16);
        }

        public static uint Of(uint a, uint b) => Mix(a * 0x9E3779B9u + Mix(b + 0x7F4A7C15u));
        public static uint Of(uint a, uint b, uint c) => Of(Of(a, b), c);

        /// <summary>The next number of a stream: uniform in [0, 1).</summary>
        public static float Next(ref uint state)
        {
            state += 0x9E3779B9u;
            return (Mix(state) >> 8) * (1f / (1 << 24));
        }

        /// <summary>A number of mean 0 and deviation 1: the sum of four uniform numbers, which never outliers beyond
        /// 3.5.</summary>
        public static float NextNormal(ref uint state) =>
            (Next(ref state) + Next(ref state) + Next(ref state) + Next(ref state) - 2) * 1.7320508f;

        /// <summary>A random value, [0, 1), of each cell of a 3D grid.</summary>
        public static float OfCell(int3 cell, uint seed) =>
            (Of((uint)cell.x * 73856093u ^ (uint)cell.y * 19349663u, (uint)cell.z, seed) >> 8) * (1f / (1 << 24));

        /// <summary>Smooth noise, [0, 1], with features of the size 1.</summary>
        public static float Noise(float2 p, uint seed)
        {
            var floor = math.floor(p);
            var cell = (int2)floor;
            var f = p - floor;
            f = f * f * (3 - 2 * f);
            float a = OfCell(new int3(cell.x, cell.y, 0), seed), b = OfCell(new int3(cell.x + 1, cell.y, 0), seed);
            float c = OfCell(new int3(cell.x, cell.y + 1, 0), seed), d = OfCell(new int3(cell.x + 1, cell.y + 1, 0), seed);
            return math.lerp(math.lerp(a, b, f.x), math.lerp(c, d, f.x), f.y);
        }
    }
}
