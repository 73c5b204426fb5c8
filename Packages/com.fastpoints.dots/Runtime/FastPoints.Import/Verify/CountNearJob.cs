using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>How many points have another one nearer than a spacing, and how near the nearest two are.</summary>
    [BurstCompile]
    public unsafe struct CountNearJob : IJob
    {
        [ReadOnly] public NativeList<double3> Points;
        public double Spacing;

        /// <summary>Out: the smallest distance; infinity for fewer than two points.</summary>
        public NativeReference<double> MinDistance;

        /// <summary>Out.</summary>
        public NativeReference<long> Near;

        public void Execute()
        {
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            MinDistance.Value = ClosestPair.Distance(points, Points.Length);
            Near.Value = MinDistance.Value < Spacing ? NearestNeighbours.CountWithin(points, Points.Length, Spacing) : 0;
        }
    }
}
