using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Copies the existing points of a sample that is still being collected to the beginning of one to draw, one slice
    /// of places after the other.</summary>
    [BurstCompile]
    struct GatherPlacesJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Sample;
        [ReadOnly] public NativeArray<byte> Filled;

        /// <summary>Places from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        [ReadOnly] public NativeArray<PointColumn> Columns;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfTarget;
        public NativeArray<byte> Target;
        public NativeArray<byte> TargetFilled;

        /// <summary>Number of points in the target so far.</summary>
        public NativeReference<int> Gathered;

        public unsafe void Execute()
        {
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            int gathered = Gathered.Value;
            for (int first = First; first < End; first += RunLength)
            {
                int end = End - first < RunLength ? End : first + RunLength, run = 0;
                for (int place = first; place < end; place++)
                {
                    if (Filled[place] == 0)
                        continue;
                    from[run] = place;
                    to[run++] = gathered++;
                }
                for (int column = 0; run > 0 && column < Columns.Length; column++)
                    ColumnCopy.Scatter((byte*)Sample.GetUnsafeReadOnlyPtr() + Columns[column].OffsetBytes,
                        (byte*)Target.GetUnsafePtr() + ColumnsOfTarget[column].OffsetBytes,
                        Columns[column].Type.SizeOf(), from, to, run);
                for (int i = 0; i < run; i++)
                    TargetFilled[to[i]] = 1;
            }
            Gathered.Value = gathered;
        }
    }
}
