using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Sampling;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>The first partition of a cloud, by the density that samples of its sources show.</summary>
    internal static class PartitionPlan
    {
        /// <summary>Pages for each planned chunk: its last one, which is not full, others of it, and those of chunks that no
        /// sample knew of. Larger chunks are all distributed once more, which takes as long as reading a source.</summary>
        const int PagesPerChunk = 2;

        /// <summary>Makes the partition as a coroutine.</summary>
        /// <param name="samples">Samples of the sources, in the order of the grid's.</param>
        /// <param name="take">Receives the partition, which the caller disposes.</param>
        public static IEnumerator<JobStep> Of(GridCube cube, List<SourceSample> samples, GridChoice grid, MemoryPlan plan,
            SliceTimes slices, Action<PartitionMap> take)
        {
            int sampled = 0;
            foreach (var sample in samples)
                sampled += sample.Stored.Length;
            var codes = new NativeArray<uint>(Math.Max(1, sampled), Allocator.Persistent,
                NativeArrayOptions.UninitializedMemory);
            var ranges = new NativeList<SampleRange>(Allocator.Persistent);
            var hash = new NativeReference<ulong>(Allocator.Persistent);
            JobHandle coded = default;
            try
            {
                int first = 0;
                for (int i = 0; i < samples.Count; i++)
                {
                    var stored = samples[i].Stored;
                    for (int begin = 0; begin < stored.Length; begin += CodeSampleJob.PointsPerSlice)
                        coded = new CodeSampleJob
                        {
                            Stored = stored.GetSubArray(begin, Math.Min(CodeSampleJob.PointsPerSlice, stored.Length - begin)),
                            Grid = grid.Sources[i],
                            Cube = cube,
                            CodeOfPoint = codes,
                            First = first + begin,
                            Hash = hash,
                            SliceTimes = slices,
                        }.Schedule(coded);
                    foreach (var range in samples[i].Ranges)
                        ranges.Add(new SampleRange
                        {
                            First = first + range.First,
                            Count = range.Count,
                            Weight = range.Weight,
                        });
                    first += samples[i].Stored.Length;
                }
                double share = Math.Min(1, sampled / (double)Math.Max(1, plan.Points));
                yield return JobStep.Of(DensityTree.Count(codes, ranges.AsArray(), share, plan.PointsPerPlannedCube, coded,
                    density => take(Partition(cube, density, plan, hash.Value))));
            }
            finally
            {
                coded.Complete();
                codes.Dispose();
                hash.Dispose();
                ranges.Dispose();
            }
        }

        /// <summary>Plans cubes smaller than chunks if they are so few that each can have its pages, otherwise larger
        /// ones.</summary>
        static PartitionMap Partition(GridCube cube, DensityTree density, MemoryPlan plan, ulong sampleHash)
        {
            using (density)
            {
                long target = plan.PointsPerPlannedCube;
                while (target < plan.MaxPointsPerPlannedCube &&
                    PartitionMap.CountChunks(density, target) > plan.MaxPages / PagesPerChunk)
                    target += (target + 3) / 4;
                var map = PartitionMap.Plan(cube, density, Math.Min(target, plan.MaxPointsPerPlannedCube));
                map.BaseCells = PartitionMap.BaseCellsOf(cube, density, plan.PointsPerBaseCell, out double[] points);
                map.PointsOfBaseCell = points;
                map.SampleHash = sampleHash;
                return map;
            }
        }
    }

    /// <summary>Finds the Morton codes of the cells of a <see cref="DensityTree"/> that contain a source's sample, and hashes the
    /// sample.</summary>
    [BurstCompile]
    internal unsafe struct CodeSampleJob : IJob
    {
        public const int PointsPerSlice = 1 << 16;

        [ReadOnly] public NativeArray<double3> Stored;
        public SourceToGrid Grid;
        public GridCube Cube;
        public NativeArray<uint> CodeOfPoint; // Codes of all sources' samples; this slice's begin at First.
        public int First;
        public NativeReference<ulong> Hash; // Of all slices until now, in their order.
        public SliceTimes SliceTimes;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Hash.Value = Hash.Value * 31 ^ ContentHash.Of(Stored.GetUnsafeReadOnlyPtr(), (long)Stored.Length * sizeof(double3));
            for (int i = 0; i < Stored.Length; i++)
            {
                long x = SourceToGrid.ToGrid(Grid.X, Stored[i].x);
                long y = SourceToGrid.ToGrid(Grid.Y, Stored[i].y);
                long z = SourceToGrid.ToGrid(Grid.Z, Stored[i].z);
                bool isInside = x != SourceToGrid.InvalidPosition && y != SourceToGrid.InvalidPosition &&
                    z != SourceToGrid.InvalidPosition
                    && Cube.Contains(new Grid3(x, y, z));
                CodeOfPoint[First + i] = isInside
                    ? (uint)Morton.Encode(CellOf(x - Cube.Corner.X), CellOf(y - Cube.Corner.Y), CellOf(z - Cube.Corner.Z))
                    : DensityNumbers.OutsideCode;
            }
            SliceTimes.End(begin);
        }

        /// <summary>The cell of an offset. In a small cube cells are parts of a grid step: its positions are in the first of
        /// them.</summary>
        uint CellOf(long offset)
        {
            int below = Cube.SideLog2 - DensityNumbers.Levels;
            return (uint)(below < 0 ? offset << -below : offset >> below);
        }
    }
}
