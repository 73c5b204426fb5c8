using FastPoints.Points;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>From squares of distances, in place, to their root mean square and ranks.</summary>
    [BurstCompile]
    public struct RankDistancesJob : IJob
    {
        public NativeArray<double> DistancesSq;
        public int Count;

        /// <summary>What the results are divided by; 0 stands for 1.</summary>
        public double Unit;

        public NativeReference<DistanceError> Error;

        public unsafe void Execute()
        {
            double* distancesSq = (double*)DistancesSq.GetUnsafePtr();
            double sum = 0;
            for (int i = 0; i < Count; i++)
                sum += distancesSq[i];
            // None is negative: the order of their bits is their own.
            var scratch = new NativeArray<ulong>(math.max(1, Count), Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            RadixSort.Sort((ulong*)distancesSq, null, (ulong*)scratch.GetUnsafePtr(), null, Count);
            scratch.Dispose();
            double perUnit = Unit > 0 ? 1 / Unit : 1;
            Error.Value = new DistanceError
            {
                Queries = Count,
                Rms = Count == 0 ? 0 : math.sqrt(sum / Count) * perUnit,
                Ranked95 = Ranked(distancesSq, 0.95) * perUnit,
                Ranked99 = Ranked(distancesSq, 0.99) * perUnit,
            };
        }

        unsafe double Ranked(double* sortedSq, double share)
        {
            if (Count == 0)
                return 0;
            int place = (int)math.ceil(share * Count);
            return math.sqrt(sortedSq[math.clamp(place, 1, Count) - 1]);
        }
    }
}
