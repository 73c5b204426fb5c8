namespace FastPoints.Cli.Surfaces;

/// <summary>Makes the surface of a converted cloud: finds the cells that have points, then makes one after another.</summary>
sealed class SurfaceStep : IDisposable
{
    const int PointsToMeasure = 500; // Distances are measured from so many points of a cell.
    const double MaxVoxels = 8; // Farther ones are not looked for, in voxels.

    readonly CloudFolder m_folder;
    readonly SurfaceGrid m_grid;
    readonly SurfacePointReader m_cells;
    readonly CliRun m_run;
    readonly SurfaceMesh m_mesh;
    readonly List<double> m_distances = [];
    readonly List<double3> m_sample = [];

    public SurfaceStep(string cloud, SurfaceGrid grid, PointFilter? filter, CliRun run)
    {
        m_folder = CloudFolder.Open(cloud);
        m_grid = grid;
        m_run = run;
        m_mesh = new SurfaceMesh(grid);
        m_cells = new SurfacePointReader(m_folder, grid, default, null, [.. filter?.Attributes ?? []])
        {
            Edits = EditPlan.Of(cloud, m_folder.Manifest),
        };
        if (filter != null)
            m_cells.Prepare = batch => Filter(filter, batch);
    }

    public long Points { get; private set; }
    public int CellCount { get; private set; }
    public IReadOnlyList<double> Distances => m_distances;
    public List<int3> Triangles => m_mesh.Triangles;

    public List<double3> VerticesGeo()
    {
        var metres = m_cells.Metres / m_folder.Manifest.Grid.Step;
        var corner = m_folder.Manifest.Grid.ToGeo(m_folder.Manifest.Root.Corner);
        return m_mesh.Vertices.ConvertAll(v => corner + m_mesh.MetresOf(v) / metres);
    }

    /// <summary>In the cloud's unit, along the axis where it is finest.</summary>
    public double StepGeo => math.cmin(m_folder.Manifest.Grid.Step / m_cells.Metres) * m_grid.VoxelMetres
        / SurfaceGrid.StepsPerVoxel;

    public IEnumerator<JobStep> Run()
    {
        var found = new HashSet<int3>();
        m_run.Progress.Begin("cells");
        var root = m_folder.Manifest.Root;
        yield return JobStep.Of(m_cells.Read(root.Corner, root.Corner + new Grid3(root.Side, root.Side, root.Side),
            batch => FindCells(batch, found)));
        m_run.Progress.Begin("surface");
        using var builder = new SurfaceBuilder(m_grid, new float3(0, 0, 1));
        var cells = found.OrderBy(c => c.z).ThenBy(c => c.y).ThenBy(c => c.x).ToList();
        CellCount = cells.Count;
        for (int c = 0; c < cells.Count; c++)
        {
            m_sample.Clear();
            yield return JobStep.Of(builder.Run(cells[c], AddPoints));
            Measure(m_mesh.Add(builder, cells[c]));
            m_run.Progress.Report((c + 1.0) / cells.Count, 0, 0);
            yield return default;
        }
        m_run.Progress.End();
        m_distances.Sort();
    }

    public void Dispose()
    {
        m_cells.Dispose();
        m_folder.Dispose();
    }

    IEnumerator<JobStep> Filter(PointFilter filter, PointBatch batch)
    {
        var transform = m_folder.Manifest.Grid.TransformFromCorner(m_folder.Manifest.Root.Corner);
        using var slot = new FilterSlot(filter, batch, transform);
        using var all = new NativeReference<DecodeResult>(new DecodeResult { Points = batch.Count }, Allocator.Persistent);
        if (batch.Count == 0)
            yield break;
        yield return slot.Schedule(all, new BlockRange(0, 0, batch.Count), 0, default);
        batch.Count = slot.Result.Value.Points;
    }

    IEnumerator<JobStep> FindCells(PointBatch batch, HashSet<int3> found)
    {
        NativeArray<double> x = batch.Column<double>(0), y = batch.Column<double>(1), z = batch.Column<double>(2);
        var last = new int3(int.MinValue);
        for (int i = 0; i < batch.Count; i++)
        {
            var place = new double3(x[i], y[i], z[i]) * m_cells.Metres;
            int3 first = m_grid.CellOf(place - m_grid.ReachMetres), end = m_grid.CellOf(place + m_grid.ReachMetres);
            if (first.Equals(end) && first.Equals(last))
                continue;
            last = first;
            for (int cz = first.z; cz <= end.z; cz++)
                for (int cy = first.y; cy <= end.y; cy++)
                    for (int cx = first.x; cx <= end.x; cx++)
                        found.Add(new int3(cx, cy, cz));
        }
        Points += batch.Count;
        m_run.Progress.Report(Points / (double)Math.Max(1, m_folder.Manifest.Points), Points, 0);
        yield return default;
    }

    IEnumerator<JobStep> AddPoints(SurfaceBuilder builder, int3 cell)
    {
        var prepare = m_cells.Prepare;
        m_cells.Prepare = batch => Sample(prepare, batch, cell);
        try
        {
            yield return JobStep.Of(m_cells.Add(builder, cell));
        }
        finally
        {
            m_cells.Prepare = prepare;
        }
    }

    IEnumerator<JobStep> Sample(Func<PointBatch, IEnumerator<JobStep>>? prepare, PointBatch batch, int3 cell)
    {
        if (prepare != null)
            yield return JobStep.Of(prepare(batch));
        // Near a face the nearest triangle may be the next cell's.
        double inset = 2 * m_grid.VoxelMetres;
        double3 min = new double3(cell.x, cell.y, cell.z) * m_grid.CellMetres + inset, max = min + m_grid.CellMetres - 2 * inset;
        NativeArray<double> x = batch.Column<double>(0), y = batch.Column<double>(1), z = batch.Column<double>(2);
        var inside = new List<double3>();
        for (int i = 0; i < batch.Count; i++)
        {
            var place = new double3(x[i], y[i], z[i]) * m_cells.Metres;
            if (math.all(place >= min) && math.all(place <= max))
                inside.Add(place);
        }
        int step = Math.Max(1, inside.Count / PointsToMeasure);
        for (int i = 0; i < inside.Count; i += step)
            m_sample.Add(inside[i]);
    }

    void Measure((List<double3> Vertices, List<int3> Triangles) cell)
    {
        if (m_sample.Count == 0)
            return;
        var grid = new TriangleGrid(cell.Vertices, cell.Triangles, m_grid.VoxelMetres);
        foreach (var place in m_sample)
            m_distances.Add(Math.Min(grid.DistanceTo(place, MaxVoxels * m_grid.VoxelMetres), MaxVoxels * m_grid.VoxelMetres));
    }
}
