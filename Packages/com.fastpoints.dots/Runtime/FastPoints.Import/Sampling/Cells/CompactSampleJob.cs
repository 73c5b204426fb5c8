using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>The progress of <see cref="CompactSampleJob"/>.</summary>
    internal struct CompactedSample
    {
        /// <summary>Points kept so far: the first places of each column.</summary>
        public int Kept;

        public PositionBounds Found;
    }

    /// <summary>Closes the gaps in a sample, one slice of places after the other: places without a point, and points whose
    /// position is not finite, which are counted. It measures the bounds on the way.</summary>
    [BurstCompile]
    internal struct CompactSampleJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        /// <summary>Becomes 0 for a point that is left out.</summary>
        public NativeArray<byte> Filled;
        [ReadOnly] public NativeArray<PointColumn> Columns;
        public NativeArray<byte> Sample;
        public PositionColumns Positions;
        public PositionTransform Transform;
        public int First;
        public int Count;
        public NativeReference<CompactedSample> State;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            int* fromIndex = stackalloc int[RunLength];
            int* toIndex = stackalloc int[RunLength];
            byte* bytes = (byte*)Sample.GetUnsafePtr();
            var state = State.Value;
            for (int done = 0; done < Count; done += RunLength)
            {
                int start = First + done;
                int run = math.min(RunLength, Count - done);
                Positions.Load(bytes, start, run, x, y, z);
                Transform.ToGeo(run, x, y, z);
                int kept = 0;
                for (int i = 0; i < run; i++)
                {
                    if (Filled[start + i] == 0)
                        continue;
                    if (!PositionBounds.IsFinite(x[i], y[i], z[i]))
                    {
                        state.Found.NonFinite++;
                        Filled[start + i] = 0;
                        continue;
                    }
                    x[kept] = x[i];
                    y[kept] = y[i];
                    z[kept] = z[i];
                    fromIndex[kept] = start + i;
                    toIndex[kept] = state.Kept + kept;
                    kept++;
                }
                state.Found.IncludeRun(x, y, z, kept);

                // Places only ever move down, and in order, so that a column can be its own source and destination.
                if (state.Kept != start || kept != run)
                    for (int column = 0; column < Columns.Length; column++)
                        ColumnCopy.Scatter(bytes + Columns[column].OffsetBytes, bytes + Columns[column].OffsetBytes,
                            Columns[column].Type.SizeOf(), fromIndex, toIndex, kept);
                state.Kept += kept;
            }
            State.Value = state;
        }
    }
}
