using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Files
{
    /// <summary>Notes when what it depends on was done.</summary>
    [BurstCompile]
    struct StampJob : IJob
    {
        /// <summary>By <see cref="ReadClock"/>.</summary>
        public NativeReference<long> At;

        public void Execute() => At.Value = ReadClock.Now;
    }
}
