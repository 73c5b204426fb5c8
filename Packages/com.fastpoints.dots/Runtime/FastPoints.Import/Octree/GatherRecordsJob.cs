using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octree
{
    /// <summary>Puts a chunk's records in order, one after the other, and prepares the sampling:
    /// where cubes end in the order, and each record's priority.</summary>
    [BurstCompile]
    public unsafe struct GatherRecordsJob : IJob
    {
        public RecordPages Pages;
        public RecordLayout Layout;
        public Points.GridCube Cube;
        [ReadOnly] public NativeArray<uint> Order;
        public NativeArray<byte> Records;

        /// <summary>By point: log2 of the side of the smallest cube that has it and the point before; of the first one,
        /// 255.</summary>
        public NativeArray<byte> CommonCubeLog2;

        /// <summary>By point: the upper half of its hash.</summary>
        public NativeArray<uint> Priority;

        /// <summary>Sum of the hashes.</summary>
        public NativeReference<ulong> Checksum;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            var pageTable = (RecordPages.Page**)UnsafeUtility.Malloc((long)Pages.PageCount * sizeof(void*), 16, Allocator.Temp);
            int pageCount = 0;
            for (var page = Pages.First; page != null; page = page->Next)
                pageTable[pageCount++] = page;
            var table = new RecordTable { Pages = pageTable, Layout = Layout, Corner = Cube.Corner };

            int count = (int)Pages.Count;
            int stride = Layout.StrideBytes;
            var order = (uint*)Order.GetUnsafeReadOnlyPtr();
            var records = (byte*)Records.GetUnsafePtr();
            for (int i = 0; i < count; i++)
            {
                var from = (uint*)table.At(order[i]);
                var to = (uint*)(records + (long)i * stride);
                for (int w = 0; w < stride >> 2; w++)
                    to[w] = from[w];
            }
            UnsafeUtility.Free(pageTable, Allocator.Temp);
            Checksum.Value = Sampling.Prepare(records, count, Layout, Cube.Corner, (byte*)CommonCubeLog2.GetUnsafePtr(),
                (uint*)Priority.GetUnsafePtr());
        }
    }
}
