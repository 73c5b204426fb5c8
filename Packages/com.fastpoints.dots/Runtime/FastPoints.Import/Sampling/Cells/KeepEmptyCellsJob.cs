using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Keeps the first point of each empty cell, in one slice of points after the other, and moves these
    /// together.</summary>
    [BurstCompile]
    struct KeepEmptyCellsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<PointColumn> Columns;
        public NativeArray<byte> Points;
        public PositionColumns Positions;
        public PositionTransform Transform;

        /// <summary>Points from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        public EmptyCells Cells;
        public NativeArray<ulong> Table;

        /// <summary>Number of points kept in all slices so far.</summary>
        public NativeReference<int> Kept;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            var table = (ulong*)Table.GetUnsafePtr();
            byte* points = (byte*)Points.GetUnsafePtr();
            int keptOfAll = First == 0 ? 0 : Kept.Value;
            for (int first = First; first < End; first += RunLength)
            {
                int run = End - first < RunLength ? End - first : RunLength;
                Positions.Load(points, first, run, x, y, z);
                Transform.ToGeo(run, x, y, z);
                int kept = 0;
                for (int i = 0; i < run; i++)
                {
                    if (!Cells.Mark(table, x[i], y[i], z[i]))
                        continue;
                    from[kept] = first + i;
                    to[kept++] = keptOfAll++;
                }
                // Points only ever move down, and in order, so that a column can be its own source and destination.
                for (int column = 0; column < Columns.Length; column++)
                    ColumnCopy.Scatter(points + Columns[column].OffsetBytes, points + Columns[column].OffsetBytes,
                        Columns[column].Type.SizeOf(), from, to, kept);
            }
            Kept.Value = keptOfAll;
        }
    }
}
