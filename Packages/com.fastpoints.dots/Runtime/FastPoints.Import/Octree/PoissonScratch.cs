using System;
using FastPoints.Points;
using Unity.Collections;

namespace FastPoints.Octree
{
    /// <summary>Where a Poisson sampler stands between two slices, and the memory it works in. Used again for the next
    /// chunk.</summary>
    public struct PoissonScratch : IDisposable
    {
        /// <summary>Where the sampler stands.</summary>
        public struct State
        {
            public SamplePoissonJob.Stage Stage;

            /// <summary>How far the stage is: a range, or a dart.</summary>
            public int At;

            /// <summary>Edge of the cells of the ranges in work.</summary>
            public int CellLog2;

            /// <summary>The first sample of those ranges.</summary>
            public int FirstSample;

            /// <summary>The first of those ranges, and the average of their first sample.</summary>
            public int FirstRange;
            public int FirstAverage;
        }

        public NativeReference<State> Now;
        public NativeList<SampledRange> Ranges;
        public NativeList<PoissonSample> Samples;

        /// <summary>By slot of the hash grid: the sample that came last, or -1.</summary>
        public NativeList<int> Heads;

        /// <summary>Points to try at the spacing in work, the highest priority first.</summary>
        public NativeList<PoissonDart> Darts;

        /// <summary>By run of a few points on the curve: the sample that kept off the last one of them, or -1.</summary>
        public NativeList<int> KeeperOfRun;

        /// <summary>By cell size and class of priority: points that wait; then where the next one's dart goes.</summary>
        public NativeArray<int> PointsOfClass;

        /// <summary>By cell size: first and last range that waits to be sampled, or -1.</summary>
        public NativeArray<int> FirstRange;
        public NativeArray<int> LastRange;

        public PoissonScratch(Allocator allocator)
        {
            Now = new NativeReference<State>(allocator);
            Ranges = new NativeList<SampledRange>(64, allocator);
            Samples = new NativeList<PoissonSample>(64, allocator);
            Heads = new NativeList<int>(64, allocator);
            Darts = new NativeList<PoissonDart>(64, allocator);
            KeeperOfRun = new NativeList<int>(64, allocator);
            PointsOfClass = new NativeArray<int>((GridCube.MaxSideLog2 + 1) * PoissonPriority.Classes, allocator);
            FirstRange = new NativeArray<int>(GridCube.MaxSideLog2 + 1, allocator);
            LastRange = new NativeArray<int>(GridCube.MaxSideLog2 + 1, allocator);
        }

        public bool IsDone => Now.Value.Stage == SamplePoissonJob.Stage.Done;

        public void Dispose()
        {
            if (!Now.IsCreated)
                return;
            Now.Dispose();
            Ranges.Dispose();
            Samples.Dispose();
            Heads.Dispose();
            Darts.Dispose();
            KeeperOfRun.Dispose();
            PointsOfClass.Dispose();
            FirstRange.Dispose();
            LastRange.Dispose();
        }
    }
}
