using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Copies records of some pages to the cubes that contain them, and leaves out the others.</summary>
    [BurstCompile]
    internal unsafe struct RegroupCubesJob : IJob
    {
        /// <summary>Pages of one run: a millisecond or so.</summary>
        public const int PagesOfSlice = 8;

        /// <summary>The records, which stay unchanged.</summary>
        public RecordPages Pages;
        public int FirstPage;
        public RecordLayout Layout;

        /// <summary>Cubes of one octree in Morton order, which are equal or do not overlap.</summary>
        [ReadOnly] public NativeArray<GridCube> Cubes;

        /// <summary>The octree's corner.</summary>
        public Grid3 Corner;

        /// <summary>Lists for the cubes; of equal cubes the last one gets the records.</summary>
        public NativeArray<RecordPages> Chunks;
        public NativeReference<RecordPagePool> Pool;

        public void Execute()
        {
            int stride = Layout.StrideBytes;
            ref var pool = ref RecordPagePool.Of(Pool);
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            var page = Pages.First;
            for (int p = 0; p < FirstPage; p++)
                page = page->Next;
            for (int p = 0; p < PagesOfSlice && page != null; p++, page = page->Next)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    var place = Layout.PositionOf(record);
                    int cube = LastFrom(place);
                    if (cube >= 0 && Cubes[cube].Contains(place))
                        pool.Append(ref chunks[cube], record, 1);
                }
            }
        }

        /// <summary>The last cube whose corner does not come after a position; -1 if there is none.</summary>
        int LastFrom(Grid3 place)
        {
            var at = place - Corner;
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
}
