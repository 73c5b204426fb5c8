using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
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
            int index = (int)math.ceil(share * Count);
            return math.sqrt(sortedSq[math.clamp(index, 1, Count) - 1]);
        }
    }

    /// <summary>How far a sample is from the full cloud, point to point, both ways, in units of a length that the caller states.
    /// The larger of the two directions counts; from the sample to the cloud it is 0, since a sample is a part of the cloud, so
    /// that these are the distances from points of the full cloud to the nearest one of the sample.</summary>
    /// <remarks>The larger of both directions: Tian, Ochimizu, Feng, Cohen, Vetro, "Geometric distortion metrics for point cloud
    /// compression", 2017 (D1). Ranked: Huttenlocher, Klanderman, Rucklidge, "Comparing images using the Hausdorff distance",
    /// 1993. Infinite for an empty sample.</remarks>
    public struct DistanceError
    {
        public int Queries;
        public double Rms;

        /// <summary>The distance that 95 (99) of 100 points do not exceed: the nearest rank, of place ceil(0.95 n).</summary>
        public double Ranked95;
        public double Ranked99;
    }

    [BurstCompile]
    public struct NearestDistancesJob : IJobFor
    {
        public const int QueriesPerPiece = 512;

        [ReadOnly] public NativeArray<double3> Queries;
        public int QueryCount;
        [ReadOnly] public NativeArray<double3> Points;
        [ReadOnly] public NativeArray<PointTreeNode> Nodes;
        public int Count;
        public int Levels;

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
