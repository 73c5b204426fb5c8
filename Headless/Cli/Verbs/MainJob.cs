using FastPoints.Cli.Convert;
using FastPoints.Cli.Demo;
using FastPoints.Cli.Preview;

namespace FastPoints.Cli.Verbs;

/// <summary>What the command does without a verb: everything, for one cloud after the other, and a page about it.</summary>
public sealed class MainJob : Verb
{
    readonly Argument<string[]> m_files = new("FILE")
    {
        Arity = ArgumentArity.ZeroOrMore,
        Description = "Point clouds, or folders of them. Without one, a street is scanned first (see demo-cloud).",
    };
    readonly Option<bool> m_asOne = new("--as-one") { Description = "The files are tiles of one cloud: report on that." };
    readonly Option<string?> m_out = new("--out")
    {
        HelpName = "DIR",
        Description = "Where the report goes (default: ./NAME-report; with several files a folder for each, in DIR).",
    };
    readonly Option<long> m_points = new("--points")
    {
        HelpName = "N",
        Description = "Points of the scan that is made without a FILE (default: 5,000,000).",
        DefaultValueFactory = _ => DemoCloud.DefaultPoints,
    };
    readonly Option<uint> m_seed = new("--seed")
    {
        HelpName = "S",
        Description = "Seed of that scan (default: 1).",
        DefaultValueFactory = _ => 1,
    };

    readonly SourceSettings m_source;

