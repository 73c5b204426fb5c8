using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Sampling;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Build
{
    /// <summary>The first partition of a cloud, by the density that samples of its sources show.</summary>
    internal static class PartitionPlan
    {
        /// <summary>Pages for each planned chunk: its last one, which is not full, others of it, and those of chunks that no
        /// sample knew of.</summary>
        const int PagesPerChunk = 4;

        /// <summary>Makes the partition as a coroutine.</summary>
        /// <param name="samples">Samples of the sources, in the order of the grid's.</param>
        /// <param name="points">Points of all sources.</param>
        /// <param name="slices">Takes in how long the jobs ran.</param>
        /// <param name="take">Receives the partition, which the caller disposes.</param>
        public static IEnumerator<JobStep> Of(GridCube cube, List<SourceSample> samples, GridChoice grid, long points,
            MemoryPlan plan, SliceTimes slices, Action<PartitionMap> take)
        {
            int sampled = 0;
            foreach (var sample in samples)
                sampled += sample.Stored.Length;
            var codes = new NativeArray<uint>(Math.Max(1, sampled), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var runs = new NativeList<SampleRun>(Allocator.Persistent);
            JobHandle coded = default;
            try
            {
                int first = 0;
                for (int i = 0; i < samples.Count; i++)
                {
                    var stored = samples[i].Stored;
                    for (int begin = 0; begin < stored.Length; begin += CodeSampleJob.PointsOfSlice)
                        coded = new CodeSampleJob
                        {
                            Stored = stored.GetSubArray(begin, Math.Min(CodeSampleJob.PointsOfSlice, stored.Length - begin)),
                            Grid = grid.Sources[i],
                            Cube = cube,
                            CodeOfPoint = codes,
                            First = first + begin,
                            Slices = slices,
                        }.Schedule(coded);
                    foreach (var run in samples[i].Runs)
                        runs.Add(new SampleRun
                        {
                            First = first + run.First,
                            Count = run.Count,
                            Weight = run.Weight,
                        });
                    first += samples[i].Stored.Length;
                }
                double share = Math.Min(1, sampled / (double)Math.Max(1, points));
                yield return JobStep.Of(DensityTree.Count(codes, runs.AsArray(), share, plan.PointsPerChunk, coded,
                    density => take(Partition(cube, density, plan))));
            }
            finally
            {
                coded.Complete();
                codes.Dispose();
                runs.Dispose();
            }
        }

        /// <summary>Plans chunks of their final size if they are so few that each can have its pages, otherwise larger
        /// ones.</summary>
        static PartitionMap Partition(GridCube cube, DensityTree density, MemoryPlan plan)
        {
            using (density)
            {
                long target = plan.PointsPerChunk;
                while (target < plan.PointsPerPartition &&
                    PartitionMap.CountChunks(density, target) > plan.MaxPages / PagesPerChunk)
                    target *= 2;
                return PartitionMap.Plan(cube, density, Math.Min(target, plan.PointsPerPartition));
            }
        }
    }
}
