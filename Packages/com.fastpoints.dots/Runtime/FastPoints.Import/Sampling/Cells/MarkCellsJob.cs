using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Marks the cells of those places of a sample that hold a point.</summary>
    [BurstCompile]
    struct MarkCellsJob : IJob
    {
        const int RunLength = ColumnValues.RunLength;

        [ReadOnly] public NativeArray<byte> Sample;
        [ReadOnly] public NativeArray<byte> Filled;
        public PositionColumns Positions;
        public PositionTransform Transform;

        /// <summary>Places from <see cref="First"/> to before <see cref="End"/>.</summary>
        public int First;
        public int End;

        public EmptyCells Cells;

        /// <summary>Must be cleared before the first place.</summary>
        public NativeArray<ulong> Table;

        public unsafe void Execute()
        {
            double* x = stackalloc double[RunLength];
            double* y = stackalloc double[RunLength];
            double* z = stackalloc double[RunLength];
            var table = (ulong*)Table.GetUnsafePtr();
            if (First == 0)
                UnsafeUtility.MemClear(table, Table.Length * sizeof(ulong));
            byte* sample = (byte*)Sample.GetUnsafeReadOnlyPtr();
            for (int first = First; first < End; first += RunLength)
            {
                int run = End - first < RunLength ? End - first : RunLength;
                Positions.Load(sample, first, run, x, y, z);
                Transform.ToGeo(run, x, y, z);
                for (int i = 0; i < run; i++)
                    if (Filled[first + i] != 0 && PositionBounds.IsFinite(x[i], y[i], z[i]))
                        Cells.Mark(table, x[i], y[i], z[i]);
            }
        }
    }
}
