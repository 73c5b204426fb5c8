using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Core
{
    // Finds the quantiles of value = stored * Scale + Offset, from 0 to 1, after MeasureRangeJob found the range.
    [BurstCompile]
    internal struct MeasureColumnJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PointColumn Column;
        public int Count;
        public double Scale;
        public double Offset;
        public double LowShare;
        public double HighShare;
        public NativeReference<ColumnQuantiles> Found;

        public unsafe void Execute()
        {
            byte* column = (byte*)Bytes.GetUnsafeReadOnlyPtr() + Column.OffsetBytes;
            int capacity = ColumnQuantiles.SampledValues(Count);
            var keys = new NativeArray<ulong>(capacity, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            var scratch = new NativeArray<ulong>(capacity, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            Found.Value = ColumnQuantiles.Measure(Found.Value.Range, column, Column.Type, Count, Scale, Offset, LowShare,
                HighShare, (ulong*)keys.GetUnsafePtr(), (ulong*)scratch.GetUnsafePtr());
            scratch.Dispose();
            keys.Dispose();
        }
    }

    [BurstCompile]
    internal struct MeasureRangeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PointColumn Column;
        public int First;
        public int Count;
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
