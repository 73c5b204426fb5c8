using System.Runtime.CompilerServices;
using FastPoints.Reading;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Marks cubic cells of space that hold a point, by their hash, in a table of bits that its user has.</summary>
    /// <remarks>Two cells may share a bit: with a million occupied ones, 3 % of cells count as occupied too soon.</remarks>
    internal struct CellHashing
    {
        const int BitsLog2 = 25;
        public const int Words = 1 << BitsLog2 - 6; // Words of the table: 4 MiB.

        public double3 Corner;
        public double CellsPerUnit;

        /// <summary>Marks the cell of a position.</summary>
        /// <returns>Whether it was empty.</returns>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public unsafe bool Mark(ulong* table, double x, double y, double z)
        {
            // All distant points share a few cells: a conversion that overflows gives one value, or the nearest.
            long cellX = (long)math.floor((x - Corner.x) * CellsPerUnit);
            long cellY = (long)math.floor((y - Corner.y) * CellsPerUnit);
            long cellZ = (long)math.floor((z - Corner.z) * CellsPerUnit);
            ulong hash = ((ulong)cellX * 0x9E3779B97F4A7C15UL ^ (ulong)cellY) * 0xBF58476D1CE4E5B9UL;
            hash = (hash ^ hash >> 32 ^ (ulong)cellZ) * 0x94D049BB133111EBUL;
            hash = (hash ^ hash >> 29) * 0x9E3779B97F4A7C15UL >> 64 - BitsLog2;
            ulong bit = 1UL << (int)(hash & 63);
            bool wasEmpty = (table[hash >> 6] & bit) == 0;
            table[hash >> 6] |= bit;
            return wasEmpty;
        }
    }

    /// <summary>Appends, from decoded points, the first one of each empty cell: a cell with neither a stratum's point
    /// nor an appended one. These jobs must run one after the other.</summary>
    [BurstCompile]
    struct AppendPlaceholdersJob : IJob
    {
        const int BatchLength = ColumnValues.BatchLength;

        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> From;
        [ReadOnly] public NativeArray<PointColumn> ColumnsOfSource;
        [ReadOnly] public NativeReference<DecodeResult> Result;

        public int First;
        public int End;
        public PositionColumns Positions;
        public PositionTransform Transform;
        public long RangeFirstPoint; // Index in the whole source of the point from which First counts.
        public SampleStrata Strata; // Empty if the points belong to no range.

        public CellHashing Cells;
        public NativeArray<ulong> Table;

        /// <summary>May be the points themselves, if they are kept from the first on.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<byte> To;
        [ReadOnly, NativeDisableContainerSafetyRestriction] public NativeArray<PointColumn> ColumnsOfTarget;
        public int Capacity;
        public NativeReference<int> Kept;

        public unsafe void Execute()
        {
            double* x = stackalloc double[BatchLength];
            double* y = stackalloc double[BatchLength];
            double* z = stackalloc double[BatchLength];
            int* from = stackalloc int[BatchLength];
            int* to = stackalloc int[BatchLength];
            var copy = new ColumnCopy
            {
                From = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(From),
                To = (byte*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(To),
                ColumnsOfSource = ColumnsOfSource,
                ColumnsOfTarget = ColumnsOfTarget,
            };
            var table = (ulong*)Table.GetUnsafePtr();
            int end = math.min(End, Result.Value.Points);
            MarkChosen(copy.From, table, end, x, y, z);
            int keptOfAll = Kept.Value;
            for (int first = First; first < end; first += BatchLength)
            {
                int length = math.min(end - first, BatchLength);
                Positions.Load(copy.From, first, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                int kept = 0;
                for (int i = 0; i < length; i++)
                {
                    if (!PositionBounds.IsFinite(x[i], y[i], z[i]) || !Cells.Mark(table, x[i], y[i], z[i])
                        || keptOfAll == Capacity)
                        continue;
                    from[kept] = first + i;
                    to[kept++] = keptOfAll++;
                }
                copy.Scatter(from, to, kept);
            }
            Kept.Value = keptOfAll;
        }

        unsafe void MarkChosen(byte* block, ulong* table, int endOfRange, double* x, double* y, double* z)
        {
            long begin = RangeFirstPoint + First;
            long end = math.min(RangeFirstPoint + endOfRange, Strata.Points);
            if (Strata.Count == 0 || end <= begin)
                return;
            int last = Strata.StratumOf(end - 1);
            for (int stratum = Strata.StratumOf(begin); stratum <= last; stratum++)
            {
                long point = Strata.Chosen(stratum);
                if (point < begin || point >= end)
                    continue;
                Positions.Load(block, (int)(point - RangeFirstPoint), 1, x, y, z);
                Transform.ToGeo(1, x, y, z);
                if (PositionBounds.IsFinite(*x, *y, *z))
                    Cells.Mark(table, *x, *y, *z);
            }
        }
    }

    [BurstCompile]
    struct MarkCellsJob : IJob
    {
        const int BatchLength = ColumnValues.BatchLength;

        [ReadOnly] public NativeArray<byte> Sample;
        [ReadOnly] public NativeArray<byte> Filled;
        public PositionColumns Positions;
        public PositionTransform Transform;

        public int First;
        public int End;

        public CellHashing Cells;
        public NativeArray<ulong> Table; // Cleared before the first entry.

        public unsafe void Execute()
        {
            double* x = stackalloc double[BatchLength];
            double* y = stackalloc double[BatchLength];
            double* z = stackalloc double[BatchLength];
            var table = (ulong*)Table.GetUnsafePtr();
            if (First == 0)
                UnsafeUtility.MemClear(table, Table.Length * sizeof(ulong));
            byte* sample = (byte*)Sample.GetUnsafeReadOnlyPtr();
            for (int first = First; first < End; first += BatchLength)
            {
                int length = math.min(End - first, BatchLength);
                Positions.Load(sample, first, length, x, y, z);
                Transform.ToGeo(length, x, y, z);
                for (int i = 0; i < length; i++)
                    if (Filled[first + i] != 0 && PositionBounds.IsFinite(x[i], y[i], z[i]))
                        Cells.Mark(table, x[i], y[i], z[i]);
            }
        }
    }
}
