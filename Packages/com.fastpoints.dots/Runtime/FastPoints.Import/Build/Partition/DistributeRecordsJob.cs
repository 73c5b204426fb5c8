using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Copies records of some pages to the cubes that contain them, and leaves out the others.</summary>
    [BurstCompile]
    internal unsafe struct DistributeRecordsJob : IJob
    {
        public const int PagesPerSlice = 8; // Pages of one slice, which takes about a millisecond.

        public RecordPages Pages;

        /// <summary>Whether the job takes all pages and returns them to the pool, instead of reading a slice from <see
        /// cref="FirstPage"/> on.</summary>
        public bool TakesPages;
        public int FirstPage;
        public RecordLayout Layout;
        [ReadOnly] public NativeArray<GridCube> Cubes; // Cubes of one octree in Morton order, which are equal or do not overlap.

        public Grid3 Corner;
        public NativeArray<RecordPages> Chunks; // Lists for the cubes; of equal cubes the last one gets the records.
        public NativeReference<RecordPagePool> Pool;
        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int stride = Layout.StrideBytes, cube = -1;
            ref var pool = ref RecordPagePool.Of(Pool);
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            var page = Pages.First;
            for (int p = 0; p < FirstPage; p++)
                page = page->Next;
            for (int p = 0; (p < PagesPerSlice || TakesPages) && page != null; p++)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    var position = Layout.PositionOf(record);
                    // Consecutive points are often neighbours.
                    if (cube < 0 || !Cubes[cube].Contains(position))
                        cube = IndexOfLastCubeUpTo(position);
                    if (cube >= 0 && Cubes[cube].Contains(position))
                        pool.Append(ref chunks[cube], record, 1);
                }
                var next = page->Next;
                if (TakesPages)
                    pool.Return(page);
                page = next;
            }
            SliceTimes.End(begin);
        }

        /// <summary>The last cube whose corner does not come after a position; -1 if there is none.</summary>
        int IndexOfLastCubeUpTo(Grid3 position)
        {
            var at = position - Corner;
            // Morton order is only defined for positions within the octree.
            if (at.X < 0 || at.Y < 0 || at.Z < 0)
                return -1;
            int first = 0, end = Cubes.Length;
            while (first < end)
            {
                int middle = first + (end - first) / 2;
                if (MortonOrder.Compare(Cubes[middle].Corner - Corner, at) <= 0)
                    first = middle + 1;
                else
                    end = middle;
            }
            return first - 1;
        }
    }

    /// <summary>Counts a chunk's records in each cell, exactly, where the first partition had only a sample, and finds their
    /// bounds.</summary>
    [BurstCompile]
    internal unsafe struct CountCellPointsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;
        public CellFinder Cells;
        public NativeArray<long> PointsOfCell; // Indexed by Morton number of the cell; starts at zero. All records lie inside.
        public NativeArray<Grid3> Bounds; // The smallest and the largest position, extended by each job.

        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Grid3 min = Bounds[0], max = Bounds[1];
            int stride = Layout.StrideBytes;
            for (var page = Pages.First; page != null; page = page->Next)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    var position = Layout.PositionOf(record);
                    PointsOfCell[Cells.CellOf(position.X, position.Y, position.Z)]++;
                    min = Grid3.Min(min, position);
                    max = Grid3.Max(max, position);
                }
            }
            Bounds[0] = min;
            Bounds[1] = max;
            SliceTimes.End(begin);
        }
    }
}
