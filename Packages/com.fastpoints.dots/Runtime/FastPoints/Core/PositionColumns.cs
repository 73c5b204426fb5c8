using System;
using Unity.Mathematics;

namespace FastPoints.Core
{
    internal struct PositionColumns
    {
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;

        public static PositionColumns Of(PointBatch batch)
        {
            int x = batch.Schema.IndexOf(AttributeNames.X);
            int y = batch.Schema.IndexOf(AttributeNames.Y);
            int z = batch.Schema.IndexOf(AttributeNames.Z);
            if (x < 0 || y < 0 || z < 0)
                throw new ArgumentException("a batch without X, Y and Z: " + batch.Schema, nameof(batch));
            return new PositionColumns { X = batch.Column(x), Y = batch.Column(y), Z = batch.Column(z) };
        }

        public unsafe void Load(byte* bytes, int first, int count, double* x, double* y, double* z)
        {
            ColumnValues.ToDoubles(bytes + X.OffsetBytes, X.Type, first, count, x);
            ColumnValues.ToDoubles(bytes + Y.OffsetBytes, Y.Type, first, count, y);
            ColumnValues.ToDoubles(bytes + Z.OffsetBytes, Z.Type, first, count, z);
        }

        public unsafe void LoadGeo(byte* bytes, in PositionTransform transform, int first, int count, double* x, double* y,
            double* z)
        {
            Load(bytes, first, count, x, y, z);
            double3 scale = transform.Scale, offset = transform.Offset;
            for (int i = 0; i < count; i++)
            {
                x[i] = x[i] * scale.x + offset.x;
                y[i] = y[i] * scale.y + offset.y;
                z[i] = z[i] * scale.z + offset.z;
            }
        }
    }

    /// <summary>Maps the numbers that a file stores to georeferenced positions: geo = stored * <see cref="Scale"/> +
    /// <see cref="Offset"/>, in double, in CRS units. It is the identity for files that store coordinates directly.</summary>
    public struct PositionTransform
    {
        public double3 Scale;
        public double3 Offset;

        public static PositionTransform Identity => new PositionTransform { Scale = new double3(1, 1, 1) };

        public double3 ToGeo(double3 stored) => stored * Scale + Offset;
    }
}
