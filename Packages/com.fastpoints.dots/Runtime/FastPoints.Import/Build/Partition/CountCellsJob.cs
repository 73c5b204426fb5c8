using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Counts a chunk's records in each cell: exactly, where the first partition had only a sample.</summary>
    [BurstCompile]
    internal unsafe struct CountCellsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;
        public CellFinder Cells;

        /// <summary>Indexed by Morton number of the cell; starts at zero. All records lie inside.</summary>
        public NativeArray<long> PointsOfCell;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int stride = Layout.StrideBytes;
            for (var page = Pages.First; page != null; page = page->Next)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    var place = Layout.PositionOf(record);
                    PointsOfCell[Cells.CellOf(place.X, place.Y, place.Z)]++;
                }
            }
            Slices.End(begin);
        }
    }
}
