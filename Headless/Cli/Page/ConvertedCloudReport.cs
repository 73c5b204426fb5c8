namespace FastPoints.Cli.Page;

sealed class ConvertedCloudReport
{
    const int ViewBytes = 5_000_000; // Limit of the 3D view within a page of 8 MB.

    readonly ConvertedCloudFacts m_facts;
    readonly List<(string Key, DrawStep Drawn)> m_pictures = [];

    ConvertedCloudReport(string path) => m_facts = new ConvertedCloudFacts(path);

    public string ReportPath { get; private set; } = "";
    public PointCounts PointCounts => m_facts.PointCounts;

    public static ConvertedCloudReport Make(string path, (PictureOptions Options, bool IsPlain) look, long budget, string folder,
        string command, CliRun run)
    {
        var report = new ConvertedCloudReport(path);
        report.m_facts.Write(run.Out);
        run.Out.WriteLine();
        run.Out.Flush();
        var options = look.Options;
        FlightCloud.SetSize(options, path);
        run.Progress.Group = "picture";
        report.Add("picture", StreamedPictureStep.Run([path], options, budget, run), folder, look.IsPlain, run);
        run.Progress.Group = "gpu";
        if (HeadlessGraphics.IsAvailable)
            report.Add("gpu", DrawStep.RunOnGpu([path], options, budget, run), folder, look.IsPlain, run);
        run.Progress.Group = "page";
        var drawn = report.m_pictures[0].Drawn;
        var view = ViewCloud.OfFlight([path], options, [options.Camera!.Value], 0, run);
        run.Progress.Group = null;
        string name = CloudName.Of(path);
        var page = new ReportPage(name, "Converted cloud · " + CloudReportPage.UnitOf(report.m_facts.Manifest.Crs.Units)
            + " · made by FastPoints " + CloudReportPage.Version + " on " + CloudReportPage.Today);
        var cloud = report.m_facts.Manifest;
        var distribution = new CloudDistribution(view, options.UpAxis, cloud.Points, cloud.BoundsGeo);
        page.Tiles(distribution.Tiles().Concat([("coordinates", cloud.CrsName ?? "unknown"),
            ("size", NumberFormat.Bytes(report.m_facts.Bytes)), ("nodes", NumberFormat.Count(cloud.NodeCount))]));
        CloudDistribution.Write(page, distribution.Remarks(cloud.CrsName, cloud.Attributes).ToList());
        string json = view.ToJson(ViewBytes, out int shown);
        page.View(json, Png.Encode(drawn.ToImage(false)), name + ": " + NumberFormat.Count(shown) + " of its points", "",
            NumberFormat.Count(shown) + " of " + NumberFormat.Count(cloud.Points, "point")
            + ", those of the upper levels, with all attributes.",
            view.Unit);
        page.Heading("Facts");
        page.Html("<div class=\"row two\"><div>");
        page.Facts(report.m_facts.Lines());
        page.Html("</div><div>");
        foreach (var table in report.m_facts.Tables())
            page.Table(table);
        page.Html("</div></div>");
        page.Heading("Distribution");
        page.Row(distribution.Charts());
        page.Heading("Pictures");
        page.Row(report.m_pictures.Select(p =>
            CloudReportPage.HalfSizePicture(p.Drawn.Image, p.Drawn.Describe() + ", " + p.Drawn.Device)));
        page.Heading("What to do next");
        page.Commands([("Fly over it", "fastpoints fly " + CloudReportPage.QuotedWithoutQuery(path) + " -o flight"),
            ("Prove that it is undamaged", "fastpoints verify " + CloudReportPage.QuotedWithoutQuery(path)),
            ("Points out again", "fastpoints export " + CloudReportPage.QuotedWithoutQuery(path) + " -o part.laz")]);
        page.Facts([("command", command), ("machine", Machine.Describe())]);
        report.ReportPath = Path.Combine(folder, "report.html");
        OutputFile.Write(report.ReportPath, page.ToBytes());
        return report;
    }

    void Add(string key, DrawStep drawn, string folder, bool isPlain, CliRun run)
    {
        m_pictures.Add((key, drawn));
        OutputFile.Write(Path.Combine(folder, key + ".png"), Png.Encode(drawn.ToImage(isPlain)));
        run.Out.WriteLine("  " + key.PadRight(9) + drawn.Describe() + ", " + drawn.Device);
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteStartObject("info");
        m_facts.WriteKeys(json);
        json.WriteEndObject();
        foreach (var (key, drawn) in m_pictures)
        {
            json.WriteStartObject(key);
            drawn.WriteKeys(json);
            json.WriteReal("seconds", drawn.Seconds);
            json.WriteEndObject();
        }
        json.WriteString("report", ReportPath);
    }
}
