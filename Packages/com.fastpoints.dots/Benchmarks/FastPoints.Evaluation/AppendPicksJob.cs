using FastPoints.Files;
using FastPoints.Points;
using FastPoints.Preview;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Evaluation
{
    /// <summary>Appends, of the points of a decoded range, those that a regular choice falls on: the k-th choice of
    /// <see cref="Wanted"/> is point floor(k * Total / Wanted).</summary>
    [BurstCompile]
    public struct AppendPicksJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Range;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfRange;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        /// <summary>Where the range begins among the <see cref="Total"/> points to choose from.</summary>
        public long FirstPoint;
        public long Total;

        /// <summary>No more than <see cref="Total"/>, and than the sample has places.</summary>
        public int Wanted;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public NativeArray<byte> Sample;

        /// <summary>Places filled so far.</summary>
        public NativeReference<int> Filled;

        public unsafe void Execute()
        {
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            long end = FirstPoint + Result.Value.Points;
            int filled = Filled.Value;
            long choice = FirstChoiceFrom(FirstPoint);
            while (choice < Wanted)
            {
                int run = 0;
                for (; run < RunLength && choice < Wanted; choice++)
                {
                    long point = choice * Total / Wanted;
                    if (point >= end)
                        break;
                    from[run] = (int)(point - FirstPoint);
                    to[run++] = filled++;
                }
                if (run == 0)
                    break;
                for (int column = 0; column < ColumnsOfSample.Length; column++)
                    ColumnCopy.Scatter((byte*)Range.GetUnsafeReadOnlyPtr() + ColumnsOfRange[column].OffsetBytes,
                        (byte*)Sample.GetUnsafePtr() + ColumnsOfSample[column].OffsetBytes, ColumnsOfSample[column].Type.SizeOf(),
                        from, to, run);
            }
            Filled.Value = filled;
        }

        /// <summary>The first choice at a point or behind it: ceil(point * Wanted / Total).</summary>
        long FirstChoiceFrom(long point) => (point * Wanted + Total - 1) / Total;
    }
}
