using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Distributes the records outside the first cube. The root grew from it by doublings; a record belongs to the first
    /// doubled cube that contains it, and there to one of the seven octants other than the previous cube.</summary>
    [BurstCompile]
    internal unsafe struct RegroupShellsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;

        /// <summary>The doubled cubes, the smallest first.</summary>
        [ReadOnly] public NativeArray<GridCube> Shells;

        /// <summary>Indexed by shell times 8, plus octant.</summary>
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
                    int shell = 0;
                    while (!Shells[shell].Contains(place))
                        shell++;
                    pool.Append(ref chunks[shell * 8 + Shells[shell].OctantOf(place)], record, 1);
                }
                var next = page->Next;
                pool.Return(page);
                page = next;
            }
            Slices.End(begin);
        }
    }
}
