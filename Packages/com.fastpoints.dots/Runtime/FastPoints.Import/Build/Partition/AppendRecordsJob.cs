using FastPoints.Core;
using FastPoints.Nodes;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>Copies one batch's grouped records to their chunks. These jobs run one after another, in the order of the source:
    /// since they only copy, neither locks nor the order of completion matter. If the chunks hold more pages than allowed, the
    /// largest ones give theirs up.</summary>
    [BurstCompile]
    internal unsafe struct AppendRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> FirstOfChunk;
        public NativeArray<RecordPages> Chunks;
        public NativeReference<RecordPagePool> Pool;

        /// <summary>Pages that may be reused.</summary>
        public RecordPages Returned;

        /// <summary>The most pages that the chunks may hold.</summary>
        public long MaxPages;

        /// <summary>Number of pages held elsewhere, on their way to a disk.</summary>
        public NativeReference<long> PagesDetached;

        /// <summary>Out: full pages to be written, each once.</summary>
        public NativeList<DetachedRecordPages> Detached;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            ref var pool = ref RecordPagePool.Of(Pool);
            long detached = PagesDetached.Value - Returned.PageCount;
            pool.Return(ref Returned);
            Detached.Clear();
            for (int c = 0; c < Chunks.Length; c++)
            {
                int first = FirstOfChunk[c], count = FirstOfChunk[c + 1] - first;
                if (count > 0)
                    pool.Append(ref chunks[c], records + (long)first * pool.StrideBytes, count);
            }
            if (pool.PagesInUse - detached > MaxPages)
                detached += Detach(chunks, pool.PagesInUse - detached - MaxPages / 4 * 3);
            PagesDetached.Value = detached;
            Slices.End(begin);
        }

        /// <returns>The number of detached pages.</returns>
        long Detach(RecordPages* chunks, long wanted)
        {
            long done = 0;
            while (done < wanted)
            {
                int largest = 0;
                for (int c = 1; c < Chunks.Length; c++)
                    if (chunks[c].PageCount > chunks[largest].PageCount)
                        largest = c;
                var pages = chunks[largest].CutFull();
                if (pages.PageCount == 0)
                    break;
                done += pages.PageCount;
                Detached.Add(new DetachedRecordPages { Chunk = largest, Pages = pages });
            }
            return done;
        }
    }
}
