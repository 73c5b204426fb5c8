using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Points
{
    /// <summary>Range of some values of a column, as they are stored, for <see cref="MeasureColumnJob"/>.</summary>
    [BurstCompile]
    public struct MeasureRangeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PointColumn Column;
        public int First;
        public int Count;

        /// <summary>Whose range takes them in.</summary>
        public NativeReference<ColumnQuantiles> Found;

        public unsafe void Execute()
        {
            var found = Found.Value;
            byte* column = (byte*)Bytes.GetUnsafeReadOnlyPtr() + Column.OffsetBytes;
            found.Range.Include(ColumnRange.Measure(column, Column.Type, First, Count));
            Found.Value = found;
        }
    }
}
