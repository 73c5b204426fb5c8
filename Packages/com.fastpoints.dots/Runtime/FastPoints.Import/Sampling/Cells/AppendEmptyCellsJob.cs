using FastPoints.Core;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Appends, from decoded points, the first one of each empty cell: a cell with neither a point that stands for a
    /// stratum, nor one that was appended. These jobs must run one after the other.</summary>
    [BurstCompile]
    struct AppendEmptyCellsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfBlock;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        /// <summary>The points from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;
        public PositionColumns Positions;
        public PositionTransform Transform;

        /// <summary>Index of the block's first point in the whole source.</summary>
        public long FirstPoint;

        /// <summary>Empty if the points belong to no range.</summary>
        public SampleStrata Strata;

        public EmptyCells Cells;
        public NativeArray<ulong> Table;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public NativeArray<byte> Sample;
        public int Capacity;
        public NativeReference<int> Filled;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            byte* block = (byte*)Block.GetUnsafeReadOnlyPtr();
            var table = (ulong*)Table.GetUnsafePtr();
            int end = End < Result.Value.Points ? End : Result.Value.Points;
            MarkChosen(block, table, end, x, y, z);
            int filled = Filled.Value;
            for (int first = First; first < end; first += RunLength)
            {
                int run = end - first < RunLength ? end - first : RunLength;
                Positions.Load(block, first, run, x, y, z);
                Transform.ToGeo(run, x, y, z);
                int chosen = 0;
                for (int i = 0; i < run; i++)
                {
                    if (!PositionBounds.IsFinite(x[i], y[i], z[i]) || !Cells.Mark(table, x[i], y[i], z[i]) || filled == Capacity)
                        continue;
                    from[chosen] = first + i;
                    to[chosen++] = filled++;
                }
                for (int column = 0; chosen > 0 && column < ColumnsOfSample.Length; column++)
                    ColumnCopy.Scatter(block + ColumnsOfBlock[column].OffsetBytes,
                        (byte*)Sample.GetUnsafePtr() + ColumnsOfSample[column].OffsetBytes, ColumnsOfSample[column].Type.SizeOf(),
                        from, to, chosen);
            }
            Filled.Value = filled;
        }

        /// <summary>Marks the cells of the points that stand for a stratum.</summary>
        unsafe void MarkChosen(byte* block, ulong* table, int endOfRange, double* x, double* y, double* z)
        {
            long begin = FirstPoint + First;
            long end = FirstPoint + endOfRange < Strata.Points ? FirstPoint + endOfRange : Strata.Points;
            if (Strata.Count == 0 || end <= begin)
                return;
            int last = Strata.StratumOf(end - 1);
            for (int stratum = Strata.StratumOf(begin); stratum <= last; stratum++)
            {
                long point = Strata.Chosen(stratum);
                if (point < begin || point >= end)
                    continue;
                Positions.Load(block, (int)(point - FirstPoint), 1, x, y, z);
                Transform.ToGeo(1, x, y, z);
                if (PositionBounds.IsFinite(*x, *y, *z))
                    Cells.Mark(table, *x, *y, *z);
            }
        }
    }
}
