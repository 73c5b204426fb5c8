using Unity.Mathematics;

namespace FastPoints.Drawing
{
    /// <summary>A unit vector as two bytes: the octahedron that it points through, unfolded into a square (Meyer et al., On
    /// Floating-Point Normal Vectors, 2010). 128 is the middle of both, and 0 stands for no normal.</summary>
    /// <remarks>The decoded vector is 0.33 degrees from the encoded one on average, and 0.95 at most.</remarks>
    internal static class OctahedralNormal
    {
        public const ushort None = 0;
        public const ushort Unset = 1; // No vector's code, and not stored: the point was not looked at.

        const int Middle = 128;
        const int Largest = 127;

        /// <param name="direction">Of any length but 0.</param>
        public static ushort Encode(float3 direction)
        {
            var p = direction.xy / (math.abs(direction.x) + math.abs(direction.y) + math.abs(direction.z));
            if (direction.z < 0)
                p = Fold(p);
            int u = Middle + (int)math.round(p.x * Largest), v = Middle + (int)math.round(p.y * Largest);
            return (ushort)(u | v << 8);
        }

        public static float3 Decode(ushort code)
        {
            var p = new float2((code & 0xFF) - Middle, (code >> 8) - Middle) / Largest;
            float z = 1 - math.abs(p.x) - math.abs(p.y);
            if (z < 0)
                p = Fold(p);
            return math.normalize(new float3(p, z));
        }

        /// <summary>A unit vector of the world; 0 of no normal. toWorld: see DrawListCloud.NormalsToWorld.</summary>
        public static float3 ToWorld(ushort code, in double3x3 toWorld) =>
            code == None ? default : (float3)math.normalize(math.mul(toWorld, (double3)Decode(code)));

        /// <summary>The code of the opposite vector, exactly.</summary>
        public static ushort Opposite(ushort code) => Encode(-Decode(code));

        static float2 Fold(float2 p) =>
            new float2((1 - math.abs(p.y)) * (p.x >= 0 ? 1 : -1), (1 - math.abs(p.x)) * (p.y >= 0 ? 1 : -1));
    }
}
