using FastPoints.Store;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Nodes
{
    /// <summary>Adds up the hashes of a top's points: the checksum of a cloud that has nothing below them.</summary>
    [BurstCompile]
    internal unsafe struct SumTopJob : IJob
    {
        [ReadOnly] public NativeList<byte> Records;

        /// <summary>The layout of tops.</summary>
        public RecordLayout Layout;
        public NativeReference<ulong> Sum;

        public void Execute()
        {
            var records = (byte*)Records.GetUnsafeReadOnlyPtr();
            ulong sum = 0;
            for (int at = 0; at < Records.Length; at += Layout.StrideBytes)
                sum += Layout.HashOf(records + at, RecordHash.ChecksumSeed);
            Sum.Value = sum;
        }
    }
}
