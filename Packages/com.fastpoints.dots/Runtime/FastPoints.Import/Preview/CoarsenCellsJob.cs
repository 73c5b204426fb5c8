using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Begins anew with other cells: marks those of a sample's own points, and keeps of the others the first of each
    /// that is bare.</summary>
    [BurstCompile]
    struct CoarsenCellsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Sample;

        /// <summary>Which of the sample's places hold a point.</summary>
        [ReadOnly] public NativeArray<byte> Filled;
        public PositionColumns Positions;
        public PositionTransform Transform;

        public BareCells Cells;
        public BareCells Coarse;
        public NativeArray<ulong> Table;

        [ReadOnly] public NativeArray<PointColumn> ColumnsOfOthers;
        public NativeArray<byte> Others;
        public PositionColumns PositionsOfOthers;
        public NativeReference<int> OtherCount;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            var table = (ulong*)Table.GetUnsafePtr();
            UnsafeUtility.MemClear(table, Table.Length * sizeof(ulong));
            byte* sample = (byte*)Sample.GetUnsafeReadOnlyPtr();
            for (int first = 0; first < Filled.Length; first += RunLength)
            {
                int run = Filled.Length - first < RunLength ? Filled.Length - first : RunLength;
                Positions.LoadGeo(sample, Transform, first, run, x, y, z);
                for (int i = 0; i < run; i++)
                    if (Filled[first + i] != 0 && PositionBounds.IsFinite(x[i], y[i], z[i]))
                        Mark(table, x[i], y[i], z[i]);
            }

            int* from = stackalloc int[RunLength];
            int* to = stackalloc int[RunLength];
            byte* others = (byte*)Others.GetUnsafePtr();
            int count = OtherCount.Value, keptOfAll = 0;
            for (int first = 0; first < count; first += RunLength)
            {
                int run = count - first < RunLength ? count - first : RunLength;
                PositionsOfOthers.LoadGeo(others, Transform, first, run, x, y, z);
                int kept = 0;
                for (int i = 0; i < run; i++)
                {
                    if (!Mark(table, x[i], y[i], z[i]))
                        continue;
                    from[kept] = first + i;
                    to[kept++] = keptOfAll++;
                }
                // Points only ever move down, and in order.
                for (int column = 0; column < ColumnsOfOthers.Length; column++)
                    ColumnCopy.Scatter(others + ColumnsOfOthers[column].OffsetBytes, others + ColumnsOfOthers[column].OffsetBytes,
                        ColumnsOfOthers[column].Type.SizeOf(), from, to, kept);
            }
            OtherCount.Value = keptOfAll;
        }

        unsafe bool Mark(ulong* table, double x, double y, double z)
        {
            if (!Cells.Mark(table, x, y, z))
                return false;
            Coarse.Mark(table, x, y, z);
            return true;
        }
    }
}
