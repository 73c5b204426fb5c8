using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Queries
{
    [BurstCompile]
    internal unsafe struct FindPointsJob : IJobFor
    {
        [ReadOnly] public ResidentPoints Points;
        [ReadOnly] public NativeArray<PointQuery> Queries;
        public int MaxHits;

        // Those of one query after those of another.
        [NativeDisableParallelForRestriction] public NativeArray<PointHit> Hits;
        [WriteOnly] public NativeArray<int> CountOfQuery;

        public void Execute(int index) => CountOfQuery[index] =
            Points.Find(Queries[index], (PointHit*)Hits.GetUnsafePtr() + (long)index * MaxHits, MaxHits);
    }

    [BurstCompile]
    internal struct CountPointsJob : IJobFor
    {
        [ReadOnly] public ResidentPoints Points;
        [ReadOnly] public NativeArray<PointQuery> Queries;
        [WriteOnly] public NativeArray<long> PointsOfQuery;

        public void Execute(int index) => PointsOfQuery[index] = Points.Count(Queries[index]);
    }
}
