using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Build
{
    /// <summary>Chooses the cube of the whole octree: first a guess, for the partition; then grown and shrunk to the actual
    /// points.</summary>
    internal static class RootCube
    {
        /// <summary>The smallest cube with a box in its middle, so that points a little outside the box are still
        /// inside.</summary>
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
    }
}
