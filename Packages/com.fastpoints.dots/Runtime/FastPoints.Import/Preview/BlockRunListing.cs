using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Files;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Preview
{
    /// <summary>Finds out which of a sample's points are of which block, while the sample is still collected.</summary>
    static class BlockRunListing
    {
        /// <summary>Blocks whose first points are asked for at a time: of millions that would take long, and memory.</summary>
        const int BlocksAtOnce = 1 << 14;

        /// <summary>Work for a pump.</summary>
        /// <param name="filled">1 at each place of <paramref name="strata"/> whose point is there.</param>
        /// <param name="points">That are there.</param>
        /// <param name="runs">Gets them, by place among the points that are there.</param>
        public static IEnumerator<Work> List(PointReader reader, SampleStrata strata, NativeArray<byte> filled, int points,
            NativeList<SampleRun> runs)
        {
            int blocks = reader.BlockCount;
            runs.Clear();
            runs.Capacity = Math.Max(runs.Capacity, Math.Min(blocks, points));
            var firsts = new NativeArray<long>(Math.Min(blocks, BlocksAtOnce) + 1, Allocator.Persistent);
            var state = new NativeReference<BlockRunState>(Allocator.Persistent);
            JobHandle listed = default;
            try
            {
                for (int first = 0; first < blocks && state.Value.Place < strata.Count; first += BlocksAtOnce)
                {
                    int count = Math.Min(BlocksAtOnce, blocks - first);
                    for (int i = 0; i < count; i++)
                        firsts[i] = reader.FirstPointOfBlock(first + i);
                    firsts[count] = first + count < blocks ? reader.FirstPointOfBlock(first + count) : reader.PointCount;
                    var at = state.Value;
                    at.Block = 0;
                    state.Value = at;
                    while (state.Value.Block < count && state.Value.Place < strata.Count)
                    {
                        listed = new ListBlockRunsJob
                        {
                            Filled = filled,
                            Strata = strata,
                            FirstPointOfBlock = firsts,
                            Blocks = count,
                            MostPlaces = SampleBuffer.PlacesPerSlice,
                            Weight = reader.PointCount / (double)Math.Max(1, points),
                            State = state,
                            Runs = runs,
                        }.Schedule();
                        yield return listed;
                        listed.Complete();
                    }
                }
            }
            finally
            {
                listed.Complete();
                firsts.Dispose();
                state.Dispose();
            }
        }
    }

    /// <summary>How far <see cref="ListBlockRunsJob"/> has come.</summary>
    struct BlockRunState
    {
        /// <summary>Of those that the job knows.</summary>
        public int Block;

        public int Place;

        /// <summary>Points at the places before.</summary>
        public int Gathered;

        /// <summary>Of these, those of blocks before.</summary>
        public int Before;
    }
}
