using System;
using System.Collections.Generic;
using FastPoints.Core;
using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Export
{
    /// <summary>Measures how near the sampled points of different chunks are: samplers only keep their distance inside
    /// chunks.</summary>
    static class CrossCheck
    {
        /// <summary>Points of a slice that only compares neighbours or fills a grid, entries of one that clears it, and points of
        /// one that searches it: about 2 ms each.</summary>
        const int PointsPerFill = 1 << 16, EntriesPerClear = 1 << 20, PointsPerSearch = 1 << 12;

        /// <summary>What is searched in one level.</summary>
        sealed class Search : IDisposable
        {
            public NativeList<double3> Points;
            public double Spacing;
            public NativeReference<double> Limit;
            public NativeArray<int> Scratch;
            public NativeArray<NearFound> Found;

            public void Dispose()
            {
                Limit.Dispose();
                Scratch.Dispose();
                Found.Dispose();
            }
        }

        /// <summary>Coroutine: fills in what the levels say of points across chunks.</summary>
        /// <param name="atSides">For each level, the points that may be close to those of other chunks.</param>
        public static IEnumerator<JobStep> Run(List<NativeList<double3>> atSides, List<VerifyResult.Level> levels)
        {
            var searches = new List<Search>();
            var fills = new List<(int Level, NearStep Step, int First, int End)>();
            var finds = new List<(int Level, int First, int End)>();
            try
            {
                for (int level = 0; level < atSides.Count; level++)
                {
                    int count = atSides[level].Length;
                    searches.Add(new Search
                    {
                        Points = atSides[level],
                        Spacing = levels[level].Spacing,
                        Limit = new NativeReference<double>(double.PositiveInfinity, Allocator.Persistent),
                        Scratch = new NativeArray<int>(checked((int)ClosestPair.ScratchOf(count)), Allocator.Persistent,
                            NativeArrayOptions.UninitializedMemory),
                        Found = new NativeArray<NearFound>(SlicesOf(count, PointsPerSearch), Allocator.Persistent),
                    });
                    foreach (var (step, length, perSlice) in new[] { (NearStep.Compare, count, PointsPerFill),
                        (NearStep.Clear, NearestNeighbours.Cells(count), EntriesPerClear),
                        (NearStep.Add, count, PointsPerFill) })
                        for (int slice = 0; slice < SlicesOf(length, perSlice); slice++)
                            fills.Add((level, step, slice * perSlice, Math.Min(length, (slice + 1) * perSlice)));
                    for (int first = 0; first < count; first += PointsPerSearch)
                        finds.Add((level, first, Math.Min(count, first + PointsPerSearch)));
                }
                yield return JobStep.Of(Slices.Run(0, fills.Count, 1, (n, _, after) =>
                    JobFor(searches[fills[n].Level], fills[n].Step, fills[n].First, fills[n].End).Schedule(after)));
                yield return JobStep.Of(Slices.Run(0, finds.Count, 1, (n, _, after) =>
                    JobFor(searches[finds[n].Level], NearStep.Find, finds[n].First, finds[n].End).Schedule(after),
                    Slices.MaxChains));
                for (int level = 0; level < searches.Count; level++)
                    levels[level] = With(levels[level], searches[level]);
            }
            finally
            {
                foreach (var search in searches)
                    search.Dispose();
            }
        }

        static int SlicesOf(int length, int perSlice) => (int)(((long)length + perSlice - 1) / perSlice);

        static CountNearJob JobFor(Search search, NearStep step, int first, int end) => new CountNearJob
        {
            Step = step,
            First = first,
            End = end,
            Points = search.Points,
            Spacing = search.Spacing,
            Limit = search.Limit,
            Scratch = search.Scratch,
            Found = search.Found,
            PointsPerSlice = PointsPerSearch,
        };

        static VerifyResult.Level With(VerifyResult.Level level, Search search)
        {
            double smallest = search.Limit.Value;
            long near = 0;
            for (int i = 0; i < search.Found.Length; i++)
            {
                smallest = Math.Min(smallest, search.Found[i].MinDistance);
                near += search.Found[i].Near;
            }
            level.MinDistanceAcrossChunks = smallest;
            level.NearAcrossChunks = smallest < search.Spacing ? near : 0;
            return level;
        }
    }

    /// <summary>What a slice of <see cref="CountNearJob"/> does.</summary>
    internal enum NearStep
    {
        Compare,
        Clear,
        Add,
        Find,
    }

    /// <summary>What a slice of <see cref="NearStep.Find"/> found. Blittable.</summary>
    internal struct NearFound
    {
        /// <summary>From a point of the slice to any other.</summary>
        public double MinDistance;

        /// <summary>Its points that have another one nearer than the spacing.</summary>
        public int Near;
    }

    /// <summary>A slice of counting the points that have another one nearer than a spacing, and of finding the nearest two.
    /// The cells of the grid are as large as the spacing, or as the closest neighbours in the order of the points if these are
    /// farther apart: the nearest two then are at most as far apart as a cell is large.</summary>
    [BurstCompile]
    internal unsafe struct CountNearJob : IJob
    {
        // Rounding of double coordinates is far below this; a distance that is exactly the spacing is not nearer.
        const double Tolerance = 1e-9;

        public NearStep Step;

        /// <summary>The range of points, or of entries to clear.</summary>
        public int First;
        public int End;

        [ReadOnly] public NativeList<double3> Points;
        public double Spacing;

        /// <summary>The distance of the closest neighbours in the order of the points.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeReference<double> Limit;

        /// <summary>The grid: slices of <see cref="NearStep.Find"/> read it side by side.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<int> Scratch;

        /// <summary>Out, by slice of <see cref="PointsPerSlice"/>.</summary>
        [NativeDisableContainerSafetyRestriction] public NativeArray<NearFound> Found;
        public int PointsPerSlice;

        public void Execute()
        {
            var points = (double3*)Points.GetUnsafeReadOnlyPtr();
            if (Step == NearStep.Compare)
            {
                double closest = Limit.Value;
                for (int i = math.max(1, First); i < End; i++)
                    closest = math.min(closest, math.distance(points[i - 1], points[i]));
                Limit.Value = closest;
                return;
            }
            double limit = math.max(Spacing, Limit.Value);
            if (!(limit > 0) || double.IsInfinity(limit))
            {
                if (Step == NearStep.Find)
                    Found[First / PointsPerSlice] = new NearFound { MinDistance = double.PositiveInfinity };
                return;
            }
            var grid = new NearestNeighbours(points, Points.Length, limit, (int*)Scratch.GetUnsafePtr());
            if (Step == NearStep.Clear)
                grid.Clear(First, End);
            else if (Step == NearStep.Add)
                grid.Add(First, End);
            else
                Found[First / PointsPerSlice] = Find(grid);
        }

        NearFound Find(in NearestNeighbours grid)
        {
            var found = new NearFound { MinDistance = double.PositiveInfinity };
            for (int i = First; i < End; i++)
            {
                double distance = grid.DistanceOf(i);
                found.MinDistance = math.min(found.MinDistance, distance);
                found.Near += distance < Spacing * (1 - Tolerance) ? 1 : 0;
            }
            return found;
        }
    }
}
