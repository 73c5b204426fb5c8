using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.SourceFeeds
{
    /// <summary>A slice of a column, from one batch to another.</summary>
    [BurstCompile]
    public unsafe struct CopyColumnJob : IJob
    {
        /// <summary>About 3 ms, where the memory is touched for the first time.</summary>
        public const int BytesOfSlice = 4 << 20;

        [ReadOnly] public NativeArray<byte> From;
        public NativeArray<byte> To;
        public int FirstByteOfFrom;
        public int FirstByteOfTo;

        /// <summary>Bytes.</summary>
        public int Count;

        public void Execute() => UnsafeUtility.MemCpy((byte*)To.GetUnsafePtr() + FirstByteOfTo,
            (byte*)From.GetUnsafeReadOnlyPtr() + FirstByteOfFrom, Count);
    }
}
