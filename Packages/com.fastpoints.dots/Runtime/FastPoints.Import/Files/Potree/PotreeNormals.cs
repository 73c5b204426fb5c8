using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Potree's unit vectors in two bytes. HPC#.</summary>
    public static class PotreeNormals
    {
        /// <summary>Pranckevičius, "Compact normal storage for small G-buffers", method 4 (spheremap transform): within 0.02 of
        /// what was packed, but for z near -1, where the map has its seam.</summary>
        public static float3 FromSphereMap(byte bx, byte by)
        {
            float x = bx * (2f / 255f) - 1, y = by * (2f / 255f) - 1;
            float squared = 1 - x * x - y * y;
            // Bytes outside the disc are no vectors that a writer packs: the nearest one on its rim, which is (0, 0, -1).
            float root = math.sqrt(math.max(0, squared));
            return math.normalizesafe(new float3(2 * x * root, 2 * y * root, 2 * squared - 1), new float3(0, 0, -1));
        }

        /// <summary>Meyer et al., "On floating-point normal vectors", 2010: octahedral normals.</summary>
        public static float3 FromOctahedron(byte bx, byte by)
        {
            float u = bx * (2f / 255f) - 1, v = by * (2f / 255f) - 1;
            float z = 1 - math.abs(u) - math.abs(v);
            float x = u, y = v;
            if (z < 0)
            {
                x = (1 - math.abs(v)) * (u < 0 ? -1 : 1);
                y = (1 - math.abs(u)) * (v < 0 ? -1 : 1);
            }
            return math.normalizesafe(new float3(x, y, z), new float3(0, 0, 1));
        }
    }
}
