namespace FastPoints.Cli.Cluster;

/// <summary>Finds which of many cubes a box touches.</summary>
sealed class CubeFinder
{
    readonly GridCube[] m_cubes;
    readonly GridCube m_whole;

    /// <param name="cubes">Disjoint cubes of the octree in <paramref name="whole"/>, in Morton order.</param>
    public CubeFinder(GridCube whole, GridCube[] cubes) => (m_whole, m_cubes) = (whole, cubes);

    /// <summary>Both ends are included.</summary>
    public void Find(Grid3 min, Grid3 max, List<int> found) => Find(m_whole, 0, m_cubes.Length, min, max, found);

    void Find(GridCube cube, int first, int end, Grid3 min, Grid3 max, List<int> found)
    {
        if (first == end || !Touches(cube, min, max))
            return;
        if (end - first == 1)
        {
            if (Touches(m_cubes[first], min, max))
                found.Add(first);
            return;
        }
        for (int octant = 0; octant < 8; octant++)
        {
            int next = octant == 7 ? end : EndOf(cube, octant, first, end);
            Find(cube.Child(octant), first, next, min, max, found);
            first = next;
        }
    }

    /// <summary>The first cube behind those of an octant, or of one before it.</summary>
    int EndOf(GridCube cube, int octant, int first, int end)
    {
        while (first < end)
        {
            int middle = (first + end) / 2;
            if (cube.OctantOf(m_cubes[middle].Corner) <= octant)
                first = middle + 1;
            else
                end = middle;
        }
        return first;
    }

    static bool Touches(GridCube cube, Grid3 min, Grid3 max)
    {
        long last = cube.Side - 1;
        return min.X <= cube.Corner.X + last && max.X >= cube.Corner.X && min.Y <= cube.Corner.Y + last
            && max.Y >= cube.Corner.Y && min.Z <= cube.Corner.Z + last && max.Z >= cube.Corner.Z;
    }
}
