using FastPoints.Files;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Verify
{
    /// <summary>Range and sum of each column of a decoded block, and the bounds of its positions.</summary>
    [BurstCompile]
    public struct SummariseBlockJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> Columns;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        public PositionTransform Transform;

        /// <summary>False for a source that lacks X, Y or Z: its bounds stay empty.</summary>
        public bool HasPositions;

        public PositionColumns Positions;
        public NativeArray<ColumnSummary> SummaryOfColumn;
        public NativeReference<PositionBounds> Bounds;

        public unsafe void Execute()
        {
            byte* bytes = (byte*)Block.GetUnsafeReadOnlyPtr();
            int count = Result.Value.Points;
            for (int column = 0; column < Columns.Length; column++)
            {
                var summary = ColumnSummary.EmptyOf(Columns[column].Type);
                summary.IncludeColumn(bytes + Columns[column].OffsetBytes, count);
                SummaryOfColumn[column] = summary;
            }
            Bounds.Value = HasPositions
                ? PositionBounds.Measure(bytes, Positions, Transform, 0, count)
                : PositionBounds.Empty;
        }
    }
}
