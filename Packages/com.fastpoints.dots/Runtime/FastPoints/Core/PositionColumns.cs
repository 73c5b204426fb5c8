using System;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints
{
    internal struct PositionColumns
    {
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;

        public static PointAttribute[] Attributes(AttributeType type) => new[]
        {
            new PointAttribute(AttributeNames.X, type),
            new PointAttribute(AttributeNames.Y, type),
            new PointAttribute(AttributeNames.Z, type),
        };

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

        public unsafe double3 StoredAt(byte* bytes, int index)
        {
            double3 stored;
            Load(bytes, index, 1, &stored.x, &stored.y, &stored.z);
            return stored;
        }

        public unsafe double3 GeoAt(byte* bytes, in PositionTransform transform, int index) =>
            transform.ToGeo(StoredAt(bytes, index));
    }

    /// <summary>Maps a file's numbers to georeferenced positions: geo = stored * Scale + Offset, in CRS units.</summary>
    public struct PositionTransform
    {
        public double3 Scale;
        public double3 Offset;

        public static PositionTransform Identity => new PositionTransform { Scale = new double3(1, 1, 1) };

        public readonly double3 ToGeo(double3 stored) => stored * Scale + Offset;

        internal readonly unsafe void ToGeo(int count, double* x, double* y, double* z)
        {
            double3 scale = Scale, offset = Offset;
            for (int i = 0; i < count; i++)
            {
                x[i] = x[i] * scale.x + offset.x;
                y[i] = y[i] * scale.y + offset.y;
                z[i] = z[i] * scale.z + offset.z;
            }
        }
    }

    // Georeferenced bounds of the finite positions among some points, and how many had a coordinate that is not finite.
    internal struct PositionBounds
    {
        public BoundsGeo Bounds;
        public long NonFiniteCount;

        public static PositionBounds Empty => new PositionBounds { Bounds = BoundsGeo.Empty };

        public void Include(in PositionBounds other)
        {
            Bounds.Include(other.Bounds);
            NonFiniteCount += other.NonFiniteCount;
        }

        // At most ColumnValues.BatchLength positions.
        public unsafe void IncludeBatch(double* x, double* y, double* z, int count)
        {
            double3 min = Bounds.Min, max = Bounds.Max;
            for (int i = 0; i < count; i++)
            {
                double px = x[i], py = y[i], pz = z[i];
                if (!IsFinite(px, py, pz))
                {
                    NonFiniteCount++;
                    continue;
                }
                min.x = px < min.x ? px : min.x;
                min.y = py < min.y ? py : min.y;
                min.z = pz < min.z ? pz : min.z;
                max.x = px > max.x ? px : max.x;
                max.y = py > max.y ? py : max.y;
                max.z = pz > max.z ? pz : max.z;
            }
            Bounds = new BoundsGeo(min, max);
        }

        // x - x is 0 for a finite x and NaN for any other.
        public static bool IsFinite(double x, double y, double z) => x - x + (y - y) + (z - z) == 0;

        public static unsafe PositionBounds Measure(byte* bytes, in PositionColumns columns, in PositionTransform transform,
            int first, int count)
        {
            double* x = stackalloc double[ColumnValues.BatchLength];
            double* y = stackalloc double[ColumnValues.BatchLength];
            double* z = stackalloc double[ColumnValues.BatchLength];
            var found = Empty;
            for (int done = 0; done < count; done += ColumnValues.BatchLength)
            {
                int length = math.min(ColumnValues.BatchLength, count - done);
                columns.Load(bytes, first + done, length, x, y, z);
                transform.ToGeo(length, x, y, z);
                found.IncludeBatch(x, y, z, length);
            }
            return found;
        }

        public static unsafe PositionBounds RunImmediate(PointBatch points, PositionTransform transform) =>
            Measure((byte*)points.Bytes.GetUnsafeReadOnlyPtr(), PositionColumns.Of(points), transform, 0, points.Count);
    }

    [BurstCompile]
    internal struct MeasureBoundsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PositionColumns Columns;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public NativeReference<PositionBounds> Found;

        public unsafe void Execute()
        {
            var found = Found.Value;
            found.Include(PositionBounds.Measure((byte*)Bytes.GetUnsafeReadOnlyPtr(), Columns, Transform, First, Count));
            Found.Value = found;
        }
    }
}
