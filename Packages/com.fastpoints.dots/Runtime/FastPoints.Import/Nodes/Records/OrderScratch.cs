using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Nodes
{
    /// <summary>The progress of an <see cref="OrderChunkJob"/> between two slices, and its working memory.</summary>
    internal struct OrderScratch : IDisposable
    {
        // Points that most buckets have less than: more memory is given back.
        const int KeptPoints = 1 << 16;

        /// <summary>What the next slice continues.</summary>
        public enum Stage
        {
            Start,
            Touch,
            Count,
            Distribute,
            Keys,
            Sort,
            Emit,
            Done,
        }

        /// <summary>The progress of the job.</summary>
        public unsafe struct State
        {
            public Stage Stage;

            /// <summary>The next page or bucket, and the next record of the chunk or the bucket.</summary>
            [NativeDisableUnsafePtrRestriction] public RecordPages.Page* Page;
            public int Bucket;
            public int Point;

            /// <summary>Bytes of the ordered records that have memory.</summary>
            public long Touched;

            /// <summary>Bits that any of the bucket's keys has, and those that all have.</summary>
            public ulong AnyBits;
            public ulong CommonBits;

            /// <summary>Which half of the keys is sorted.</summary>
            public bool IsSwapped;
        }

        public NativeReference<State> Progress;

        /// <summary>First record of each bucket, with one more entry.</summary>
        public NativeArray<int> FirstOfBucket;

        /// <summary>Keys of the current bucket, twice, and its records.</summary>
        public NativeList<ulong> Keys;
        public NativeList<byte> Bucket;

        public OrderScratch(Allocator allocator)
        {
            Progress = new NativeReference<State>(allocator);
            FirstOfBucket = new NativeArray<int>(OrderChunkJob.MaxBuckets + 1, allocator);
            Keys = new NativeList<ulong>(64, allocator);
            Bucket = new NativeList<byte>(64, allocator);
        }

        public bool IsDone => Progress.Value.Stage == Stage.Done;

        /// <summary>Makes room for a bucket.</summary>
        public void Reserve(int points, int strideBytes)
        {
            if (Keys.Length < 2 * points)
                Keys.ResizeUninitialized(2 * points);
            if (Bucket.Length < points * strideBytes)
                Bucket.ResizeUninitialized(points * strideBytes);
        }

        /// <summary>Gives back what an unusual bucket took, before the chunk takes memory for its nodes.</summary>
        public void Trim()
        {
            if (Keys.Length <= 2 * KeptPoints)
                return;
            Keys.Clear();
            Keys.SetCapacity(64);
            Bucket.Clear();
            Bucket.SetCapacity(64);
        }

        public void Dispose()
        {
            if (!Progress.IsCreated)
                return;
            Progress.Dispose();
            FirstOfBucket.Dispose();
            Keys.Dispose();
            Bucket.Dispose();
        }
    }
}
