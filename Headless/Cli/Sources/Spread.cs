using FastPoints.Cli.Page;

namespace FastPoints.Cli.Sources;

/// <summary>How a cloud's points lie, by an even choice of them: where nearly all are, and how densely.</summary>
sealed class Spread
{
    const int Sampled = 200_000;
    const uint Seed = 1;

    /// <summary>Along each axis this share is farther out, half of it at either end.</summary>
    const double StrayShare = 0.001;

    readonly DensityMap m_density;

    Spread(BoundsGeo nearlyAll, DensityMap density, string unit) => (NearlyAll, m_density, Unit) = (nearlyAll, density, unit);

    /// <summary>What 99.9 % of the points lie in, along each axis.</summary>
    public BoundsGeo NearlyAll { get; }

    /// <summary>Of lengths.</summary>
    public string Unit { get; }

    /// <summary>Points on a square unit, over the squares that have any; null where all lie on a line from above.</summary>
    public double[]? Quartiles => m_density.HasArea ? m_density.Quartiles : null;

    public double SquareEdge => m_density.Edge;

    /// <returns>Null where no point has a position.</returns>
    public static Spread? Of(PointReader reader, long found, CliRun run)
    {
        run.Progress.Begin("spread");
        using var uniform = new UniformSampler(reader, Sampled, Seed);
        run.Pump(uniform.Run(0, run.Progress));
        using var sample = uniform.TakeSample();
        double unit = reader.Info.Crs.MetresPerUnit;
        var ranges = new DisplayRanges { IsInDegrees = double.IsNaN(unit) };
        run.Pump(ranges.Measure(sample.Points, sample.Transform, UpAxis.Z));
        run.Progress.End();
        if (ranges.Full.IsEmpty)
            return null;
        var points = ViewPoints.Of(sample.Points, sample.Count, sample.Transform);
        double3 low = default, high = default;
        for (int axis = 0; axis < 3; axis++)
        {
            double[] sorted = points.Positions[axis].Where(double.IsFinite).Order().ToArray();
            int strays = (int)(sorted.Length * StrayShare / 2);
            (low[axis], high[axis]) = (sorted[strays], sorted[sorted.Length - 1 - strays]);
        }
        var bounds = new BoundsGeo(low, high);
        return new Spread(bounds, new DensityMap(points, bounds, ranges.LengthsPerUnit, UpAxis.Z, found), Human.Unit(unit));
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteBounds("boundsNearlyAll", NearlyAll);
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
