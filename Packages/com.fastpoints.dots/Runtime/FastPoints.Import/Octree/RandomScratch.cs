using System;
using Unity.Collections;

namespace FastPoints.Octree
{
    /// <summary>Where a <see cref="SampleRandomJob"/> stands between two slices, and the memory it works in.</summary>
    public struct RandomScratch : IDisposable
    {
        /// <summary>Where the sampler stands.</summary>
        public struct State
        {
            public SampleRandomJob.Stage Stage;

            /// <summary>The point, or the range, that is next.</summary>
            public int At;

            /// <summary>Points so far that none of a higher priority has come after.</summary>
            public int Rising;
        }

        public NativeReference<State> Now;

        /// <summary>Cubes to be sampled, the coarse ones first.</summary>
        public NativeList<SampledRange> Ranges;

        public RandomScratch(Allocator allocator)
        {
            Now = new NativeReference<State>(allocator);
            Ranges = new NativeList<SampledRange>(64, allocator);
        }

        public bool IsDone => Now.Value.Stage == SampleRandomJob.Stage.Done;

        public void Dispose()
        {
            if (!Now.IsCreated)
                return;
            Now.Dispose();
            Ranges.Dispose();
        }
    }
}
