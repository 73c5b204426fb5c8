using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    /// <summary>Squares of the distances from some positions to the nearest point of a tree; index i is the i-th piece of
    /// <see cref="QueriesPerPiece"/>.</summary>
    [BurstCompile]
    public struct NearestDistancesJob : IJobFor
    {
        /// <summary>About a millisecond.</summary>
        public const int QueriesPerPiece = 512;

        [ReadOnly] public NativeArray<double3> Queries;
        public int QueryCount;
        [ReadOnly] public NativeArray<double3> Points;
        [ReadOnly] public NativeArray<PointTreeNode> Nodes;
        public int Count;
        public int Levels;

        /// <summary>Pieces write disjoint places.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<double> DistancesSq;

        public static int PieceCount(int queries) => (queries + QueriesPerPiece - 1) / QueriesPerPiece;

        public unsafe void Execute(int index)
        {
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            var nodes = (PointTreeNode*)Nodes.GetUnsafeReadOnlyPtr();
            var distancesSq = (double*)NativeArrayUnsafeUtility.GetUnsafeBufferPointerWithoutChecks(DistancesSq);
            int end = math.min(QueryCount, (index + 1) * QueriesPerPiece);
            for (int i = index * QueriesPerPiece; i < end; i++)
                distancesSq[i] = PointTree.NearestSq(points, nodes, Count, Levels, Queries[i]);
        }
    }
}
