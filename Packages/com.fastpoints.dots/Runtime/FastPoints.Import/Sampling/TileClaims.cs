using System;
using System.Collections.Generic;
using FastPoints.Reading;
using Unity.Collections;
using Unity.Mathematics;

namespace FastPoints.Sampling
{
    /// <summary>Where the points of many tiles are by their headers: of a country's tiles a sample sees few.</summary>
    internal static class TileClaims
    {
        /// <summary>48 MB of positions, for all tiles together.</summary>
        const int MaxPoints = 1 << 21;

        const int MaxPointsOfTile = 64;

        // Steps of an additive recurrence that fills a box evenly (Roberts, "The unreasonable effectiveness of quasirandom
        // sequences", 2018).
        static readonly double3 s_steps = new double3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);

        /// <summary>Gives each sampled range the points of its own tile alone, and adds a range for each tile without one:
        /// positions spread over the tile's bounds.</summary>
        /// <param name="sampled">What was sampled, ascending.</param>
        /// <param name="stored">Positions as the file stores them.</param>
        /// <param name="ranges">One for each that was sampled.</param>
        public static void Add(TiledReader tiles, List<BlockRange> sampled, NativeList<double3> stored,
            NativeList<SampleRange> ranges)
        {
            int perTile = math.clamp(MaxPoints / tiles.TileCount, 1, MaxPointsOfTile);
            using var known = new NativeArray<SampleRange>(ranges.AsArray(), Allocator.Persistent);
            ranges.Clear();
            int next = 0;
            // Of tiles whose headers say nothing.
            long carried = 0;
            for (int t = 0; t < tiles.TileCount; t++)
            {
                long points = tiles.TileOf(t).Points;
                var (first, count) = tiles.BlocksOf(t);
                int end = next;
                while (end < sampled.Count && sampled[end].Block < first + count)
                    end++;
                if (end > next)
                {
                    double ofRange = (points + carried) / (double)(end - next);
                    carried = 0;
                    for (; next < end; next++)
                        ranges.Add(Of(known[next].First, known[next].Count, ofRange));
                }
                else if (points > 0 && !tiles.BoundsOf(t).IsEmpty)
                {
                    ranges.Add(Of(stored.Length, perTile, points));
                    AddPositions(tiles.BoundsOf(t), tiles.Info.Transform, perTile, stored);
                }
                else
                {
                    carried += points;
                }
            }
        }

        static SampleRange Of(int first, int count, double points) =>
            new SampleRange { First = first, Count = count, Weight = points / Math.Max(1, count) };

        static void AddPositions(BoundsGeo bounds, PositionTransform transform, int count, NativeList<double3> stored)
        {
            for (int i = 0; i < count; i++)
            {
                var at = (i + 0.5) * s_steps;
                var geo = bounds.Min + bounds.Size * (at - math.floor(at));
                stored.Add(math.round((geo - transform.Offset) / transform.Scale));
            }
        }
    }
}
