using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Distributes one chunk's records over the chunks that it is split into, and returns its pages as they are
    /// done.</summary>
    [BurstCompile]
    internal unsafe struct RegroupRecordsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;
        public CellFinder Cells;
        [ReadOnly] public NativeArray<int> ChunkOfCell;
        public NativeArray<RecordPages> Chunks;
        public NativeReference<RecordPagePool> Pool;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int stride = Layout.StrideBytes;
            ref var pool = ref RecordPagePool.Of(Pool);
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            for (var page = Pages.First; page != null;)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    var place = Layout.PositionOf(record);
                    pool.Append(ref chunks[ChunkOfCell[Cells.CellOf(place.X, place.Y, place.Z)]], record, 1);
                }
                var next = page->Next;
                pool.Return(page);
                page = next;
            }
            Slices.End(begin);
        }
    }
}
