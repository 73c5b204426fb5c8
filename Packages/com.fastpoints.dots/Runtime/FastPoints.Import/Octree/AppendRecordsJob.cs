using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octree
{
    /// <summary>
    /// Copies one batch's grouped records to their chunks. These jobs run one after another, in the order of the source: they are
    /// mere copies, and so neither locks nor the order of completion matter.
    /// </summary>
    [BurstCompile]
    public unsafe struct AppendRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> FirstOfChunk;
        public int StrideBytes;
        public NativeArray<RecordPages> Chunks;

        public void Execute()
        {
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            var chunks = (RecordPages*)Chunks.GetUnsafePtr();
            for (int c = 0; c < Chunks.Length; c++)
            {
                int first = FirstOfChunk[c], count = FirstOfChunk[c + 1] - first;
                if (count > 0)
                    chunks[c].Append(records + (long)first * StrideBytes, count, StrideBytes);
            }
        }
    }
}
