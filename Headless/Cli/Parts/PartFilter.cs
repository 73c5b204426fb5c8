namespace FastPoints.Cli.Parts;

/// <summary>The points of a part's cube. Blocks that several parts read belong to one of them, which takes their points
/// without a position and outside of the whole cube, too.</summary>
sealed class PartFilter : IPointFilter, IDisposable
{
    readonly BuildPart m_part;
    readonly SourceToGrid m_grid;
    readonly IReadOnlyList<bool> m_isOwn;
    readonly List<Slot> m_slots = new List<Slot>();
    long m_ownBlockPoints;

    /// <param name="isOwn">By block of the reader that filters.</param>
    public PartFilter(BuildPart part, in SourceToGrid grid, IReadOnlyList<bool> isOwn)
    {
        m_part = part;
        m_grid = grid;
        m_isOwn = isOwn;
    }

    public IEnumerable<string> Attributes => Array.Empty<string>();

    public ulong Hash => 0;

    public IFilterSlot CreateSlot(PointBatch batch, in PositionTransform transform)
    {
        var slot = new Slot(this, batch);
        m_slots.Add(slot);
        return slot;
    }

    /// <summary>Points of own blocks since the last call, wherever they are, when their jobs are complete.</summary>
    public long TakeOwnBlockPoints()
    {
        foreach (var slot in m_slots)
            m_ownBlockPoints += slot.TakeOwnBlockPoints();
        long wanted = m_ownBlockPoints;
        m_ownBlockPoints = 0;
        return wanted;
    }

    public void Dispose()
    {
        foreach (var slot in m_slots.ToArray())
            slot.Dispose();
    }

    sealed class Slot : IFilterSlot
    {
        readonly PartFilter m_selection;
        FilterPartJob m_job;

        public Slot(PartFilter selection, PointBatch batch)
        {
            m_selection = selection;
            var columns = new PointColumn[batch.Schema.Count];
            for (int c = 0; c < columns.Length; c++)
                columns[c] = batch.Column(c);
            m_job = new FilterPartJob
            {
                Columns = batch.Bytes,
                AllColumns = new NativeArray<PointColumn>(columns, Allocator.Persistent),
                Positions = PositionColumns.Of(batch),
                Grid = selection.m_grid,
                Cube = selection.m_part.Cube,
                CloudCube = selection.m_part.CloudCube,
                Chosen = new NativeArray<int>(FilterPartJob.PointsPerSlice, Allocator.Persistent),
                OwnBlockPoints = new NativeReference<long>(Allocator.Persistent),
                Selected = new NativeReference<DecodeResult>(Allocator.Persistent),
            };
        }

        public NativeReference<DecodeResult> Result => m_job.Selected;

        public JobHandle Schedule(NativeReference<DecodeResult> decodedResult, BlockRange range, long firstPoint,
            JobHandle decoded)
        {
            var job = m_job;
            job.Decoded = decodedResult;
            job.IsOwn = m_selection.m_isOwn[range.Block];
            for (job.First = 0; job.First < range.Count; job.First += FilterPartJob.PointsPerSlice)
                decoded = job.Schedule(decoded);
            return decoded;
        }

        public long TakeOwnBlockPoints()
        {
            var wanted = m_job.OwnBlockPoints;
            long points = wanted.Value;
            wanted.Value = 0;
            return points;
        }

        public void Dispose()
        {
            if (!m_job.Chosen.IsCreated)
                return;
            m_selection.m_ownBlockPoints += TakeOwnBlockPoints();
            m_selection.m_slots.Remove(this);
            m_job.AllColumns.Dispose();
            m_job.Chosen.Dispose();
            m_job.OwnBlockPoints.Dispose();
            m_job.Selected.Dispose();
            m_job = default;
        }
    }
}

/// <summary>Moves points of a slice of a batch that belong to a part after those of earlier slices.</summary>
unsafe struct FilterPartJob : IJob
{
    public const int PointsPerSlice = 1 << 14; // About 0.2 ms.

    const int BatchPoints = 256;

    public NativeArray<byte> Columns;
    [ReadOnly] public NativeReference<DecodeResult> Decoded;
    [ReadOnly] public NativeArray<PointColumn> AllColumns;
    public PositionColumns Positions;
    public SourceToGrid Grid;
    public GridCube Cube;
    public GridCube CloudCube;
    public bool IsOwn; // Whether points outside of the whole cube are wanted.

    public int First;
    public NativeArray<int> Chosen;
    public NativeReference<long> OwnBlockPoints;
    public NativeReference<DecodeResult> Selected;

    public void Execute()
    {
        var result = Decoded.Value;
        int count = math.min(Chosen.Length, result.Points - First);
        result.Points = First == 0 ? 0 : Selected.Value.Points;
        if (count > 0)
        {
            byte* bytes = (byte*)Columns.GetUnsafePtr();
            var chosen = (int*)Chosen.GetUnsafePtr();
            int points = Choose(bytes, count, chosen);
            // Where all are chosen they stay in their place.
            for (int c = 0; c < AllColumns.Length && points > 0 && result.Points + points < First + count; c++)
                PointRecords.Gather(bytes, AllColumns[c], chosen, points, result.Points);
            result.Points += points;
            OwnBlockPoints.Value += IsOwn ? count : 0;
        }
        Selected.Value = result;
    }

    int Choose(byte* bytes, int count, int* chosen)
    {
        long* x = stackalloc long[3 * BatchPoints];
        long* y = x + BatchPoints, z = y + BatchPoints;
        double ignored = 0;
        int done = 0;
        for (int first = 0; first < count; first += BatchPoints)
        {
            int points = math.min(BatchPoints, count - first);
            SourceToGrid.ToGrid(Grid.X, Positions.X.At(bytes, First + first), Positions.X.Type, points, x, ref ignored);
            SourceToGrid.ToGrid(Grid.Y, Positions.Y.At(bytes, First + first), Positions.Y.Type, points, y, ref ignored);
            SourceToGrid.ToGrid(Grid.Z, Positions.Z.At(bytes, First + first), Positions.Z.Type, points, z, ref ignored);
            for (int i = 0; i < points; i++)
            {
                var position = new Grid3(x[i], y[i], z[i]);
                // What has no position is outside of every cube.
                if (Cube.Contains(position) || IsOwn && !CloudCube.Contains(position))
                    chosen[done++] = First + first + i;
            }
        }
        return done;
    }
}
