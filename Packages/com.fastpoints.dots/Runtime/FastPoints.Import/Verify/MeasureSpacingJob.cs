using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Verify
{
    /// <summary>Finds the smallest distance between points of a level that were sampled together, across nodes of one file; and
    /// the points at the sides of the file's cube, which other files' points may be close to.</summary>
    [BurstCompile]
    internal unsafe struct MeasureSpacingJob : IJob
    {
        /// <summary>The groups of points, one after the other, level by level.</summary>
        public NativeArray<SampledGroup> Runs;

        /// <summary>In CRS units, from the cloud's corner.</summary>
        [ReadOnly] public NativeArray<double3> Points;

        /// <summary>The file's cube, in the points' space.</summary>
        public double3 CubeMin;
        public double3 CubeMax;

        /// <summary>Whether all points are wanted, not only those at the sides.</summary>
        public bool IsWhole;

        /// <summary>Has room for <see cref="Points"/>: receives those at the sides, level by level.</summary>
        public NativeArray<double3> AtSides;

        /// <summary>Out: for each group, its number of points at the sides.</summary>
        public NativeArray<int> AtSidesOfRun;

        public void Execute()
        {
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            int atSides = 0;
            for (int r = 0; r < Runs.Length; r++)
            {
                var run = Runs[r];
                run.MinDistance = ClosestPair.Distance(points + run.First, run.Count);
                Runs[r] = run;
                int before = atSides;
                for (int i = run.First; i < run.First + run.Count; i++)
                {
                    double toSide = math.cmin(math.min(points[i] - CubeMin, CubeMax - points[i]));
                    if (IsWhole || toSide < run.Spacing)
                        AtSides[atSides++] = points[i];
                }
                AtSidesOfRun[r] = atSides - before;
            }
        }
    }

    /// <summary>The range of a file's points of one level that were sampled together, among all its sampled points.
    /// Blittable.</summary>
    internal struct SampledGroup
    {
        public int First;
        public int Count;

        /// <summary>The level, counted from the root.</summary>
        public int Level;

        /// <summary>Points nearer than this to the file's cube's sides may have neighbours beyond them; CRS units.</summary>
        public double Spacing;

        /// <summary>Whether they are what upper levels left of other nodes' tops, which were not sampled together.</summary>
        public bool IsTop;

        /// <summary>Out: the smallest distance between two of the points, in CRS units.</summary>
        public double MinDistance;
    }
}
