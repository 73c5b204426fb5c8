using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Core
{
    /// <summary>Finds the quantiles of one column of any type, as value = stored * Scale + Offset, after its range.</summary>
    [BurstCompile]
    internal struct MeasureColumnJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PointColumn Column;
        public int Count;
        public double Scale;
        public double Offset;

        /// <summary>Shares of the values below <see cref="ColumnQuantiles.Low"/> and <see cref="ColumnQuantiles.High"/>, 0 to
        /// 1.</summary>
        public double LowShare;
        public double HighShare;

        /// <summary>Holds the range that <see cref="MeasureRangeJob"/> found.</summary>
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

    /// <summary>Finds the range of some stored values of a column, for <see cref="MeasureColumnJob"/>.</summary>
    [BurstCompile]
    internal struct MeasureRangeJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Bytes;
        public PointColumn Column;
        public int First;
        public int Count;

        /// <summary>Its range is extended by these values.</summary>
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
