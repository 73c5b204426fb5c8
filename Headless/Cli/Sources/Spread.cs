namespace FastPoints.Cli.Sources;

sealed class Spread
{
    const double OutlierShare = 0.001;

    readonly DensityMap m_density;

    Spread(BoundsGeo robustBounds, DensityMap density, string unit) =>
        (RobustBounds, m_density, Unit) = (robustBounds, density, unit);

    public BoundsGeo RobustBounds { get; } // Bounds of 99.9 % of the points along each axis.

    public string Unit { get; }

    /// <summary>Points on a square unit, over the squares that have any; null if all lie on a line from above.</summary>
    public double[]? Quartiles => m_density.HasArea ? m_density.Quartiles : null;

    public double SquareEdge => m_density.CellSize;

    /// <returns>Null if no point has a position.</returns>
    public static Spread? Of(PointReader reader, SpreadSample sample, CliRun run)
    {
        if (sample.Points is not { } batch)
            return null;
        var ranges = new DisplayRanges { Units = reader.Info.Crs.Units };
        run.RunSteps(ranges.Measure(batch, reader.Info.Transform, UpAxis.Z));
        if (ranges.Full.IsEmpty)
            return null;
        var points = ViewPoints.Of(batch, batch.Count, reader.Info.Transform);
        double3 low = default, high = default;
        for (int axis = 0; axis < 3; axis++)
        {
            double[] sorted = points.Positions[axis].Where(double.IsFinite).Order().ToArray();
            int outliers = (int)(sorted.Length * OutlierShare / 2);
            (low[axis], high[axis]) = (sorted[outliers], sorted[sorted.Length - 1 - outliers]);
        }
        var bounds = new BoundsGeo(low, high);
        var density = new DensityMap(points, bounds, ranges.LengthsPerUnit, UpAxis.Z, sample.Found);
        return new Spread(bounds, density, NumberFormat.Unit(ranges.Units.Horizontal));
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteBounds("boundsNearlyAll", RobustBounds);
        if (Quartiles == null)
        {
            json.WriteNull("density");
            return;
        }
        json.WriteStartObject("density");
        json.WriteString("unit", "points/" + Unit + "²");
        json.WriteReal("lowerQuartile", Quartiles[0]);
        json.WriteReal("median", Quartiles[1]);
        json.WriteReal("upperQuartile", Quartiles[2]);
        json.WriteReal("squareEdge", SquareEdge);
        json.WriteEndObject();
    }
}

sealed class SpreadSample(PointReader reader) : IDisposable
{
    const int Wanted = 200_000;
    const uint Seed = 1;

    SampleStrata m_strata;

    public PointBatch? Points { get; private set; } // Null before the first, and without positions.

    public long Found { get; private set; }

    public unsafe void Add(BlockRead read)
    {
        var block = read.Points;
        Found += block.Count;
        string[] axes = [AttributeNames.X, AttributeNames.Y, AttributeNames.Z];
        if (block.Count == 0 || !axes.All(a => block.Schema.Has(a)))
            return;
        if (Points == null)
        {
            m_strata = new SampleStrata(reader.PointCount, Wanted, Seed);
            Points = new PointBatch(block.Schema.Select(axes), m_strata.Count, Allocator.Persistent);
        }
        byte* from = (byte*)block.Bytes.GetUnsafeReadOnlyPtr(), to = (byte*)Points.Bytes.GetUnsafePtr();
        long end = read.FirstPoint + block.Count;
        if (read.FirstPoint >= m_strata.Points)
            return;
        for (int s = m_strata.StratumOf(read.FirstPoint); s < m_strata.Count && m_strata.FirstOf(s) < end; s++)
        {
            long point = m_strata.Chosen(s) - read.FirstPoint;
            if (point < 0 || point >= block.Count)
                continue;
            for (int axis = 0; axis < 3; axis++)
            {
                int bytes = Points.Schema[axis].Type.SizeOf();
                UnsafeUtility.MemCpy(to + Points.Column(axis).OffsetBytes + Points.Count * bytes,
                    from + block.Column(block.Schema.IndexOf(Points.Schema[axis].Name)).OffsetBytes + point * bytes, bytes);
            }
            Points.Count++;
        }
    }

    public void Dispose() => Points?.Dispose();
}
