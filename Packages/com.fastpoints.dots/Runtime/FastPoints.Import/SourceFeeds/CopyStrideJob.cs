using FastPoints.Files;
using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.SourceFeeds
{
    /// <summary>Every so manieth point of a batch, to the beginning of another.</summary>
    [BurstCompile]
    public unsafe struct CopyStrideJob : IJob
    {
        [ReadOnly] public NativeArray<byte> From;

        /// <summary>Two for each column: where it is, and where it goes.</summary>
        [ReadOnly] public NativeArray<PointColumn> Columns;
        public NativeArray<byte> To;
        public NativeReference<DecodeResult> Result;
        public int First;
        public int Step;
        public int Count;

        public void Execute()
        {
            for (int c = 0; c < Columns.Length; c += 2)
            {
                int size = Columns[c].Type.SizeOf();
                byte* from = (byte*)From.GetUnsafeReadOnlyPtr() + Columns[c].OffsetBytes + (long)First * size;
                byte* to = (byte*)To.GetUnsafePtr() + Columns[c + 1].OffsetBytes;
                for (int i = 0; i < Count; i++, from += (long)Step * size, to += size)
                    UnsafeUtility.MemCpy(to, from, size);
            }
            Result.Value = new DecodeResult { Points = Count };
        }
    }
}
