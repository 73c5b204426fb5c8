using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Sampling
{
    /// <summary>Finds out which points of a sample belong to which block, while the sample is still being collected.</summary>
    static class BlockRunListing
    {
        /// <summary>Number of blocks whose first points are requested at a time: requesting millions would take long, and
        /// memory.</summary>
        const int BlocksPerSlice = 1 << 14;

        /// <summary>Lists the runs as a coroutine.</summary>
        /// <param name="filled">1 at each place of <paramref name="strata"/> with a point.</param>
        /// <param name="points">The number of these points.</param>
        /// <param name="runs">Receives the runs, with places counted among the points that exist.</param>
        public static IEnumerator<JobStep> List(PointReader reader, SampleStrata strata, NativeArray<byte> filled, int points,
            NativeList<SampleRun> runs)
        {
            int blocks = reader.BlockCount;
            runs.Clear();
            runs.Capacity = Math.Max(runs.Capacity, Math.Min(blocks, points));
            var firsts = new NativeArray<long>(Math.Min(blocks, BlocksPerSlice) + 1, Allocator.Persistent);
            var state = new NativeReference<BlockRunState>(Allocator.Persistent);
            try
            {
                for (int first = 0; first < blocks && state.Value.Place < strata.Count; first += BlocksPerSlice)
                {
                    int count = Math.Min(BlocksPerSlice, blocks - first);
                    for (int i = 0; i < count; i++)
                        firsts[i] = reader.FirstPointOfBlock(first + i);
                    firsts[count] = first + count < blocks ? reader.FirstPointOfBlock(first + count) : reader.PointCount;
                    var at = state.Value;
                    at.Block = 0;
                    state.Value = at;
                    // A slice that has nothing left to do ends at once: these are as many as there can be.
                    yield return JobStep.Of(Slices.Run(at.Place, strata.Count, SampleBuffer.PlacesPerSlice, (_, __, after) =>
                        new ListBlockRunsJob
                        {
                            Filled = filled,
                            Strata = strata,
                            FirstPointOfBlock = firsts,
                            Blocks = count,
                            MaxPlaces = SampleBuffer.PlacesPerSlice,
                            Weight = reader.PointCount / (double)Math.Max(1, points),
                            State = state,
                            Runs = runs,
                        }.Schedule(after)));
                }
            }
            finally
            {
                firsts.Dispose();
                state.Dispose();
            }
        }
    }
}
