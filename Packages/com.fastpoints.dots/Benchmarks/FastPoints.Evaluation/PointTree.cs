using System;
using System.Collections.Generic;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>A k-d tree (Bentley 1975) over the finite positions of a batch, to find the nearest of them: median splits of the
    /// longest edge, so that node i of level l holds places i * n / 2^l to (i + 1) * n / 2^l and no child needs a pointer; a
    /// tight box for each node. 24 bytes a point and about 12 for the nodes, in native memory.</summary>
    /// <remarks>A tool of measurements: the first splits of a large sample take longer than a frame should wait (about 10 ms a
    /// million points).</remarks>
    public sealed class PointTree : IDisposable
    {
        const int PointsPerLeaf = 8;
        const int PointsPerSlice = 1 << 17;

        NativeArray<double3> m_points;
        NativeArray<PointTreeNode> m_nodes;
        public int Count { get; private set; }
        public int Levels { get; private set; }
        public NativeArray<double3> Points => m_points;

        /// <summary>The root at 1, the children of i at 2i and 2i + 1.</summary>
        public NativeArray<PointTreeNode> Nodes => m_nodes;

        public IEnumerator<JobStep> Build(PointBatch batch, int count, PositionTransform transform)
        {
            m_points = new NativeArray<double3>(Math.Max(1, count), Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            JobHandle built = default;
            using (var loaded = new NativeReference<int>(Allocator.Persistent))
            {
                try
                {
                    for (int first = 0; first < count; first += PointsPerSlice)
                    {
                        built = new LoadPositionsJob
                        {
                            Bytes = batch.Bytes,
                            Positions = PositionColumns.Of(batch),
                            Transform = transform,
                            First = first,
                            Count = Math.Min(PointsPerSlice, count - first),
                            Points = m_points,
                            Loaded = loaded,
                        }.Schedule(built);
                    }
                    yield return built;
                }
                finally
                {
                    built.Complete();
                }
                Count = loaded.Value;
            }
            while (Count >> Levels > PointsPerLeaf)
                Levels++;
            m_nodes = new NativeArray<PointTreeNode>(2 << Levels, Allocator.Persistent);
            try
            {
                for (int level = 0; level <= Levels && Count > 0; level++)
                    built = new SplitPointsJob
                    {
                        Level = level,
                        IsLeaf = level == Levels,
                        Count = Count,
                        Points = m_points,
                        Nodes = m_nodes,
                    }.ScheduleParallel(1 << level, Math.Max(1, (1 << level) / 256), built);
                yield return built;
            }
            finally
            {
                built.Complete();
            }
        }

        /// <param name="unit">What distances are divided by; 0 stands for 1.</param>
        public IEnumerator<JobStep> Measure(NativeArray<double3> positions, int count, double unit, Action<DistanceError> take)
        {
            JobHandle measured = default;
            var distancesSq = new NativeArray<double>(Math.Max(1, count), Allocator.Persistent);
            var found = new NativeReference<DistanceError>(Allocator.Persistent);
            try
            {
                measured = new NearestDistancesJob
                {
                    Queries = positions,
                    QueryCount = count,
                    Points = m_points,
                    Nodes = m_nodes,
                    Count = Count,
                    Levels = Levels,
                    DistancesSq = distancesSq,
                }.ScheduleParallel(NearestDistancesJob.PieceCount(count), 1, default);
                measured = new RankDistancesJob { DistancesSq = distancesSq, Count = count, Unit = unit, Error = found }
                    .Schedule(measured);
                yield return measured;
                measured.Complete();
                take(found.Value);
            }
            finally
            {
                measured.Complete();
                distancesSq.Dispose();
                found.Dispose();
            }
        }

        public void Dispose()
        {
            if (m_points.IsCreated)
                m_points.Dispose();
            if (m_nodes.IsCreated)
                m_nodes.Dispose();
        }

        /// <summary>The square of the distance to the nearest point; infinite if there is none.</summary>
        internal static unsafe double NearestSq(double3* points, PointTreeNode* nodes, int count, int levels, double3 query)
        {
            double nearestSq = double.PositiveInfinity;
            if (count == 0)
                return nearestSq;
            // Each level leaves one node behind.
            int* waiting = stackalloc int[32];
            double* distanceSqOfWaiting = stackalloc double[32];
            int depth = 1;
            waiting[0] = 1;
            distanceSqOfWaiting[0] = nodes[1].DistanceSq(query);
            while (depth > 0)
            {
                depth--;
                if (distanceSqOfWaiting[depth] >= nearestSq)
                    continue;
                int node = waiting[depth];
                int level = 31 - math.lzcnt((uint)node);
                if (level == levels)
                {
                    long end = FirstOf(node + 1 - (1 << level), level, count);
                    for (long i = FirstOf(node - (1 << level), level, count); i < end; i++)
                        nearestSq = math.min(nearestSq, math.distancesq(points[i], query));
                    continue;
                }
                int near = 2 * node, far = near + 1;
                double nearSq = nodes[near].DistanceSq(query), farSq = nodes[far].DistanceSq(query);
                if (farSq < nearSq)
                {
                    (near, far) = (far, near);
                    (nearSq, farSq) = (farSq, nearSq);
                }
                waiting[depth] = far;
                distanceSqOfWaiting[depth++] = farSq;
                waiting[depth] = near;
                distanceSqOfWaiting[depth++] = nearSq;
            }
            return nearestSq;
        }

        internal static long FirstOf(int index, int level, int count) => (long)index * count >> level;
    }

    public struct PointTreeNode
    {
        public double3 Min;
        public double3 Max;

        /// <summary>0 within the box.</summary>
        public readonly double DistanceSq(double3 point)
        {
            var outside = math.max(math.max(Min - point, point - Max), new double3(0, 0, 0));
            return math.dot(outside, outside);
        }
    }

    [BurstCompile]
    public struct SplitPointsJob : IJobFor
    {
        public int Level;
        public bool IsLeaf;
        public int Count;

        [NativeDisableContainerSafetyRestriction] public NativeArray<double3> Points;
        [NativeDisableContainerSafetyRestriction] public NativeArray<PointTreeNode> Nodes;

        public unsafe void Execute(int index)
        {
            var points = (double3*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Points);
            int first = (int)PointTree.FirstOf(index, Level, Count), end = (int)PointTree.FirstOf(index + 1, Level, Count);
            var node = new PointTreeNode { Min = points[first], Max = points[first] };
            for (int i = first + 1; i < end; i++)
            {
                node.Min = math.min(node.Min, points[i]);
                node.Max = math.max(node.Max, points[i]);
            }
            ((PointTreeNode*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(Nodes))[(1 << Level) + index] = node;
            if (IsLeaf)
                return;
            var size = node.Max - node.Min;
            int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
            Select(points, axis, first, end - 1, (int)PointTree.FirstOf(2 * index + 1, Level + 1, Count));
        }

        static unsafe void Select(double3* points, int axis, int first, int last, int index)
        {
            uint hash = (uint)(first * 747796405 + last);
            while (first < last)
            {
                hash = hash * 1664525 + 1013904223;
                double pivot = At(points, axis, first + (int)((hash >> 8) % (uint)(last - first + 1)));
                int low = first, high = last;
                while (low <= high)
                {
                    while (At(points, axis, low) < pivot)
                        low++;
                    while (At(points, axis, high) > pivot)
                        high--;
                    if (low > high)
                        break;
                    var swap = points[low];
                    points[low++] = points[high];
                    points[high--] = swap;
                }
                if (index <= high)
                    last = high;
                else if (index >= low)
                    first = low;
                else
                    return;
            }
        }

        static unsafe double At(double3* points, int axis, int index) => ((double*)(points + index))[axis];
    }
}
