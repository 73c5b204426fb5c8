using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>Draws a range of a batch's points; index i is its i-th piece of <see cref="PointsPerPiece"/> points.</summary>
    [BurstCompile]
    public struct RasterizePointsJob : IJobFor
    {
        public const int PointsPerPiece = 2048;

        [ReadOnly] public NativeArray<byte> Bytes;
        [ReadOnly] public NativeArray<uint> Palettes;
        [ReadOnly] public NativeArray<float> SizeOfTile;
        public PointDrawing Drawing;
        public int First;
        public int Count;

        /// <summary>Written by atomic minimum, so that jobs on other batches may draw at the same time.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<ulong> Pixels;

        public static int PieceCount(int points) => (points + PointsPerPiece - 1) / PointsPerPiece;

        public unsafe void Execute(int index)
        {
            int start = index * PointsPerPiece;
            Drawing.Draw((byte*)Bytes.GetUnsafeReadOnlyPtr(), (uint*)Palettes.GetUnsafeReadOnlyPtr(),
                (float*)SizeOfTile.GetUnsafeReadOnlyPtr(), First + start, math.min(PointsPerPiece, Count - start),
                (ulong*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Pixels));
        }
    }
}
