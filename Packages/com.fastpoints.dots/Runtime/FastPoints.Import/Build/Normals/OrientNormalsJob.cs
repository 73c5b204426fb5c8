using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>A slice of turning normals to the scanners that saw their points.</summary>
    [BurstCompile]
    internal unsafe struct OrientNormalsJob : IJob
    {
        /// <summary>A slice takes about 2 ms.</summary>
        public const int PointsPerSlice = 50_000;

        public int First;
        public int End;
        [ReadOnly] public NativeArray<byte> Batch;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;

        /// <summary>The number of a point's scan, from 1; not read if there is one.</summary>
        public PointColumn Scan;

        /// <summary>By scan: in the batch's coordinates.</summary>
        [ReadOnly] public NativeArray<double3> Scanners;

        public double3 Metres;

        /// <summary>In, out.</summary>
        public NativeArray<ushort> Normals;

        public static OrientNormalsJob Of(PointBatch batch, NativeArray<double3> scanners, double3 metres,
            NativeArray<ushort> normals) => new OrientNormalsJob
            {
                Batch = batch.Bytes,
                X = batch.Column(batch.Schema.IndexOf(AttributeNames.X)),
                Y = batch.Column(batch.Schema.IndexOf(AttributeNames.Y)),
                Z = batch.Column(batch.Schema.IndexOf(AttributeNames.Z)),
                Scan = scanners.Length > 1 ? batch.Column(batch.Schema.IndexOf(AttributeNames.PointSourceId)) : default,
                Scanners = scanners,
                Metres = metres,
                Normals = normals,
            };

        public JobHandle Schedule(int first, int end, JobHandle after)
        {
            (First, End) = (first, end);
            return this.Schedule(after);
        }

        public void Execute()
        {
            var bytes = (byte*)Batch.GetUnsafeReadOnlyPtr();
            for (int i = First; i < End; i++)
            {
                ushort normal = Normals[i];
                if (normal == OctahedralNormal.None || normal == OctahedralNormal.Unset)
                    continue;
                double scan = Scanners.Length == 1 ? 1 : ColumnValues.ToDouble(bytes + Scan.OffsetBytes, Scan.Type, i);
                if (!(scan >= 1 && scan <= Scanners.Length))
                    continue;
                var p = new double3(*(double*)X.At(bytes, i), *(double*)Y.At(bytes, i), *(double*)Z.At(bytes, i));
                if (math.dot((Scanners[(int)scan - 1] - p) * Metres, OctahedralNormal.Decode(normal)) < 0)
                    Normals[i] = OctahedralNormal.Opposite(normal);
            }
        }
    }
}
