using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Copies places of a sample that is still collected to those of one to draw, and fills the empty ones among them
    /// with other points, one after the other.</summary>
    [BurstCompile]
    struct FillPlacesJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        [ReadOnly] public NativeArray<byte> Sample;
        [ReadOnly] public NativeArray<byte> Filled;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfOthers;
        [ReadOnly] public NativeArray<byte> Others;

        /// <summary>How many of these there are.</summary>
        public int OtherCount;

        /// <summary>How many of these have found a place.</summary>
        public NativeReference<int> OthersPlaced;

        /// <summary>Places from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        /// <summary>Laid out as <see cref="Sample"/> is.</summary>
        public NativeArray<byte> Target;
        public NativeArray<byte> TargetFilled;

        public unsafe void Execute()
        {
            byte* sample = (byte*)Sample.GetUnsafeReadOnlyPtr();
            byte* target = (byte*)Target.GetUnsafePtr();
            for (int column = 0; column < ColumnsOfSample.Length; column++)
            {
                long size = ColumnsOfSample[column].Type.SizeOf();
                long offset = ColumnsOfSample[column].OffsetBytes + First * size;
                UnsafeUtility.MemCpy(target + offset, sample + offset, (End - First) * size);
            }
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            int other = OthersPlaced.Value;
            int run = 0;
            for (int place = First; place < End; place++)
            {
                bool isEmpty = Filled[place] == 0;
                TargetFilled[place] = (byte)(isEmpty && other == OtherCount ? 0 : 1);
                if (isEmpty && other < OtherCount)
                {
                    from[run] = other++;
                    to[run++] = place;
                }
                if (run == RunLength)
                {
                    Place(target, from, to, run);
                    run = 0;
                }
            }
            Place(target, from, to, run);
            OthersPlaced.Value = other;
        }

        unsafe void Place(byte* target, int* from, int* to, int count)
        {
            for (int column = 0; column < ColumnsOfSample.Length; column++)
                ColumnCopy.Scatter((byte*)Others.GetUnsafeReadOnlyPtr() + ColumnsOfOthers[column].OffsetBytes,
                    target + ColumnsOfSample[column].OffsetBytes, ColumnsOfSample[column].Type.SizeOf(), from, to, count);
        }
    }
}
