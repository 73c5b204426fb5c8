using FastPoints.Cli.Convert;
using FastPoints.Cli.Preview;

namespace FastPoints.Cli.Page;

sealed class CloudPage
{
    public required string Name { get; init; }
    public required string Command { get; init; }
    public required SourceFacts Facts { get; init; }
    public required ViewCloud View { get; init; }
    public required PreviewStep Preview { get; init; }
    public required ConvertStep Convert { get; init; }
    public required string CloudPath { get; init; }
    public required DrawStep Drawn { get; init; }
    public required DrawStep? Gpu { get; init; }
    public required IReadOnlyList<StageProgress.Stage> Stages { get; init; }
    public required IReadOnlyList<string> Inputs { get; init; }
    public required UpAxis UpAxis { get; init; }

    SourceInfo Info => Facts.Info;
    CloudManifest Manifest => Convert.Result.Manifest;

    /// <summary>Of a page: many letter boxes take no more than 10 MB, encoded once more.</summary>
    const int MaxBytes = 7_400_000;

    public byte[] ToBytes()
    {
        var density = new DensityMap(View.Points, View.Bounds, View.Ranges.LengthsPerUnit, UpAxis, Manifest.Points);
        var page = new ReportPage(Name, Facts.Kind + " · " + (Info.Crs.Units.IsKnown ? "in " : "UNIT ") +
            Info.Crs.Units.Describe(BoundsGeo.Empty) + " · made by FastPoints " + Version + " on " + Today);
        page.Tiles(Tiles(density));
        var odd = Odd().ToList();
        page.Html(odd.Count == 0 ? "<p class=\"note\">Nothing odd was found in it.</p>"
            : "<ul class=\"odd\" aria-label=\"What is odd\">"
                + string.Concat(odd.Select(o => $"<li>{ReportPage.Escape(o)}</li>")) + "</ul>");
        var pictures = Pictures().ToList();
        byte[] preview = Preview.ToPng(isPlain: false);
        int others = pictures.Sum(p => p.Length) + 4 * preview.Length / 3 + 200_000;
        string json = View.ToJson(Math.Max(MaxBytes - others, MaxBytes / 8), out int shown);
        page.View(json, preview, Name + ": " + Human.Count(shown) + " of its points", "Waves of the preview", Note(shown));
        page.Heading("Facts");
        page.Html("<div class=\"row two\"><div>");
        page.Facts(Facts.Lines());
        if (Info.Facts.Count > 0)
        {
            page.Html("<details><summary>All that the header says</summary>");
            page.Facts(Info.Facts.Select(f => (f.Key, f.Value)));
            page.Html("</details>");
        }
        page.Html("</div><div>");
        page.Table(Attributes());
        page.Html("</div></div>");
        page.Heading("Distribution");
        page.Row(density.HasArea ? Histograms().Append(density.ToHtml(View.Unit)) : Histograms());
        Speed(page);
        page.Heading("Pictures of the octree");
        page.Row(pictures);
        page.Heading("What to do next");
        page.Commands(NextLines());
        page.Html("<footer class=\"note\">");
        page.Facts([("command", Command), ("version", "FastPoints " + Version), ("machine", Machine.Describe()), ("date", Today),
            ("memory", "at most " + Human.Bytes(PeakMemory.ResidentBytes) + " resident")]);
        page.Html("</footer>");
        return page.ToBytes();
    }

