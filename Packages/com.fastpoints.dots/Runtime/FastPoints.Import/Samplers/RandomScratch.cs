using System;
using Unity.Collections;

namespace FastPoints.Samplers
{
    /// <summary>The progress of a <see cref="SampleRandomJob"/> between two slices, and its working memory.</summary>
    internal struct RandomScratch : IDisposable
    {
        /// <summary>The progress of the sampler.</summary>
        public struct State
        {
            public SampleRandomJob.Stage Stage;

            /// <summary>The next point or range.</summary>
            public int At;

            /// <summary>For the current range: the next point, log2 of the side of the largest cube that neighbours have in
            /// common, and the cells of the node above.</summary>
            public int Point;
            public int Largest;
            public byte CellAbove;

            /// <summary>Number of points so far that were not followed by one of a higher priority.</summary>
            public int Rising;
        }

        public NativeReference<State> Now;

        /// <summary>Cubes to sample, the coarse ones first.</summary>
        public NativeList<SampledRange> Ranges;

        /// <summary>For the current range, by log2 of a side: the number of points that give way in cubes of it.</summary>
        public NativeArray<int> GivingWay;

        public RandomScratch(Allocator allocator)
        {
            GivingWay = new NativeArray<int>(256, allocator);
            Now = new NativeReference<State>(allocator);
            Ranges = new NativeList<SampledRange>(64, allocator);
        }

        public bool IsDone => Now.Value.Stage == SampleRandomJob.Stage.Done;

        public void Dispose()
        {
            if (!Now.IsCreated)
                return;
            Now.Dispose();
            GivingWay.Dispose();
            Ranges.Dispose();
        }
    }
}
