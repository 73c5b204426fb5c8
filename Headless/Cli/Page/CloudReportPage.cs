namespace FastPoints.Cli.Page;

sealed class CloudReportPage
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

    /// <summary>Else the cloud is gone once its page is there.</summary>
    public required bool IsKept { get; init; }

    SourceInfo Info => Facts.Info;
    CloudManifest Manifest => Convert.Result.Manifest;
    const int MaxBytes = 7_400_000; // Many mail servers take attachments up to 10 MB, encoded once more in base 64.

    public byte[] ToBytes()
    {
        var distribution = new CloudDistribution(View, UpAxis, Manifest.Points, Manifest.BoundsGeo);
        var page = new ReportPage(Name, Facts.Kind + " · " + UnitOf(Info.Crs.Units) + " · made by FastPoints " + Version
            + " on " + Today);
        page.Tiles(distribution.Tiles().Concat([("coordinates", Info.Crs.Summary ?? "unknown"),
            ("size", NumberFormat.Bytes(Info.FileBytes)), ("as an octree", NumberFormat.Bytes(Convert.Result.BytesOnDisk))]));
        CloudDistribution.Write(page, Remarks(distribution).ToList());
        var pictures = Pictures().ToList();
        byte[] preview = Preview.ToPng(isPlain: false);
        int others = pictures.Sum(p => p.Length) + 4 * preview.Length / 3 + 200_000;
        string json = View.ToJson(Math.Max(MaxBytes - others, MaxBytes / 8), out int shown);
        page.View(json, preview, Name + ": " + NumberFormat.Count(shown) + " of its points", "Waves of the preview", Note(shown),
            View.Unit);
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
        page.Row(distribution.Charts());
        Speed(page);
        page.Heading("Pictures of the octree");
        page.Row(pictures);
        page.Heading("What to do next");
        page.Commands(NextLines());
        page.Html("<footer class=\"note\">");
        page.Facts([("command", Command), ("version", "FastPoints " + Version), ("machine", Machine.Describe()), ("date", Today),
            ("memory", "at most " + NumberFormat.Bytes(PeakMemory.ResidentBytes) + " resident")]);
        page.Html("</footer>");
        return page.ToBytes();
    }

    public static string Today => DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture) + " UTC";
    public static string Version => typeof(CloudReportPage).Assembly.GetName().Version!.ToString(3);

    /// <summary>What contradicts itself, or is not as a user would expect.</summary>
    IEnumerable<string> Remarks(CloudDistribution distribution)
    {
        foreach (var warning in Info.Warnings)
            yield return warning.ToString();
        long found = Manifest.Points + Manifest.PointsLeftOut;
        if (Info.HasPointsClaimed && Info.PointsClaimed != (ulong)found)
            yield return "The header claims " + NumberFormat.Count(Info.PointsClaimed) + " points; " + NumberFormat.Count(found)
                + " were found.";
        if (Manifest.PointsLeftOut > 0)
            yield return NumberFormat.Count(Manifest.PointsLeftOut, "point")
                + " have no position that is a number: they are left out.";
        if (Info.HasBoundsClaimed && !Manifest.BoundsGeo.IsEmpty)
            for (int axis = 0; axis < 3; axis++)
                foreach (var (claimed, real, end) in new[]
                {
                    (Info.BoundsClaimed.Min[axis], Manifest.BoundsGeo.Min[axis], "least"),
                    (Info.BoundsClaimed.Max[axis], Manifest.BoundsGeo.Max[axis], "greatest"),
                })
                    // Writers round them in many ways, by a step or two.
                    if (!(Math.Abs(claimed - real) <= Math.Max(2 * Math.Abs(Info.Transform.Scale[axis]), 1e-9 * Math.Abs(real))))
                        yield return $"Bounds: by the header the {end} {"xyz"[axis]} is {NumberFormat.Value(claimed)}; "
                            + $"of the points it is {NumberFormat.Value(real)}.";
        foreach (string remark in distribution.Remarks(Info.Crs.IsKnown ? Info.Crs.Summary ?? "" : null, Info.Schema))
            yield return remark;
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
            string Text(double value) => isPosition ? NumberFormat.Coordinate(value, step) : ViewColumn.NameOf("", value);
            table.Add(attribute.Name, attribute.Type.ToString(),
                isPosition ? Text(Manifest.BoundsGeo.Min[axis]) : i >= 0 ? Text(Manifest.Ranges[i].Min) : "",
                isPosition ? Text(Manifest.BoundsGeo.Max[axis]) : i >= 0 ? Text(Manifest.Ranges[i].Max) : "");
        }
        return table;
    }

    string Note(int shown)
    {
        return ReportPage.Escape(NumberFormat.Count(shown) + " of " + NumberFormat.Count(Manifest.Points, "point")
            + ", as the preview chooses them, with all attributes as the file has them.");
    }

    void Speed(ReportPage page)
    {
        page.Heading("Error and time");
        bool isMeasured = !View.Ranges.IsInDegrees;
        var distances = WaveChart("Error of the preview against time", "RMS distance, " + View.Unit, true);
        distances.Add("preview", View.Waves.Where(_ => isMeasured).Select(w => (w.Seconds, w.Rms)));
        var flips = WaveChart("FLIP of the preview against time", "FLIP", false);
        flips.Add("preview", View.Waves.Select(w => (w.Seconds, w.Flip)));
        var stages = Stages.Select(s => (s.Name, s.Seconds, NumberFormat.Seconds(s.Seconds))).ToList();
        page.Html("<div class=\"row\"><figure id=\"error-chart\" class=\"waves\">" + distances.ToSvg() + "<figcaption>"
            + (isMeasured ? "How far 100,000 points, chosen evenly from the whole cloud, are from the nearest point of each wave "
                + "of the preview above. A hollow mark on the lower edge is an error of zero: all points are shown."
                : "Not measured: coordinates are degrees.")
            + "</figcaption></figure><figure id=\"flip-chart\" class=\"waves\">" + flips.ToSvg() + "<figcaption>"
            + "What an eye sees of the difference between each wave's picture and a smooth one of the octree, from 0 to 1. "
            + "The octree's own points, with one sample a pixel, have " + NumberFormat.FourDigits(View.FlipFloor) + "."
            + "</figcaption></figure><figure>" + BarChart.Rows("What took how long", stages) + "<figcaption>"
            + ReportPage.Escape(Threads.InUse + " threads; " + NumberFormat.Seconds(Stages.Sum(s => s.Seconds)) + " together.")
            + "</figcaption></figure></div>");
    }

    static LineChart WaveChart(string title, string yLabel, bool isLog) => new(title, "seconds from the open call", yLabel)
    {
        PlotWidth = 310,
        HasLegend = false,
        LogX = true,
        LogY = isLog,
    };

    IEnumerable<string> Pictures()
    {
        yield return HalfSizePicture(Drawn.Image, "Drawn in software: "
            + string.Join("; ", Drawn.Assumptions.Prepend(Drawn.Describe())));
        if (Gpu != null)
            yield return HalfSizePicture(Gpu.Image, "Streamed, and drawn as a game would: " + Gpu.Describe() + ", " + Gpu.Device);
    }

    public static string UnitOf(CloudUnits units) => (units.IsKnown ? "in " : "UNIT ") + units.Describe(BoundsGeo.Empty);

    public static string HalfSizePicture(RgbaImage image, string caption)
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
        if (!IsKept)
        {
            yield return ("A page of a scan of your own", "fastpoints scan.laz");
            yield return ("Keep this scan and its octree, to fly over and to export", "fastpoints --keep -o kept");
            yield break;
        }
        string inputs = string.Join(' ', Inputs.Select(QuotedWithoutQuery)), cloud = QuotedWithoutQuery(CloudPath);
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

    /// <summary>Of an address without what signs it.</summary>
    public static string QuotedWithoutQuery(string word) => QuotedWord(SourcePath.WithoutQuery(word));

    static string QuotedWord(string word) =>
        word.Length > 0 && word.All(c => char.IsLetterOrDigit(c) || "-_./\\:=,+@".Contains(c)) ? word
            : "'" + word.Replace("'", "'\\''") + "'";
}
