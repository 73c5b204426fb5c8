using System;
using Unity.Collections;

namespace FastPoints.Samplers
{
    /// <summary>Where a <see cref="SampleRandomJob"/> stands between two slices, and the memory it works in.</summary>
    internal struct RandomScratch : IDisposable
    {
        /// <summary>Where the sampler stands.</summary>
        public struct State
        {
            public SampleRandomJob.Stage Stage;

            /// <summary>The point, or the range, that is next.</summary>
            public int At;

            /// <summary>Of the range in work: the point that is next, log2 of the side of the largest cube that neighbours have
            /// in common, and the cells of the node above.</summary>
            public int Point;
            public int Largest;
            public byte CellAbove;

            /// <summary>Points so far that none of a higher priority has come after.</summary>
            public int Rising;
        }

        public NativeReference<State> Now;

        /// <summary>Cubes to be sampled, the coarse ones first.</summary>
        public NativeList<SampledRange> Ranges;

        /// <summary>Of the range in work, by log2 of a side: points that have to give way in cubes of it.</summary>
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
