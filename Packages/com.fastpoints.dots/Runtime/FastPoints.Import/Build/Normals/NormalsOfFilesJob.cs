using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>A slice of packing normals that points have as attributes; those that are no direction become none.</summary>
    [BurstCompile]
    internal unsafe struct NormalsOfFilesJob : IJob
    {
        /// <summary>A slice takes about 2 ms.</summary>
        public const int PointsPerSlice = 50_000;

        public int First;
        public int End;
        [ReadOnly] public NativeArray<byte> Batch;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;
        public double3 Scale;
        public double3 Offset;

        /// <summary>Out, by point.</summary>
        public NativeArray<ushort> Normals;

        public static NormalsOfFilesJob Of(PointBatch batch, string[] names, NativeArray<ushort> normals)
        {
            int x = batch.Schema.IndexOf(names[0]), y = batch.Schema.IndexOf(names[1]), z = batch.Schema.IndexOf(names[2]);
            PointAttribute ofX = batch.Schema[x], ofY = batch.Schema[y], ofZ = batch.Schema[z];
            return new NormalsOfFilesJob
            {
                Batch = batch.Bytes,
                X = batch.Column(x),
                Y = batch.Column(y),
                Z = batch.Column(z),
                Scale = new double3(ofX.Scale, ofY.Scale, ofZ.Scale),
                Offset = new double3(ofX.Offset, ofY.Offset, ofZ.Offset),
                Normals = normals,
            };
        }

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
                var n = Offset + Scale * new double3(ColumnValues.ToDouble(bytes + X.OffsetBytes, X.Type, i),
                    ColumnValues.ToDouble(bytes + Y.OffsetBytes, Y.Type, i),
                    ColumnValues.ToDouble(bytes + Z.OffsetBytes, Z.Type, i));
                // To a length that squares to neither 0 nor infinity.
                n /= math.cmax(math.abs(n));
                Normals[i] = math.all(math.isfinite(n)) ? OctahedralNormal.Encode((float3)n) : OctahedralNormal.None;
            }
        }
    }
}
