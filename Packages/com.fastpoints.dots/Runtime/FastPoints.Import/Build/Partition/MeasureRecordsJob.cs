using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Finds the bounds of a chunk's records.</summary>
    [BurstCompile]
    internal unsafe struct MeasureRecordsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;

        /// <summary>The smallest and the largest position; they grow.</summary>
        public NativeArray<Grid3> Bounds;

        public SliceTimes Slices;

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
                    var place = Layout.PositionOf(record);
                    min = Grid3.Min(min, place);
                    max = Grid3.Max(max, place);
                }
            }
            Bounds[0] = min;
            Bounds[1] = max;
            Slices.End(begin);
        }
    }
}
