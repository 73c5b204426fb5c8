namespace FastPoints.Cli.Sources;

struct FilterEdge
{
    public double2 From;
    public double2 To;
    public int Polygon; // Edges of one polygon have one number.
}

/// <summary>Polygons with holes, and their edges by slabs of y, so that a point is compared with few of
/// them. A point belongs if any polygon holds it: by an even-odd count of that polygon's rings, or on an edge.</summary>
sealed class FilterPolygons : IDisposable
{
    readonly List<FilterEdge> m_edges = new List<FilterEdge>();
    readonly List<(int Polygon, double2[] Vertices)> m_rings = new List<(int, double2[])>();
    int m_polygons;

    FilterPolygons() { }

    public IReadOnlyList<(int Polygon, double2[] Vertices)> Rings => m_rings;
    public double2 Min { get; private set; } = new double2(double.PositiveInfinity, double.PositiveInfinity);
    public double2 Max { get; private set; } = new double2(double.NegativeInfinity, double.NegativeInfinity);

    /// <summary>The first edge of each slab among <see cref="RelativeEdgesOfSlabs"/>, and one more entry.</summary>
    public NativeArray<int> FirstOfSlab { get; private set; }

    public NativeArray<FilterEdge> RelativeEdgesOfSlabs { get; private set; } // By slab, in each by polygon.

    public unsafe ulong Hash => ContentHash.Of(RelativeEdgesOfSlabs.GetUnsafeReadOnlyPtr(),
        (long)RelativeEdgesOfSlabs.Length * sizeof(FilterEdge)) ^ math.asulong(Min.x) ^ 2 * math.asulong(Min.y);

    /// <param name="polygons">Rings of each; an open one is closed.</param>
    /// <exception cref="FormatException">There are no vertices, or one is not finite.</exception>
    public static FilterPolygons Of(IEnumerable<IEnumerable<double2[]>> polygons)
    {
        var made = new FilterPolygons();
        foreach (var rings in polygons)
        {
            made.m_polygons++;
            foreach (var ring in rings)
                made.AddRing(ring);
        }
        if (made.m_edges.Count == 0)
            throw new FormatException("wanted a Polygon or a MultiPolygon, got none");
        made.MakeSlabs();
        return made;
    }

    public void Dispose()
    {
        if (!FirstOfSlab.IsCreated)
            return;
        FirstOfSlab.Dispose();
        RelativeEdgesOfSlabs.Dispose();
        FirstOfSlab = default;
    }

    void AddRing(double2[] points)
    {
        m_rings.Add((m_polygons, points));
        for (int i = 0; i < points.Length; i++)
        {
            if (!math.isfinite(points[i].x) || !math.isfinite(points[i].y))
                throw new FormatException("wanted finite coordinates");
            Min = new double2(math.min(Min.x, points[i].x), math.min(Min.y, points[i].y));
            Max = new double2(math.max(Max.x, points[i].x), math.max(Max.y, points[i].y));
            m_edges.Add(new FilterEdge { From = points[i], To = points[(i + 1) % points.Length], Polygon = m_polygons });
        }
    }

    void MakeSlabs()
    {
        int slabs = math.clamp(m_edges.Count, 1, 1 << 16);
        // Long edges are in many slabs: their lists stay a small multiple of the edges.
        while (slabs > 1 && EntriesWith(slabs) > 8L * m_edges.Count + 64)
            slabs /= 2;
        var first = new NativeArray<int>(slabs + 1, Allocator.Persistent);
        var next = new int[slabs + 1];
        foreach (var edge in m_edges)
            for (int slab = FirstSlab(edge, slabs); slab <= LastSlab(edge, slabs); slab++)
                next[slab + 1]++;
        for (int slab = 0; slab < slabs; slab++)
            first[slab + 1] = next[slab + 1] += next[slab];
        var edges = new NativeArray<FilterEdge>(next[slabs], Allocator.Persistent);
        foreach (var edge in m_edges)
            for (int slab = FirstSlab(edge, slabs); slab <= LastSlab(edge, slabs); slab++)
                edges[next[slab]++] = new FilterEdge
                {
                    From = edge.From - Min,
                    To = edge.To - Min,
                    Polygon = edge.Polygon,
                };
        FirstOfSlab = first;
        RelativeEdgesOfSlabs = edges;
        m_edges.Clear();
    }

    long EntriesWith(int slabs)
    {
        long count = 0;
        foreach (var edge in m_edges)
            count += LastSlab(edge, slabs) - FirstSlab(edge, slabs) + 1;
        return count;
    }

    // A slab more on either side: a point next to an edge is rounded into another.
    int FirstSlab(in FilterEdge edge, int slabs) =>
        math.max(0, SlabOf(math.min(edge.From.y, edge.To.y) - Min.y, Max.y - Min.y, slabs) - 1);

    int LastSlab(in FilterEdge edge, int slabs) =>
        math.min(slabs - 1, SlabOf(math.max(edge.From.y, edge.To.y) - Min.y, Max.y - Min.y, slabs) + 1);

    public static int SlabOf(double yFromMin, double height, int slabs) =>
        height > 0 ? (int)math.clamp(yFromMin / height * slabs, 0, slabs - 1) : 0;
}
