using FastPoints.Drawing;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Packs normals that points have as attributes; those that are no direction become none.</summary>
    [BurstCompile]
    internal unsafe struct NormalsOfFilesJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Batch;
        public PointColumn X;
        public PointColumn Y;
        public PointColumn Z;
        public double3 Scale;
        public double3 Offset;
        public int Count;

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
                Count = batch.Count,
                Normals = normals,
            };
        }

        public void Execute()
        {
            var bytes = (byte*)Batch.GetUnsafeReadOnlyPtr();
            for (int i = 0; i < Count; i++)
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
