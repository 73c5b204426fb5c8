namespace FastPoints.Cli.Surfaces;

/// <summary>The surfaces of cells as one: what neighbours have in common is there once.</summary>
sealed class SurfaceMesh(SurfaceGrid grid)
{
    const int ReachVoxels = 3; // Neighbours have the vertices so near to a face, in voxels.

    readonly Dictionary<(long X, long Y, long Z), int> m_numberOfShared = [];

    /// <summary>In steps of a voxel from the root's corner.</summary>
    public List<(long X, long Y, long Z)> Vertices { get; } = [];
    public List<int3> Triangles { get; } = [];

    /// <returns>The cell's own triangles, in metres from the root's corner.</returns>
    public (List<double3> Vertices, List<int3> Triangles) Add(SurfaceBuilder builder, int3 cell)
    {
        var vertices = builder.Vertices;
        var numbers = new int[vertices.Length];
        var own = (Vertices: new List<double3>(vertices.Length), Triangles: new List<int3>(builder.Triangles.Length));
        long cellSteps = (long)grid.CellEdgeVoxels * SurfaceGrid.StepsPerVoxel;
        (long X, long Y, long Z) PlaceOf(int vertex) => (cell.x * cellSteps + vertices[vertex].x,
            cell.y * cellSteps + vertices[vertex].y, cell.z * cellSteps + vertices[vertex].z);

        // Some are another cell's: whoever has a triangle there adds them.
        int NumberOf(int vertex)
        {
            if (numbers[vertex] > 0)
                return numbers[vertex] - 1;
            var place = PlaceOf(vertex);
            bool isShared = IsNearFace(vertices[vertex]);
            if (isShared && m_numberOfShared.TryGetValue(place, out int number))
                return (numbers[vertex] = number + 1) - 1;
            Vertices.Add(place);
            if (isShared)
                m_numberOfShared.Add(place, Vertices.Count - 1);
            return (numbers[vertex] = Vertices.Count) - 1;
        }

        for (int v = 0; v < vertices.Length; v++)
            own.Vertices.Add(MetresOf(PlaceOf(v)));
        foreach (var t in builder.Triangles)
        {
            Triangles.Add(new int3(NumberOf(t.x), NumberOf(t.y), NumberOf(t.z)));
            own.Triangles.Add(t);
        }
        return own;
    }

    public double3 MetresOf((long X, long Y, long Z) place) =>
        new double3(place.X, place.Y, place.Z) * (grid.VoxelMetres / SurfaceGrid.StepsPerVoxel);

    bool IsNearFace(int3 steps)
    {
        const int reach = ReachVoxels * SurfaceGrid.StepsPerVoxel;
        int end = grid.CellEdgeVoxels * SurfaceGrid.StepsPerVoxel;
        return math.any(steps < reach) || math.any(steps > end - reach);
    }
}
