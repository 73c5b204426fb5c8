using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Points
{
    /// <summary><see cref="RadixSort.Sort"/> as a job. The arrays have one length.</summary>
    [BurstCompile]
    public struct RadixSortJob : IJob
    {
        public NativeArray<ulong> Keys;
        public NativeArray<uint> Payload;
        public NativeArray<ulong> KeyScratch;
        public NativeArray<uint> PayloadScratch;

        public void Execute() => RadixSort.RunImmediate(Keys, Payload, KeyScratch, PayloadScratch);
    }
}
