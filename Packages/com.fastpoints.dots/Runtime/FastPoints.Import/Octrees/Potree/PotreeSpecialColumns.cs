using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.Octrees
{
    // Columns that are more than a copy; -1 for unwanted ones. Blittable.
    unsafe struct PotreeSpecialColumns
    {
        // First byte of X, Y, Z in the batch.
        public int3 Position;

        // First byte of NormalX, NormalY, NormalZ in the batch, if they are packed in two bytes.
        public int3 Normal;

        public int NormalRecordByte;
        public bool IsOctahedral;

        public static PotreeSpecialColumns Of(PotreeLayout layout, PointBatch batch)
        {
            var special = new PotreeSpecialColumns { Position = -1, Normal = -1 };
            foreach (var attribute in layout.Attributes)
            {
                bool isPosition = attribute == layout.Position;
                if (!isPosition && !attribute.IsPackedNormal)
                    continue;
                for (int axis = 0; axis < 3; axis++)
                {
                    int index = batch.Schema.IndexOf(attribute.Columns[axis].Name);
                    if (index >= 0 && isPosition)
                        special.Position[axis] = batch.Column(index).OffsetBytes;
                    else if (index >= 0)
                        special.TakeNormal(attribute, axis, batch.Column(index).OffsetBytes);
                }
            }
            return special;
        }

        void TakeNormal(PotreeAttribute attribute, int axis, int column)
        {
            Normal[axis] = column;
            NormalRecordByte = attribute.RecordOffset;
            IsOctahedral = attribute.Kind == PotreeAttributeKind.OctahedralNormal;
        }

        public void DecodeNormals(byte* from, int stride, int count, byte* columns, int first)
        {
            for (int i = 0; i < count; i++, from += stride)
            {
                var normal = IsOctahedral
                    ? PotreeNormals.FromOctahedron(from[0], from[1]) : PotreeNormals.FromSphereMap(from[0], from[1]);
                for (int axis = 0; axis < 3; axis++)
                    if (Normal[axis] >= 0)
                        ((float*)(columns + Normal[axis]))[first + i] = normal[axis];
            }
        }
    }

    internal static class PotreeNormals
    {
        // Pranckevičius, "Compact normal storage for small G-buffers", method 4 (spheremap transform): within 0.02 of what was
        // packed, except for z near -1, where the map has its seam.
        public static float3 FromSphereMap(byte bx, byte by)
        {
            float x = bx * (2f / 255f) - 1, y = by * (2f / 255f) - 1;
            float squared = 1 - x * x - y * y;
            // Writers never pack bytes outside the disc: they become the nearest vector on its rim, which is (0, 0, -1).
            float root = math.sqrt(math.max(0, squared));
            return math.normalizesafe(new float3(2 * x * root, 2 * y * root, 2 * squared - 1), new float3(0, 0, -1));
        }

        // Meyer et al., "On floating-point normal vectors", 2010: octahedral normals.
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
