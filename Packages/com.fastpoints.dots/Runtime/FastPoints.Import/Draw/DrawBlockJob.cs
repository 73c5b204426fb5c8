using FastPoints.Files;
using FastPoints.Picture;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Draw
{
    /// <summary>Draws a decoded block; index i is its i-th piece of <see cref="RasterizePointsJob.PointsPerPiece"/>
    /// points.</summary>
    [BurstCompile]
    public struct DrawBlockJob : IJobFor
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        [ReadOnly] public NativeArray<uint> Palettes;
        [ReadOnly] public NativeArray<float> SizeOfTile;
        public PointDrawing Drawing;

        /// <summary>Written by atomic minimum, so that jobs on other blocks may draw at the same time.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Pixels;

        public unsafe void Execute(int index)
        {
            int start = index * RasterizePointsJob.PointsPerPiece;
            int count = math.min(RasterizePointsJob.PointsPerPiece, Result.Value.Points - start);
            if (count > 0)
                Drawing.Draw((byte*)Block.GetUnsafeReadOnlyPtr(), (uint*)Palettes.GetUnsafeReadOnlyPtr(),
                    (float*)SizeOfTile.GetUnsafeReadOnlyPtr(), start, count,
                    (ulong*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Pixels));
        }
    }
}
