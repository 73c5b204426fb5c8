using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Checks records that came from a disk before anything is computed with them: those outside of their cube are
    /// counted, and put at its corner, so that jobs that are already scheduled behind this one can run on them.</summary>
    [BurstCompile]
    internal unsafe struct CheckRecordsJob : IJob
    {
        const int PagesOfSlice = 64;

        public RecordPages Pages;
        public RecordLayout Layout;
        public GridCube Cube;

        /// <summary>Records outside so far.</summary>
        public NativeReference<int> Outside;

        public SliceTimes Slices;

        /// <summary>Schedules the check of a list. All its pages are there already, and may get their records later.</summary>
        public static JobHandle Schedule(CheckRecordsJob job, JobHandle loaded)
        {
            for (var rest = job.Pages; rest.PageCount > 0; rest.PageCount -= PagesOfSlice)
            {
                job.Pages = rest;
                job.Pages.PageCount = System.Math.Min(PagesOfSlice, rest.PageCount);
                loaded = job.Schedule(loaded);
                for (int i = 0; i < job.Pages.PageCount; i++)
                    rest.First = rest.First->Next;
            }
            return loaded;
        }

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            int outside = 0, stride = Layout.StrideBytes;
            var page = Pages.First;
            for (int p = 0; p < Pages.PageCount; p++, page = page->Next)
            {
                byte* record = RecordPages.RecordsOf(page);
                for (int i = 0; i < page->Count; i++, record += stride)
                {
                    if (Cube.Contains(Layout.PositionOf(record)))
                        continue;
                    Layout.SetPosition(record, Cube.Corner.X, Cube.Corner.Y, Cube.Corner.Z);
                    outside++;
                }
            }
            Outside.Value += outside;
            Slices.End(begin);
        }
    }
}
