using System;
using Unity.Collections;

namespace FastPoints.Records
{
    /// <summary>The progress of an <see cref="OrderChunkJob"/> between two slices, and its working memory.</summary>
    internal struct OrderScratch : IDisposable
    {
        /// <summary>What the next slice continues.</summary>
        public enum Stage
        {
            Start,
            MakeKeys,
            Distribute,
            Sort,
            Done,
        }

        /// <summary>The progress of the job.</summary>
        public struct State
        {
            public Stage Stage;

            /// <summary>The next page or bucket, and the first record of that page.</summary>
            public int At;
            public int Record;
        }

        public NativeReference<State> Now;

        /// <summary>Keys of the records, first as they came, then sorted.</summary>
        public NativeArray<ulong> Keys;
        public NativeArray<ulong> Sorted;

        /// <summary>Address of each page.</summary>
        public NativeList<ulong> PageTable;

        /// <summary>First record of each bucket of the first digit, with one more entry.</summary>
        public NativeArray<int> FirstOfBucket;

        /// <param name="records">Number of records in the largest chunk.</param>
        public OrderScratch(int records, Allocator allocator)
        {
            Now = new NativeReference<State>(allocator);
            Keys = new NativeArray<ulong>(records, allocator, NativeArrayOptions.UninitializedMemory);
            Sorted = new NativeArray<ulong>(records, allocator, NativeArrayOptions.UninitializedMemory);
            PageTable = new NativeList<ulong>(64, allocator);
            FirstOfBucket = new NativeArray<int>(OrderChunkJob.Buckets + 1, allocator);
        }

        public bool IsCreated => Now.IsCreated;

        public bool IsDone => Now.Value.Stage == Stage.Done;

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
