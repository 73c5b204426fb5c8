using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Copies the chosen points of a decoded block to the sample: stratum i's point to place i. Blocks write to disjoint
    /// places, so any number of these may run at the same time.</summary>
    [BurstCompile]
    internal struct SampleBlockJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfBlock;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        /// <summary>The points from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        /// <summary>Index of the block's first point in the whole source.</summary>
        public long FirstPoint;

        public SampleStrata Strata;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Sample;

        /// <summary>Set to 1 at each place that is written.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Filled;

        public unsafe void Execute()
        {
            long begin = FirstPoint + First;
            long end = FirstPoint + (End < Result.Value.Points ? End : Result.Value.Points);
            end = end < Strata.Points ? end : Strata.Points;
            if (end <= begin)
                return;
            int* fromIndex = stackalloc int[RunLength];
            int* toIndex = stackalloc int[RunLength];
            int chosen = 0;
            int last = Strata.StratumOf(end - 1);
            for (int stratum = Strata.StratumOf(begin); stratum <= last; stratum++)
            {
                long point = Strata.Chosen(stratum);
                if (point >= begin && point < end)
                {
                    fromIndex[chosen] = (int)(point - FirstPoint);
                    toIndex[chosen] = stratum;
                    chosen++;
                }
                if (chosen == RunLength || stratum == last)
                {
                    CopyRun(fromIndex, toIndex, chosen);
                    chosen = 0;
                }
            }
        }

        unsafe void CopyRun(int* fromIndex, int* toIndex, int count)
        {
            byte* from = (byte*)Block.GetUnsafeReadOnlyPtr();
            byte* to = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sample);
            for (int column = 0; column < ColumnsOfSample.Length; column++)
                ColumnCopy.Scatter(from + ColumnsOfBlock[column].OffsetBytes, to + ColumnsOfSample[column].OffsetBytes,
                    ColumnsOfSample[column].Type.SizeOf(), fromIndex, toIndex, count);
            byte* filled = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Filled);
            for (int i = 0; i < count; i++)
                filled[toIndex[i]] = 1;
        }
    }
}
