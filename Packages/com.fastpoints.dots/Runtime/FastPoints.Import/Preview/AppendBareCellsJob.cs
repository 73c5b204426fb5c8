using FastPoints.Files;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>
    /// Appends, of a decoded range, the first point of each cell in which there is none so far: neither one of those that stand
    /// for a stratum, nor one that was appended. One of these after the other.
    /// </summary>
    [BurstCompile]
    struct AppendBareCellsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Block;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfBlock;
        [ReadOnly] public NativeReference<DecodeResult> Result;
        public PositionColumns Positions;
        public PositionTransform Transform;

        /// <summary>Index of the range's first point over the whole source.</summary>
        public long FirstPoint;
        public SampleStrata Strata;

        public BareCells Cells;

        /// <summary>Larger ones, in the same table, which are counted.</summary>
        public BareCells Coarse;
        public NativeArray<ulong> Table;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSample;
        public NativeArray<byte> Sample;
        public int Capacity;
        public NativeReference<int> Filled;

        /// <summary>Of each slot, of which this one's is set: cells that were bare.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<int> CellsOfSlot;
        public int Slot;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            byte* block = (byte*)Block.GetUnsafeReadOnlyPtr();
            var table = (ulong*)Table.GetUnsafePtr();
            int count = Result.Value.Points;
            int cells = MarkChosen(block, table, count, x, y, z);
            int filled = Filled.Value;
            for (int first = 0; first < count; first += RunLength)
            {
                int run = count - first < RunLength ? count - first : RunLength;
                Positions.LoadGeo(block, Transform, first, run, x, y, z);
                int chosen = 0;
                for (int i = 0; i < run; i++)
                {
                    if (!PositionBounds.IsFinite(x[i], y[i], z[i]) || !Cells.Mark(table, x[i], y[i], z[i]))
                        continue;
                    cells += Coarse.Mark(table, x[i], y[i], z[i]) ? 1 : 0;
                    if (filled == Capacity)
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
            CellsOfSlot[Slot] = cells;
        }

        /// <summary>Marks the cells of the points that stand for a stratum.</summary>
        /// <returns>Those that were bare.</returns>
        unsafe int MarkChosen(byte* block, ulong* table, int count, double* x, double* y, double* z)
        {
            long end = FirstPoint + count < Strata.Points ? FirstPoint + count : Strata.Points;
            int cells = 0;
            if (Strata.Count == 0 || end <= FirstPoint)
                return cells;
            int last = Strata.StratumOf(end - 1);
            for (int stratum = Strata.StratumOf(FirstPoint); stratum <= last; stratum++)
            {
                long point = Strata.Chosen(stratum);
                if (point < FirstPoint || point >= end)
                    continue;
                Positions.LoadGeo(block, Transform, (int)(point - FirstPoint), 1, x, y, z);
                if (PositionBounds.IsFinite(*x, *y, *z) && Cells.Mark(table, *x, *y, *z))
                    cells += Coarse.Mark(table, *x, *y, *z) ? 1 : 0;
            }
            return cells;
        }
    }
}
