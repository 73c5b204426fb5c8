using System;
using System.Collections.Generic;
using FastPoints.Nodes;
using FastPoints.Reading;
using FastPoints.Sampling;
using Unity.Mathematics;

namespace FastPoints.Build
{
    internal static class RootCube
    {
        const double MaxClaimRatio = 4; // Claimed extents more than this many times that of the sample are ignored.

        public static GridCube Around(Grid3 min, Grid3 max)
        {
            var extent = max - min;
            long longest = Math.Max(extent.X, Math.Max(extent.Y, extent.Z));
            int side = 0;
            while (1L << side <= longest)
                side++;
            long spare = (1L << side) - 1;
            return new GridCube(min - new Grid3((spare - extent.X) / 2, (spare - extent.Y) / 2, (spare - extent.Z) / 2), side);
        }

        /// <summary>Doubles a cube until it contains a box; each cube is an octant of the next.</summary>
        /// <returns>The doubled cubes, the smallest first; none if the cube contains the box.</returns>
        public static GridCube[] Grow(GridCube cube, Grid3 min, Grid3 max)
        {
            var shells = new List<GridCube>();
            while (!cube.Contains(min) || !cube.Contains(max))
            {
                long side = cube.Side;
                // It grows towards the side that lacks room; if both do, the low one first.
                cube = new GridCube(new Grid3(
                    cube.Corner.X - (min.X < cube.Corner.X ? side : 0),
                    cube.Corner.Y - (min.Y < cube.Corner.Y ? side : 0),
                    cube.Corner.Z - (min.Z < cube.Corner.Z ? side : 0)), cube.SideLog2 + 1);
                shells.Add(cube);
            }
            return shells.ToArray();
        }

        /// <summary>The smallest cube of the octree, this one or one below it, that contains the box.</summary>
        public static GridCube Shrink(GridCube cube, Grid3 min, Grid3 max)
        {
            while (cube.SideLog2 > 0 && cube.OctantOf(min) == cube.OctantOf(max))
                cube = cube.Child(cube.OctantOf(min));
            return cube;
        }

        /// <summary>The cube around the sample, and around the bounds in headers, unless these are far larger: headers
        /// may be wrong.</summary>
        public static GridCube Guess(IReadOnlyList<PointReader> readers, IReadOnlyList<SampleStatistics> found, GridChoice grid)
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
                return Around(default, default);
            const long limit = SourceToGrid.Limit - 1;
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
            return Around(min, max);
        }

        static Grid3 ToGrid(in SourceToGrid grid, double3 stored) =>
            new Grid3(SourceToGrid.ToGrid(grid.X, stored.x), SourceToGrid.ToGrid(grid.Y, stored.y),
                SourceToGrid.ToGrid(grid.Z, stored.z));
    }
}
