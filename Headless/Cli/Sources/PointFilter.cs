namespace FastPoints.Cli.Sources;

sealed class PointFilter : IPointFilter, IDisposable
{
    readonly List<FilterExpression> m_expressions = new List<FilterExpression>();

    public IReadOnlyList<FilterExpression> Expressions => m_expressions;
    public long EveryNth; // Every n-th point in the source's order, from the first; 0 or 1 for all.
    public FilterPolygons? Polygons; // In the horizontal coordinates of the source; null for all. Owned.
    public LocalClip[] Clips = Array.Empty<LocalClip>(); // In the source's coordinates.

    public bool IsEmpty => m_expressions.Count == 0 && EveryNth <= 1 && Polygons == null && Clips.Length == 0;

    public IEnumerable<string> Attributes
    {
        get
        {
            foreach (var expression in m_expressions)
                foreach (var (left, right) in expression.Names)
                {
                    if (left != null)
                        yield return left;
                    if (right != null)
                        yield return right;
                }
        }
    }

    public unsafe ulong Hash
    {
        get
        {
            ulong hash = (ulong)EveryNth;
            foreach (var expression in m_expressions)
                fixed (char* first = expression.Text)
                    hash = hash * 31 ^ ContentHash.Of(first, expression.Text.Length * sizeof(char));
            if (Polygons != null)
                hash = hash * 31 ^ Polygons.Hash;
            fixed (LocalClip* clips = Clips)
                for (int c = 0; c < Clips.Length; c++)
                    hash = hash * 31 ^ ContentHash.Of(clips + c, 12 * sizeof(double)) + (clips[c].Cuts ? 1ul : 0);
            return hash;
        }
    }

    /// <exception cref="FormatException">See <see cref="FilterExpression.Parse"/>.</exception>
    public void Add(string expression) => m_expressions.Add(FilterExpression.Parse(expression));

    public void Dispose() => Polygons?.Dispose();

    public IFilterSlot CreateSlot(PointBatch batch, in PositionTransform transform) =>
        new FilterSlot(this, batch, transform);
}

/// <summary>Applies a filter to a batch once it is decoded: wanted points move to its front.</summary>
sealed class FilterSlot : IFilterSlot
{
    const int PointsPerSlice = 8192;

    FilterPointsJob m_job;

    public FilterSlot(PointFilter filter, PointBatch batch, in PositionTransform transform)
    {
        var columns = new PointColumn[batch.Schema.Count];
        for (int c = 0; c < columns.Length; c++)
            columns[c] = batch.Column(c);
        Result = new NativeReference<DecodeResult>(Allocator.Persistent);
        m_job = new FilterPointsJob
        {
            Columns = batch.Bytes,
            AllColumns = new NativeArray<PointColumn>(columns, Allocator.Persistent),
            Steps = new NativeArray<FilterStep>(FilterSteps.Of(filter.Expressions, batch, transform), Allocator.Persistent),
            Clips = new NativeArray<LocalClip>(filter.Clips, Allocator.Persistent),
            Chosen = new NativeArray<int>(PointsPerSlice, Allocator.Persistent),
            Edges = filter.Polygons?.RelativeEdgesOfSlabs ?? new NativeArray<FilterEdge>(0, Allocator.Persistent),
            FirstOfSlab = filter.Polygons?.FirstOfSlab ?? new NativeArray<int>(0, Allocator.Persistent),
            PolygonMin = filter.Polygons?.Min ?? default,
            PolygonSize = filter.Polygons == null ? default : filter.Polygons.Max - filter.Polygons.Min,
            Positions = PositionColumns.Of(batch),
            Transform = transform,
            EveryNth = filter.EveryNth,
            Filtered = Result,
        };
    }

    public NativeReference<DecodeResult> Result { get; }

    public JobHandle Schedule(NativeReference<DecodeResult> decodedResult, BlockRange range, long firstPoint,
        JobHandle decoded)
    {
        var job = m_job;
        job.Decoded = decodedResult;
        job.FirstPoint = firstPoint;
        for (job.First = 0; job.First < range.Count; job.First += PointsPerSlice)
            decoded = job.Schedule(decoded);
        return decoded;
    }

    public void Dispose()
    {
        if (!m_job.Chosen.IsCreated)
            return;
        m_job.AllColumns.Dispose();
        m_job.Steps.Dispose();
        m_job.Clips.Dispose();
        m_job.Chosen.Dispose();
        if (m_job.FirstOfSlab.Length == 0)
        {
            m_job.Edges.Dispose();
            m_job.FirstOfSlab.Dispose();
        }
        Result.Dispose();
        m_job = default;
    }
}

/// <summary>Chooses points of a slice of a batch, and moves them after those chosen in earlier slices.</summary>
unsafe struct FilterPointsJob : IJob
{
    const int BatchLength = ColumnValues.BatchLength;

