using System;
using System.Collections.Generic;
using FastPoints.Core;

namespace FastPoints.Build
{
    /// <summary>Groups neighbours that are small enough to be one: cubes of the octree in Morton order, grouped by the largest
    /// cubes that have no more than some number of points.</summary>
    internal static class CubeGroups
    {
        /// <summary>Consecutive items. A group of one keeps its own cube.</summary>
        public struct Group
        {
            public GridCube Cube;
            public int First;
            public int Count;
        }

        /// <param name="items">Items in Morton order, all inside <paramref name="root"/>.</param>
        /// <param name="target">The most points of a group of several.</param>
        public static List<Group> Of<T>(GridCube root, IReadOnlyList<T> items, Func<T, GridCube> cubeOf, Func<T, long> pointsOf,
            long target)
        {
            var groups = new List<Group>();
            var before = new long[items.Count + 1];
            for (int i = 0; i < items.Count; i++)
                before[i + 1] = before[i] + pointsOf(items[i]);
            Descend(root, 0, items.Count);
            return groups;

            void Descend(GridCube cube, int first, int end)
            {
                if (first == end)
                    return;
                if (end - first == 1 || before[end] - before[first] <= target)
                {
                    groups.Add(new Group { Cube = cube, First = first, Count = end - first });
                    return;
                }
                if (cube.SideLog2 == 0)
                {
                    // There are several at one place.
                    for (int i = first; i < end; i++)
                        groups.Add(new Group { Cube = cube, First = i, Count = 1 });
                    return;
                }
                for (int octant = 0; octant < 8; octant++)
                {
                    int next = first;
                    while (next < end && cube.OctantOf(cubeOf(items[next]).Corner) == octant)
                        next++;
                    Descend(cube.Child(octant), first, next);
                    first = next;
                }
            }
        }
    }
}
