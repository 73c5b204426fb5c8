using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    /// <summary>Counts a slice of a sample into the cells of a grid.</summary>
    [BurstCompile]
    public struct CountSampledCellsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Sample;
        public PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public ErrorGrid Grid;

        public NativeArray<ulong> CellsOf128th;
        public NativeArray<long> PointsOfBlock;

        public unsafe void Execute() => CountOccupancyJob.Count((byte*)Sample.GetUnsafeReadOnlyPtr(), Positions, Transform,
            First, Count, Grid, (ulong*)CellsOf128th.GetUnsafePtr(), (long*)PointsOfBlock.GetUnsafePtr());
    }
}
