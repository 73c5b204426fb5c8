using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Lists which points of a sample that is still being collected belong to which block, with places counted among the
    /// existing points. Each call continues where the one before ended.</summary>
    [BurstCompile]
    struct ListBlockRunsJob : IJob
    {
        [ReadOnly] public NativeArray<byte> Filled;
        public SampleStrata Strata;

        /// <summary>Index in the whole source of the first points of consecutive blocks, and one more: their end.</summary>
        [ReadOnly] public NativeArray<long> FirstPointOfBlock;

        public int Blocks;

        /// <summary>Number of places to examine in one call.</summary>
        public int MaxPlaces;

        /// <summary>Number of points that each existing one stands for.</summary>
        public double Weight;

        public NativeReference<BlockRunState> State;
        public NativeList<SampleRun> Runs;

        public void Execute()
        {
            var state = State.Value;
            int end = math.min(Strata.Count, state.Place + MaxPlaces);
            while (state.Block < Blocks && state.Place < end)
            {
                long endOfBlock = FirstPointOfBlock[state.Block + 1];
                for (; state.Place < end && Strata.Chosen(state.Place) < endOfBlock; state.Place++)
                    state.Gathered += Filled[state.Place];
                if (state.Place == end && end < Strata.Count)
                    break;
                if (state.Gathered > state.Before)
                    Runs.Add(new SampleRun
                    {
                        Segment = Runs.Length,
                        First = state.Before,
                        Count = state.Gathered - state.Before,
                        Weight = Weight,
                    });
                state.Before = state.Gathered;
                state.Block++;
            }
            State.Value = state;
        }
    }

    /// <summary>The progress of <see cref="ListBlockRunsJob"/>.</summary>
    struct BlockRunState
    {
        /// <summary>Index among the blocks that the job knows.</summary>
        public int Block;

        public int Place;

        /// <summary>Number of points at earlier places.</summary>
        public int Gathered;

        /// <summary>Those among them that belong to earlier blocks.</summary>
        public int Before;
    }
}