    public NativeArray<byte> Columns;
    [ReadOnly] public NativeReference<DecodeResult> Decoded;
    [ReadOnly] public NativeArray<PointColumn> AllColumns;
    [ReadOnly] public NativeArray<FilterStep> Steps;
    [ReadOnly] public NativeArray<LocalClip> Clips;
    [ReadOnly] public NativeArray<FilterEdge> Edges;
    [ReadOnly] public NativeArray<int> FirstOfSlab;
    public double2 PolygonMin;
    public double2 PolygonSize;
    public NativeArray<int> Chosen;
    public PositionColumns Positions;
    public PositionTransform Transform;
    public long EveryNth;
    public long FirstPoint;
    public int First;
    public NativeReference<DecodeResult> Filtered;

    public void Execute()
    {
        var result = Decoded.Value;
        int count = math.min(Chosen.Length, result.Points - First);
        result.Points = First == 0 ? 0 : Filtered.Value.Points;
        if (count > 0)
        {
            int chosen = Choose(count);
            for (int c = 0; c < AllColumns.Length && chosen > 0; c++)
                PointRecords.Gather((byte*)Columns.GetUnsafePtr(), AllColumns[c], (int*)Chosen.GetUnsafeReadOnlyPtr(), chosen,
                    result.Points);
            result.Points += chosen;
        }
        Filtered.Value = result;
    }

    int Choose(int count)
    {
        byte* bytes = (byte*)Columns.GetUnsafeReadOnlyPtr();
        int* chosen = (int*)Chosen.GetUnsafePtr();
        double* x = stackalloc double[BatchLength], y = stackalloc double[BatchLength], z = stackalloc double[BatchLength];
        byte* results = stackalloc byte[FilterSteps.ResultsBytes];
        bool needsPlaces = Clips.Length > 0 || FirstOfSlab.Length > 0;
        int done = 0;
        for (int first = 0; first < count; first += BatchLength)
        {
            int points = math.min(BatchLength, count - first);
            UnsafeUtility.MemSet(results, 1, points);
            if (Steps.Length > 0)
                FilterSteps.Evaluate((FilterStep*)Steps.GetUnsafeReadOnlyPtr(), Steps.Length, bytes, First + first, points,
                    new FilterMemory { Results = results, Left = x, Right = y });
            if (EveryNth > 1)
                for (int i = 0; i < points; i++)
                    results[i] &= (byte)((FirstPoint + First + first + i) % EveryNth == 0 ? 1 : 0);
            if (needsPlaces)
            {
                Positions.Load(bytes, First + first, points, x, y, z);
                Transform.ToGeo(points, x, y, z);
            }
            for (int i = 0; i < points; i++)
                if (results[i] != 0 && (!needsPlaces || IsInside(new double3(x[i], y[i], z[i]))))
                    chosen[done++] = First + first + i;
        }
        return done;
    }

    bool IsInside(double3 position) =>
        (Clips.Length == 0 || LocalClip.Keeps((LocalClip*)Clips.GetUnsafeReadOnlyPtr(), Clips.Length, position)) &&
        (FirstOfSlab.Length == 0 || IsInPolygons(position));

    /// <summary>A point beside an edge by rounding alone counts as on it.</summary>
    bool IsInPolygons(double3 position)
    {
        double reach = (math.abs(position.x) + math.abs(position.y)) * 4.5e-16;
        double x = position.x - PolygonMin.x, y = position.y - PolygonMin.y;
        bool isFinite = reach < double.PositiveInfinity;
        if (!(isFinite && x >= -reach && y >= -reach && x <= PolygonSize.x + reach && y <= PolygonSize.y + reach))
            return false;
        var edges = (FilterEdge*)Edges.GetUnsafeReadOnlyPtr();
        int slab = FilterPolygons.SlabOf(y, PolygonSize.y, FirstOfSlab.Length - 1);
        int polygon = 0;
        bool isInside = false;
        for (int e = FirstOfSlab[slab]; e < FirstOfSlab[slab + 1]; e++)
        {
            ref var edge = ref edges[e];
            if (edge.Polygon != polygon)
            {
                if (isInside)
                    return true;
                polygon = edge.Polygon;
            }
            if (math.max(edge.From.x, edge.To.x) < x - reach)
                continue;
            double dx = edge.To.x - edge.From.x, dy = edge.To.y - edge.From.y;
            double cross = dx * (y - edge.From.y) - dy * (x - edge.From.x);
            if (math.abs(cross) <= reach * (math.abs(dx) + math.abs(dy)) && x >= math.min(edge.From.x, edge.To.x) - reach &&
                y >= math.min(edge.From.y, edge.To.y) - reach && y <= math.max(edge.From.y, edge.To.y) + reach)
                return true;
            if (edge.From.y > y != edge.To.y > y && cross > 0 == dy > 0)
                isInside = !isInside;
        }
        return isInside;
    }
}
