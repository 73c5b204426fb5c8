using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Copies the first points of a decoded range to consecutive places of the sample. Ranges go to disjoint places, so
    /// any number of these may run at the same time.</summary>
    [BurstCompile]
    struct CopyPrefixJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Decoded;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfDecoded;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        /// <summary>The points from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;

        /// <summary>Place of the first of all points.</summary>
        public int FirstPlace;

        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Sample;

        /// <summary>Set to 1 at each place that is written.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> Filled;

        public unsafe void Execute()
        {
            int count = (End < Result.Value.Points ? End : Result.Value.Points) - First;
            if (count <= 0)
                return;
            byte* from = (byte*)Decoded.GetUnsafeReadOnlyPtr();
            byte* to = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Sample);
            for (int column = 0; column < ColumnsOfSample.Length; column++)
            {
                int size = ColumnsOfSample[column].Type.SizeOf();
                UnsafeUtility.MemCpy(to + ColumnsOfSample[column].OffsetBytes + ((long)FirstPlace + First) * size,
                    from + ColumnsOfDecoded[column].OffsetBytes + (long)First * size, (long)count * size);
            }
            var filled = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Filled);
            UnsafeUtility.MemSet(filled + FirstPlace + First, 1, count);
        }
    }
}
