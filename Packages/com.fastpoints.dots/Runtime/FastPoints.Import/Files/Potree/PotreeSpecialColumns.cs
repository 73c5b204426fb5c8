using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>Where a batch keeps the columns that are more than a copy; -1 where one is not wanted. Blittable.</summary>
    unsafe struct PotreeSpecialColumns
    {
        /// <summary>First byte of X, Y, Z in the batch.</summary>
        public int3 Position;

        /// <summary>First byte of NormalX, NormalY, NormalZ in the batch, where they are packed in two bytes.</summary>
        public int3 Normal;

        public int NormalRecordByte;
        public bool IsOctahedral;

        /// <summary>Of the wanted columns of a batch.</summary>
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

        /// <param name="from">The two bytes of the first point.</param>
        /// <param name="first">Its place in the columns.</param>
        public void DecodeNormals(byte* from, int stride, int count, byte* columns, int first)
        {
            for (int i = 0; i < count; i++, from += stride)
            {
                var normal = IsOctahedral ? PotreeNormals.FromOctahedron(from[0], from[1]) : PotreeNormals.FromSphereMap(from[0], from[1]);
                for (int axis = 0; axis < 3; axis++)
                    if (Normal[axis] >= 0)
                        ((float*)(columns + Normal[axis]))[first + i] = normal[axis];
            }
        }
    }
}