    public static string Today => DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture) + " UTC";
    public static string Version => typeof(CloudPage).Assembly.GetName().Version!.ToString(3);

    IEnumerable<(string, string)> Tiles(DensityMap density)
    {
        yield return ("points", Human.Count(Manifest.Points));
        if (!Manifest.BoundsGeo.IsEmpty)
        {
            double3 size = Manifest.BoundsGeo.Size * View.Ranges.LengthsPerUnit;
            yield return ("extent, " + View.Unit, string.Join(" × ", new[] { size.x, size.y, size.z }.Select(Amount)));
        }
        yield return ("median density", density.HasArea ? Amount(density.Quartiles[1]) + " /" + View.Unit + "²" : "no area");
        yield return ("coordinates", Info.Crs.Summary ?? "unknown");
        yield return ("size", Human.Bytes(Info.FileBytes));
        yield return ("as an octree", Human.Bytes(Convert.Result.BytesOnDisk));
    }

    static string Amount(double value) => value >= 1000 ? Human.Count((long)Math.Round(value)) : Human.FourDigits(value);

    /// <summary>Whatever does not fit together, or is not as a user would expect.</summary>
    IEnumerable<string> Odd()
    {
        foreach (var warning in Info.Warnings)
            yield return warning.ToString();
        long found = Manifest.Points + Manifest.PointsLeftOut;
        if (Info.HasPointsClaimed && Info.PointsClaimed != (ulong)found)
            yield return "The header claims " + Human.Count(Info.PointsClaimed) + " points; " + Human.Count(found)
                + " were found.";
        if (Manifest.PointsLeftOut > 0)
            yield return Human.Count(Manifest.PointsLeftOut, "point") + " have no position that is a number: they are left out.";
        if (Info.HasBoundsClaimed && !Manifest.BoundsGeo.IsEmpty)
            for (int axis = 0; axis < 3; axis++)
                foreach (var (claimed, real, end) in new[]
                {
                    (Info.BoundsClaimed.Min[axis], Manifest.BoundsGeo.Min[axis], "least"),
                    (Info.BoundsClaimed.Max[axis], Manifest.BoundsGeo.Max[axis], "greatest"),
                })
                    // Writers round them in many ways, by a step or two.
                    if (!(Math.Abs(claimed - real) <= Math.Max(2 * Math.Abs(Info.Transform.Scale[axis]), 1e-9 * Math.Abs(real))))
                        yield return $"Bounds: by the header the {end} {"xyz"[axis]} is {Human.Value(claimed)}; "
                            + $"of the points it is {Human.Value(real)}.";
        if (!Info.Crs.IsKnown)
            yield return "No coordinate system is named: what a unit is, and where on earth this is, cannot be known.";
        if (Info.Schema.HasColor && View.Ranges.Color == ColorDepth.None)
            yield return "There are colours, but all points are black.";
        if (View.Points.Attributes.TryGetValue(AttributeNames.Classification, out var classes)
            && classes.Count > 0 && classes.All(c => c == classes[0]))
            yield return "All points are of one class: " + ViewColumn.NameOf(AttributeNames.Classification, classes[0]) + ".";
        foreach (string assumption in View.Ranges.Assumptions)
            yield return char.ToUpperInvariant(assumption[0]) + assumption[1..] + ".";
    }

    /// <summary>With what the conversion found: in order, so that constants stand out.</summary>
    TextTable Attributes()
    {
        var table = new TextTable("attribute", "type", "least", "greatest");
        foreach (var attribute in Info.Schema)
        {
            int i = Manifest.Attributes.IndexOf(attribute.Name), axis = "XYZ".IndexOf(attribute.Name, StringComparison.Ordinal);
            bool isPosition = axis >= 0 && attribute.Name.Length == 1;
            double step = isPosition && !attribute.Type.IsFloat() ? Info.Transform.Scale[axis] : 0.001;
            string Text(double value) => isPosition ? Human.Coordinate(value, step) : ViewColumn.NameOf("", value);
            table.Add(attribute.Name, attribute.Type.ToString(),
                isPosition ? Text(Manifest.BoundsGeo.Min[axis]) : i >= 0 ? Text(Manifest.Ranges[i].Min) : "",
                isPosition ? Text(Manifest.BoundsGeo.Max[axis]) : i >= 0 ? Text(Manifest.Ranges[i].Max) : "");
        }
        return table;
    }

    string Note(int shown)
    {
        var error = View.PositionError;
        string text = Human.Count(shown) + " of " + Human.Count(Manifest.Points, "point") + ", as the preview chooses them. "
            + "Positions are rounded for this page: each is within " + string.Join(" × ", new[] { error.x, error.y, error.z }
                .Select(e => e.ToString("G2", CultureInfo.InvariantCulture))) + " (x, y, z, in the file's units) of the file's. "
            + "Amounts are rounded to 256 steps. The data themselves are not changed.";
        return ReportPage.Escape(text);
    }

    IEnumerable<string> Histograms()
    {
        var points = View.Points;
        yield return BarChart.Histogram("Elevation", points.Positions[UpAxis.Index()].Select(v => UpAxis.IsNegative() ? -v : v),
            View.Unit == "m" ? "m" : "in units of the file");
        foreach (string name in new[] { AttributeNames.Intensity, AttributeNames.Classification, AttributeNames.ReturnNumber,
            AttributeNames.GpsTime })
        {
            if (!points.Attributes.TryGetValue(name, out var values)
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

    void Speed(ReportPage page)
    {
        page.Heading("Error and time");
        var curve = new LineChart("Error of the preview against time", "seconds from the open call", "RMS distance, " + View.Unit)
        {
            PlotWidth = 310,
            HasLegend = false,
            LogX = true,
            LogY = true,
        };
        bool isMeasured = !View.Ranges.IsInDegrees;
        curve.Add("preview", View.Waves.Where(_ => isMeasured).Select(w => (w.Seconds, w.Rms)));
        var stages = Stages.Select(s => (s.Name, s.Seconds, Human.Seconds(s.Seconds))).ToList();
        page.Html("<div class=\"row\"><figure id=\"error-chart\">" + curve.ToSvg() + "<figcaption>"
            + (isMeasured ? "How far 100,000 points, chosen evenly from the whole cloud, are from the nearest point of each wave "
                + "of the preview above. A hollow mark on the lower edge is an error of zero: all points are shown."
                : "Not measured: coordinates are degrees.")
            + "</figcaption></figure><figure>" + BarChart.Rows("What took how long", stages) + "<figcaption>"
            + ReportPage.Escape(Threads.InUse + " threads; " + Human.Seconds(Stages.Sum(s => s.Seconds)) + " together.")
            + "</figcaption></figure></div>");
    }

    IEnumerable<string> Pictures()
    {
        yield return Picture(Drawn.Image, "Drawn in software: " + string.Join("; ", Drawn.Assumptions.Prepend(Drawn.Describe())));
        if (Gpu != null)
            yield return Picture(Gpu.Image, "Streamed, and drawn as a game would: " + Gpu.Describe() + ", " + Gpu.Device);
    }

    static string Picture(RgbaImage image, string caption)
    {
        var half = new RgbaImage(Math.Max(1, image.Width / 2), Math.Max(1, image.Height / 2));
        for (int y = 0; y < half.Height; y++)
            for (int x = 0; x < 4 * half.Width; x++)
            {
                int at = 2 * y * image.Width * 4 + x / 4 * 8 + x % 4, right = Math.Min(1, image.Width - 1) * 4;
                int below = Math.Min(1, image.Height - 1) * image.Width * 4;
                half.Rgba[y * half.Width * 4 + x] = (byte)((image.Rgba[at] + image.Rgba[at + right] + image.Rgba[at + below]
                    + image.Rgba[at + right + below] + 2) / 4);
            }
        return $"<img alt=\"{ReportPage.Escape(caption)}\" src=\"data:image/png;base64,"
            + System.Convert.ToBase64String(Png.Encode(half)) + $"\"><figcaption>{ReportPage.Escape(caption)}</figcaption>";
    }

    IEnumerable<(string, string)> NextLines()
    {
        string inputs = string.Join(' ', Inputs.Select(Quoted)), cloud = Quoted(CloudPath);
        yield return ("Fly over it: a camera path, pictures and a page with figures of each frame",
            "fastpoints fly " + cloud + " -o flight");
        yield return ("Build the octree by itself, with less memory or another sampler", "fastpoints convert " + inputs
            + " -o scan.fastpoints --memory 1GiB");
        yield return ("Points out again, whole or a part: for other programs", "fastpoints export " + cloud + " -o part.laz");
        yield return ("Prove that the octree holds every point", "fastpoints verify " + cloud + " --against " + inputs);
        yield return ("Count and check all points", "fastpoints info " + inputs + " --scan");
        yield return ("Unity: install the package (Window > Package Manager > + > Install package from git URL), then drop "
            + "the file or the folder of the octree into a scene",
            "<address of the FastPoints repository>.git?path=/Packages/com.fastpoints.dots");
    }

    public static string Quoted(string word) =>
        word.Length > 0 && word.All(c => char.IsLetterOrDigit(c) || "-_./\\:=,+@".Contains(c)) ? word
            : "'" + word.Replace("'", "'\\''") + "'";
}