    public MainJob() : base(new RootCommand(
        "Point clouds: says what a file is, draws a sample of it at once, builds its octree and draws from that, and writes "
            + "a page with pictures, facts and times."))
    {
        Command.Add(m_files);
        Command.Add(m_asOne);
        Command.Add(m_out);
        Command.Add(m_points);
        Command.Add(m_seed);
        m_source = new SourceSettings(Command);
        AddCommonOptions();
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints", "make a scan, and report on it"),
        ("./fastpoints scan.las", "report on a file, in ./scan-report/"),
        ("./fastpoints scan.las --out r --json - | jq .preview", "and a summary for scripts"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var files = parsed.GetValue(m_files) ?? [];
        string? outFolder = parsed.GetValue(m_out);
        long points = parsed.GetValue(m_points);
        if (points < 1)
            throw new UsageException("--points is at least 1");
        var reports = new List<Report>();
        var clouds = parsed.GetValue(m_asOne) && files.Length > 0 ? [files] : files.Select(f => new[] { f }).ToArray();
        run.WriteKeys = json => WriteKeys(json, Math.Max(1, clouds.Length), reports);
        if (files.Length == 0)
        {
            string folder = outFolder ?? "demo-report";
            string demo = Path.Combine(folder, "demo.las");
            OutputFile.MakeFolder(folder);
            run.Out.WriteLine("no file was named: scanning a street of " + Human.Count(points) + " points into " + demo);
            run.Out.Flush();
            DemoCloud.Write(demo, points, parsed.GetValue(m_seed), Scenes.ScanOrder.Strip, run);
            reports.Add(Report.Make([demo], new ReadOptions(), folder, run));
        }
        run.Begin(files);
        foreach (var cloud in clouds)
        {
            string own = CloudName.Of(cloud[0]) + "-report";
            string folder = outFolder == null ? own : clouds.Length == 1 ? outFolder : Path.Combine(outFolder, own);
            reports.Add(Report.Make(cloud, m_source.Read(parsed), folder, run));
        }
        StageTable.Of(run.Progress).Write(run.Out, "  ");
        run.Out.WriteLine("  at most " + Human.Bytes(PeakMemory.ResidentBytes) + " of memory");
        foreach (var report in reports)
            run.Out.WriteLine(report.Page);
    }

    static void WriteKeys(Utf8JsonWriter json, int files, List<Report> reports)
    {
        if (files == 1)
        {
            reports.FirstOrDefault()?.WriteKeys(json);
            return;
        }
        json.WriteStartArray("files");
        foreach (var report in reports)
        {
            json.WriteStartObject();
            json.WriteString("input", report.File);
            report.WriteKeys(json);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    /// <summary>One cloud's part of the job.</summary>
    sealed class Report
    {
        const int PreviewPoints = 1_000_000;

        /// <summary>Streamed to the card: few enough for a processor that stands in for it.</summary>
        const int GpuPoints = 1_000_000;

        public required string File { get; init; }
        public required string Page { get; init; }
        public required SourceFacts Facts { get; init; }
        public required PreviewStep Preview { get; init; }
        public required ConvertStep Convert { get; init; }
        public required DrawStep Picture { get; init; }

        /// <summary>Null where there is no graphics card, and nothing that stands in for one.</summary>
        public required DrawStep? Gpu { get; init; }

        public static Report Make(string[] files, ReadOptions source, string folder, CliRun run)
        {
            int firstStage = run.Progress.Finished.Count;
            using var reader = PointReaders.Open(files, source);
            string file = files[0];
            var facts = new SourceFacts(reader);
            facts.Write(run.Out);
            run.Out.WriteLine();
            run.Out.Flush();
            run.Warn(reader.Info, isShown: true);
            OutputFile.MakeFolder(folder);

            string previewPath = Path.Combine(folder, "preview.png"), picturePath = Path.Combine(folder, "picture.png");
            var picture = new PictureOptions();
            run.Progress.Group = "preview";
            var preview = PreviewStep.Run(reader, new PreviewOptions { Points = PreviewPoints, Picture = picture }, run);
            OutputFile.Write(previewPath, preview.Png);
            run.Out.WriteLine("  preview  " + preview.Describe());
            run.Out.Flush();
            // The same view, so that the two can be laid over each other.
            picture.Camera = preview.Camera;
            run.Progress.Group = "octree";
            string cloudPath = Path.Combine(folder, CloudName.Of(file) + StoreFormat.FolderExtension);
            var convert = ConvertStep.Run([reader], cloudPath, new ConvertSettings(), run);
            run.Out.WriteLine("  octree   " + convert.Describe());
            run.Out.Flush();
            run.Progress.Group = "picture";
            var drawn = DrawStep.RunStored(cloudPath, picture, 0, run);
            OutputFile.Write(picturePath, drawn.Png);
            run.Out.WriteLine("  picture  " + drawn.Describe());
            foreach (string assumption in drawn.Assumptions)
                run.Out.WriteLine("           " + assumption);
            run.Progress.Group = "gpu";
            var gpu = HeadlessGraphics.IsAvailable ? DrawStep.RunOnGpu([cloudPath], picture, GpuPoints, run) : null;
            run.Progress.Group = null;
            if (gpu != null)
                OutputFile.Write(Path.Combine(folder, "gpu.png"), gpu.Png);
            run.Out.WriteLine("  gpu      "
                + (gpu != null ? gpu.Describe() + ", " + gpu.Device : "no picture: " + HeadlessGraphics.WhyNot));
            run.Out.WriteLine();

            var page = new ReportPage(files.Length > 1 ? reader.Info.Path : NameOf(file));
            page.Facts(facts.Lines());
            foreach (var warning in reader.Info.Warnings)
                page.Warning("warning: " + warning);
            page.Heading("Preview");
            page.Picture(preview.Png, preview.Describe());
            page.Heading("From the octree");
            page.Paragraph(convert.Describe() + ": " + cloudPath);
            page.Picture(drawn.Png, string.Join("; ", drawn.Assumptions.Prepend(drawn.Describe())));
            if (gpu != null)
            {
                page.Heading("Streamed, and drawn as a game would draw it");
                page.Picture(gpu.Png, gpu.Describe() + ", " + gpu.Device);
            }
            page.Heading("Attributes");
            page.Table(facts.Attributes());
            if (reader.Info.Facts.Count > 0)
            {
                page.Heading("Header");
                page.Facts(reader.Info.Facts.Select(f => (f.Key, f.Value)));
            }
            page.Heading("What took how long");
            page.Table(StageTable.Of(run.Progress, firstStage));
            page.Paragraph(Threads.InUse + " threads; at most " + Human.Bytes(PeakMemory.ResidentBytes) + " of memory resident.");
            string pagePath = Path.Combine(folder, "report.html");
            OutputFile.Write(pagePath, page.ToBytes());
            return new Report
            {
                File = file,
                Page = pagePath,
                Facts = facts,
                Preview = preview,
                Convert = convert,
                Picture = drawn,
                Gpu = gpu,
            };
        }

        static string NameOf(string file) => Directory.Exists(file) ? CloudName.Of(file) : Path.GetFileName(file);

        public void WriteKeys(Utf8JsonWriter json)
        {
            json.WriteStartObject("info");
            Facts.WriteKeys(json);
            json.WriteEndObject();
            json.WriteStartObject("preview");
            Preview.WriteKeys(json);
            json.WriteEndObject();
            json.WriteStartObject("convert");
            Convert.WriteKeys(json);
            json.WriteEndObject();
            json.WriteStartObject("picture");
            Picture.WriteKeys(json);
            json.WriteReal("seconds", Picture.Seconds);
            json.WriteEndObject();
            if (Gpu != null)
            {
                json.WriteStartObject("gpu");
                Gpu.WriteKeys(json);
                json.WriteReal("seconds", Gpu.Seconds);
                json.WriteEndObject();
            }
            json.WriteString("report", Page);
        }
    }
}
