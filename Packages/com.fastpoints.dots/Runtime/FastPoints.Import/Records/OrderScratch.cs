using System;
using Unity.Collections;

namespace FastPoints.Records
{
    /// <summary>Where an <see cref="OrderChunkJob"/> stands between two slices, and the memory it works in.</summary>
    internal struct OrderScratch : IDisposable
    {
        /// <summary>Where the job stands.</summary>
        public struct State
        {
            public OrderChunkJob.Stage Stage;

            /// <summary>The page, or the bucket, that is next, and the first record of that page.</summary>
            public int At;
            public int Record;
        }

        public NativeReference<State> Now;

        /// <summary>By record: keys as they came, then as they are sorted.</summary>
        public NativeArray<ulong> Keys;
        public NativeArray<ulong> Sorted;

        /// <summary>By page: its address.</summary>
        public NativeList<ulong> PageTable;

        /// <summary>By bucket of the first digit, and one more: the first record.</summary>
        public NativeArray<int> FirstOfBucket;

        /// <param name="records">Of the largest chunk.</param>
        public OrderScratch(int records, Allocator allocator)
        {
            Now = new NativeReference<State>(allocator);
            Keys = new NativeArray<ulong>(records, allocator, NativeArrayOptions.UninitializedMemory);
            Sorted = new NativeArray<ulong>(records, allocator, NativeArrayOptions.UninitializedMemory);
            PageTable = new NativeList<ulong>(64, allocator);
            FirstOfBucket = new NativeArray<int>(OrderChunkJob.Buckets + 1, allocator);
        }

        public bool IsCreated => Now.IsCreated;

        public bool IsDone => Now.Value.Stage == OrderChunkJob.Stage.Done;

        public void Dispose()
        {
            if (!Now.IsCreated)
                return;
            Now.Dispose();
            Keys.Dispose();
            Sorted.Dispose();
            PageTable.Dispose();
            FirstOfBucket.Dispose();
        }
    }
}
