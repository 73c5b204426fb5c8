namespace FastPoints.Cli.Page;

/// <summary>How a cloud's points lie and what values they have, found from those of a page's 3D view.</summary>
sealed class CloudDistribution(ViewCloud view, UpAxis upAxis, long points, BoundsGeo bounds)
{
    readonly DensityMap m_density = new(view.Points, view.Bounds, view.Ranges.LengthsPerUnit, upAxis, points);

    public IEnumerable<(string, string)> Tiles()
    {
        yield return ("points", NumberFormat.Count(points));
        if (!bounds.IsEmpty)
        {
            double3 size = bounds.Size * view.Ranges.LengthsPerUnit;
            yield return ("extent, " + view.Unit, string.Join(" × ", new[] { size.x, size.y, size.z }.Select(Amount)));
        }
        yield return ("median density", m_density.HasArea ? Amount(m_density.Quartiles[1]) + " /" + view.Unit + "²" : "no area");
    }

    static string Amount(double value) =>
        value >= 1000 ? NumberFormat.Count((long)Math.Round(value)) : NumberFormat.FourDigits(value);

    /// <summary>Whatever is not as a user would expect.</summary>
    public IEnumerable<string> Remarks(string? crs, PointSchema schema)
    {
        if (crs == null)
            yield return "No coordinate system is named: what a unit is, and where on earth this is, cannot be known.";
        if (schema.HasColor && view.Ranges.Color == ColorDepth.None)
            yield return "There are colours, but all points are black.";
        if (view.Points.Attributes.TryGetValue(AttributeNames.Classification, out var classes)
            && classes.Count > 0 && classes.All(c => c == classes[0]))
            yield return "All points are of one class: " + ViewColumn.NameOf(AttributeNames.Classification, classes[0]) + ".";
        foreach (string assumption in view.Ranges.Assumptions)
            yield return char.ToUpperInvariant(assumption[0]) + assumption[1..] + ".";
    }

    public static void Write(ReportPage page, IReadOnlyCollection<string> remarks) =>
        page.Html(remarks.Count == 0 ? "<p class=\"note\">Nothing odd was found in it.</p>"
            : "<ul class=\"odd\" aria-label=\"What is odd\">"
                + string.Concat(remarks.Select(o => $"<li>{ReportPage.Escape(o)}</li>")) + "</ul>");

    public IEnumerable<string> Charts() => m_density.HasArea ? Histograms().Append(m_density.ToHtml(view.Unit)) : Histograms();

    IEnumerable<string> Histograms()
    {
        var sample = view.Points;
        yield return BarChart.Histogram("Elevation", sample.Positions[upAxis.Index()].Select(v => upAxis.IsNegative() ? -v : v),
            view.Unit == "units" ? "in units of the file" : view.Unit);
        foreach (string name in new[] { AttributeNames.Intensity, AttributeNames.Classification, AttributeNames.ReturnNumber,
            AttributeNames.GpsTime })
        {
            if (!sample.Attributes.TryGetValue(name, out var values)
                || values.Where(double.IsFinite).Distinct().Take(2).Count() < 2)
                continue;
            if (name is AttributeNames.Classification or AttributeNames.ReturnNumber)
                yield return BarChart.Rows(name, values.CountBy(v => v).OrderBy(c => c.Key).Select(c =>
                    (ViewColumn.NameOf(name, c.Key), (double)c.Value, Percent(c.Value, values.Count))).ToList());
            else
                yield return BarChart.Histogram(name == AttributeNames.GpsTime ? "GPS time" : name, values,
                    name == AttributeNames.GpsTime ? "seconds" : "as stored");
        }
    }

    static string Percent(int count, int of) => (100.0 * count / of).ToString("0.##", CultureInfo.InvariantCulture) + " %";
}
