using System;
using Unity.Collections;

namespace FastPoints.Samplers
{
    /// <summary>The progress of a Poisson sampler between two slices, and its working memory, which is reused for the next
    /// chunk.</summary>
    internal struct PoissonScratch : IDisposable
    {
        /// <summary>The progress of the sampler.</summary>
        public struct State
        {
            public SamplePoissonJob.Stage Stage;

            /// <summary>The current range, or -1; the first point of the current tile, and its end once its first darts are
            /// thrown; while a range is split, the first point of the next part; while it is averaged, the next point; while the
            /// grid is filled, the next sample.</summary>
            public int At;
            public int Point;
            public int EndOfTile;

            public RangeSurveyState Looking;

            /// <summary>How many darts were thrown, and whether the tile has others.</summary>
            public int Dart;
            public bool IsLastOfTile;

            /// <summary>Edge of the cells of the current ranges.</summary>
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

        /// <summary>For each slot of the hash grid, the sample that came last, or -1.</summary>
        public NativeList<int> Heads;

        /// <summary>Points of the current tile that no known sample keeps off, along the curve.</summary>
        public NativeList<int> Waiting;

        /// <summary>The same, in the order in which they are tried.</summary>
        public NativeList<int> Darts;

        /// <summary>Where no point of the current tile can be taken: see <see cref="PoissonCover"/>.</summary>
        public NativeArray<ulong> Covered;

        /// <summary>For each run of a few points on the curve, the sample that kept off the last one of them, or -1.</summary>
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
