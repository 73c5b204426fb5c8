using System;
using Unity.Collections;

namespace FastPoints.Samplers
{
    /// <summary>Where a Poisson sampler stands between two slices, and the memory it works in. Used again for the next
    /// chunk.</summary>
    internal struct PoissonScratch : IDisposable
    {
        /// <summary>Where the sampler stands.</summary>
        public struct State
        {
            public SamplePoissonJob.Stage Stage;

            /// <summary>The range in work, or -1; the first point of the tile in work, and its end where the first of its darts
            /// are thrown; while a range is split, the first point of the next part, while it is averaged, the next point; while
            /// the grid is filled, the next sample.</summary>
            public int At;
            public int Point;
            public int EndOfTile;

            public RangeSurveyState Looking;

            /// <summary>How many of the darts are thrown, and whether the tile has others.</summary>
            public int Dart;
            public bool IsLastOfTile;

            /// <summary>Edge of the cells of the ranges in work.</summary>
            public int CellLog2;

            /// <summary>The first sample of those ranges.</summary>
            public int FirstSample;

            /// <summary>The first of those ranges, and the average of their first sample.</summary>
            public int FirstRange;
            public int FirstAverage;
        }

        public NativeReference<State> Now;
        public RangeQueue Ranges;
        public NativeList<PoissonSample> Samples;

        /// <summary>By slot of the hash grid: the sample that came last, or -1.</summary>
        public NativeList<int> Heads;

        /// <summary>Points of the tile in work that nothing is known to keep off, along the curve.</summary>
        public NativeList<int> Waiting;

        /// <summary>The same, in the order in which they are tried.</summary>
        public NativeList<int> Darts;

        /// <summary>Where no point of the tile in work can be taken: see <see cref="PoissonCover"/>.</summary>
        public NativeArray<ulong> Covered;

        /// <summary>By run of a few points on the curve: the sample that kept off the last one of them, or -1.</summary>
        public NativeList<int> KeeperOfRun;

        public PoissonScratch(Allocator allocator)
        {
            Now = new NativeReference<State>(allocator);
            Ranges = new RangeQueue(allocator);
            Samples = new NativeList<PoissonSample>(64, allocator);
            Heads = new NativeList<int>(64, allocator);
            Waiting = new NativeList<int>(64, allocator);
            Darts = new NativeList<int>(64, allocator);
            Covered = new NativeArray<ulong>(PoissonCover.Words, allocator);
            KeeperOfRun = new NativeList<int>(64, allocator);
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
            Waiting.Dispose();
            Darts.Dispose();
            Covered.Dispose();
            KeeperOfRun.Dispose();
        }
    }
}
