using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Chooses the cube that the first partition divides, before any point beyond the sample was seen.</summary>
    static class FirstCube
    {
        /// <summary>Claims of an extent more than this many times that of the sample are ignored.</summary>
        const double MaxClaimRatio = 4;

        /// <summary>The cube around the sample, and around what the headers claim unless that is far larger: claims may be
        /// anything.</summary>
        /// <param name="found">Statistics of each reader's sample.</param>
        public static GridCube Of(IReadOnlyList<PointReader> readers, IReadOnlyList<SampleStatistics> found, GridChoice grid)
        {
            var min = PointStatistics.None.Min;
            var max = PointStatistics.None.Max;
            for (int i = 0; i < found.Count; i++)
            {
                if (!math.all(found[i].Min <= found[i].Max))
                    continue;
                // A negative scale mirrors the box.
                var a = ToGrid(grid.Sources[i], found[i].Min);
                var b = ToGrid(grid.Sources[i], found[i].Max);
                min = Grid3.Min(min, Grid3.Min(a, b));
                max = Grid3.Max(max, Grid3.Max(a, b));
            }
            if (min.X > max.X)
                return RootCube.Around(default, default);
            const long limit = SourceGrid.Limit - 1;
            min = Grid3.Max(min, new Grid3(-limit, -limit, -limit));
            max = Grid3.Min(max, new Grid3(limit, limit, limit));

            var extent = grid.Grid.Step * math.max(1.0, (double)math.max(max.X - min.X, math.max(max.Y - min.Y, max.Z - min.Z)));
            double sampled = math.cmax(extent);
            foreach (var reader in readers)
            {
                var claim = reader.Info.BoundsClaimed;
                if (!reader.Info.HasBoundsClaimed || claim.IsEmpty || !claim.IsFinite)
                    continue;
                var low = math.round((claim.Min - grid.Grid.Origin) / grid.Grid.Step);
                var high = math.round((claim.Max - grid.Grid.Origin) / grid.Grid.Step);
                if (!math.all(math.abs(low) < limit) || !math.all(math.abs(high) < limit) ||
                    math.cmax(claim.Size) > MaxClaimRatio * sampled)
                    continue;
                var lowGrid = new Grid3((long)low.x, (long)low.y, (long)low.z);
                var highGrid = new Grid3((long)high.x, (long)high.y, (long)high.z);
                var allMin = Grid3.Min(min, lowGrid);
                var allMax = Grid3.Max(max, highGrid);
                var size = (allMax - allMin);
                if (math.cmax(grid.Grid.Step * new double3(size.X, size.Y, size.Z)) > MaxClaimRatio * sampled)
                    continue;
                min = allMin;
                max = allMax;
            }
            return RootCube.Around(min, max);
        }

        static Grid3 ToGrid(in SourceGrid grid, double3 stored) =>
            new Grid3(SourceGrid.ToGrid(grid.X, stored.x), SourceGrid.ToGrid(grid.Y, stored.y),
                SourceGrid.ToGrid(grid.Z, stored.z));
    }
}
