using FastPoints.Records;
using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Verify
{
    /// <summary>Adds up the second hash of grouped records: see <see cref="RecordHash.SecondSeed"/>.</summary>
    [BurstCompile]
    public unsafe struct SumRecordsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Records;
        [ReadOnly] public NativeArray<int> FirstOfChunk;
        public RecordLayout Layout;

        /// <summary>Added to.</summary>
        public NativeReference<ulong> Sum;

        public void Execute()
        {
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            int count = FirstOfChunk[FirstOfChunk.Length - 1];
            ulong sum = Sum.Value;
            for (int i = 0; i < count; i++)
                sum += Layout.HashOf(records + (long)i * Layout.StrideBytes, RecordHash.SecondSeed);
            Sum.Value = sum;
        }
    }
}
