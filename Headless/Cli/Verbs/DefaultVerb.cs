namespace FastPoints.Cli.Verbs;

public sealed class DefaultVerb : Verb
{
    readonly Argument<string[]> m_files = new("FILE")
    {
        Arity = ArgumentArity.ZeroOrMore,
        Description = "Point clouds, folders of them, or converted clouds. Without one, "
            + "a street is scanned first (see demo-cloud), and goes again when its page is there.",
    };
    readonly Flag m_asOne = new("--as-one", "The files are tiles of one cloud: report on that.");
    readonly ValueOption<string?> m_out = new("--output", "DIR",
        "Where the report goes (default: ./NAME-report; with several files a folder for each, in DIR).")
    { Aliases = { "-o", "--out" } };
    readonly Option<long> m_points = Counts.Of("--points",
        "Points of the scan that is made without a FILE (default: 5,000,000).", DemoCloud.DefaultPoints);
    readonly ValueOption<uint> m_seed = new("--seed", "S", "Seed of that scan (default: 1).", 1);

    readonly Flag m_keep = new("--keep", "Keep the scan that is made without a FILE, and its octree.");
    readonly Flag m_discard = new("--discard",
        "Do not go on with an octree that was stopped, and keep nothing of this one when it is.");
    readonly LookSettings m_look;
    readonly SourceSettings m_source;
    const int DemoBytesOfPoint = 36 + 18; // 36 of the record, and what an octree takes of one.

    public DefaultVerb() : base(new RootCommand(
        "Point clouds: says what a file is, draws a sample of it at once, builds its octree and draws from that, and writes "
            + "a page with pictures, facts and times."))
    {
        Command.Add(m_files, m_asOne, m_out, m_points, m_seed, m_keep, m_discard);
        m_look = new LookSettings(Command);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints", "make a scan, and report on it"),
        ("./fastpoints scan.las", "report on a file, in ./scan-report/"),
        ("./fastpoints scan.las -o r --json - | jq .preview", "and a summary for scripts"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var files = parsed.GetValue(m_files) ?? [];
        string? outFolder = parsed.GetValue(m_out);
        long points = parsed.GetValue(m_points);
        var source = m_source.Read(parsed);
        bool isPlain = m_look.IsPlain(parsed);
        // Each cloud has its own camera and up axis.
        PictureOptions Look() => m_look.Read(parsed);
        if (Look().IsFiltered)
            throw new UsageException("--style: classes can be chosen by the verbs picture and fly, of converted clouds");
        run.IsDiscarding = parsed.GetValue(m_discard);
        files = run.Begin(files);
        string demo = Path.Combine(outFolder ?? "demo-report", "demo.las");
        var clouds = files.Length == 0 ? [[demo]]
            : parsed.GetValue(m_asOne) ? [files] : files.Select(f => new[] { f }).ToArray();
        string[] folders = files.Length == 0 ? [Path.GetDirectoryName(demo)!]
            : clouds.Length == 1 && outFolder != null ? [outFolder]
            : Report.FoldersOf(clouds).Select(f => Path.Combine(outFolder ?? "", f)).ToArray();
        bool keeps = files.Length > 0 || parsed.GetValue(m_keep);
        for (int i = 0; i < clouds.Length; i++)
            Report.Refuse(folders[i], clouds[i][0], run.Settings.IsForced);
        string command = string.Join(' ', parsed.Tokens.Select(t => CloudReportPage.QuotedWithoutQuery(t.Value))
            .Prepend("fastpoints"));
        var all = new InputResults(clouds.Select(c => c[0]));
        run.WriteKeys = all.WriteKeys;
        var pages = new List<string>();
        var before = folders.SelectMany(f => Directory.Exists(f) ? Directory.GetFileSystemEntries(f) : []).ToHashSet();
        try
        {
            if (files.Length == 0)
            {
                Report.Mark(folders[0], demo);
                run.Out.WriteLine("no file was named: scanning a street of " + NumberFormat.Count(points, "point")
                    + " into " + demo + ", some " + NumberFormat.Bytes(points * (double)DemoBytesOfPoint) + " with its octree"
                    + (keeps ? "" : "; only the page and its pictures stay (--keep keeps all)"));
                run.Out.Flush();
                DemoCloud.Write(demo, points, parsed.GetValue(m_seed), Scenes.ScanOrder.Strip, run);
            }
            for (int i = 0; i < clouds.Length; i++)
            {
                string[] cloud = clouds[i];
                string folder = folders[i];
                all.Run(run, () =>
                {
                    if (cloud is [var only] && CloudFolder.IsCloud(only))
                    {
                        Report.Mark(folder, only);
                        var stored = ConvertedCloudReport.Make(only, (Look(), isPlain), Report.GpuPoints, folder, command, run);
                        Report.WriteSummary(folder, only, stored.WriteKeys, stored.PointCounts);
                        pages.Add(stored.ReportPath);
                        return (stored.WriteKeys, stored.PointCounts);
                    }
                    var report = Report.Make(cloud, source, (Look(), isPlain), (folder, keeps), command, run);
                    Report.WriteSummary(folder, cloud[0], report.WriteKeys, report.PointCounts);
                    pages.Add(report.Page);
                    return (report.WriteKeys, report.PointCounts);
                });
            }
        }
        catch (OperationCanceledException)
        {
            for (int i = 0; i < clouds.Length; i++)
                Report.Clear(folders[i], clouds[i][0], before);
            throw;
        }
        if (!keeps)
            Report.ClearDemo(demo, before);
        StageTable.Of(run.Progress).Write(run.Out, "  ");
        run.Out.WriteLine("  at most " + NumberFormat.Bytes(PeakMemory.ResidentBytes) + " of memory");
        foreach (string page in pages)
            run.Out.WriteLine(page);
    }

    sealed class Report
    {
        const int PreviewPoints = 1_000_000;
        public const int GpuPoints = 1_000_000;
        const string PageGroup = "page";
        const string SummaryName = "report.json", PageName = "report.html";

        public required string Page { get; init; }
        public required SourceFacts Facts { get; init; }
        public required PreviewStep Preview { get; init; }
        public required ConvertStep Convert { get; init; }
        public required DrawStep Picture { get; init; }

        /// <summary>Null without a GPU, not even a software one.</summary>
        public required DrawStep? Gpu { get; init; }

        public required PointCounts PointCounts { get; init; }

        public static string[] FoldersOf(string[][] clouds)
        {
            string[] names = clouds.Select(c => CloudName.Of(c[0])).ToArray();
            var taken = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
            return names.Select((name, i) =>
            {
                bool isShared = names.Count(n => n.Equals(name, StringComparison.OrdinalIgnoreCase)) > 1;
                string first = isShared ? NameOf(clouds[i][0]) : name, folder = first + "-report";
                for (int n = 2; !taken.Add(folder); n++)
                    folder = first + "-report-" + n;
                return folder;
            }).ToArray();
        }

        public static void Refuse(string folder, string file, bool force)
        {
            OutputNames.RefuseForeignFolder("a report", folder, SummaryName, force);
            string summary = Path.Combine(folder, SummaryName);
            if (force || !File.Exists(summary))
                return;
            string? other = SummaryInput(summary);
            if (other != NameIn(file))
                throw new UsageException(folder + " has the report on " + (other ?? "something else")
                    + ": --output names another folder, --force writes over it");
        }

        static string? SummaryInput(string path)
        {
            try
            {
                using var json = JsonDocument.Parse(File.ReadAllBytes(path));
                return json.RootElement.GetProperty("input").GetString();
            }
            catch (Exception e) when (e is IOException or JsonException or KeyNotFoundException or InvalidOperationException)
            {
                return null;
            }
        }

        public static void Mark(string folder, string file)
        {
            OutputFile.MakeFolder(folder);
            if (IsFinished(folder, file))
                return;
            Summary.WriteJsonFile(Path.Combine(folder, SummaryName), json => json.WriteString("input", NameIn(file)));
        }

        static string NameIn(string file) => SourcePath.WithoutQuery(SourcePath.Full(file));

        static bool IsFinished(string folder, string file) => File.Exists(Path.Combine(folder, PageName))
            && SummaryInput(Path.Combine(folder, SummaryName)) == NameIn(file);

        public static void Clear(string folder, string file, HashSet<string> before)
        {
            string summary = Path.Combine(folder, SummaryName);
            if (IsFinished(folder, file) || !File.Exists(summary) || SummaryInput(summary) != NameIn(file))
                return;
            string cloud = Path.Combine(folder, CloudName.Of(file) + StoreFormat.FolderExtension);
            string[] made = ["preview.png", "picture.png", "gpu.png", "demo.las"];
            foreach (string path in made.Select(name => Path.Combine(folder, name)).Where(path => !before.Contains(path)))
                File.Delete(path);
            if (Directory.Exists(cloud) && !before.Contains(cloud))
                FileChanges.DeleteFolder(cloud);
            FileChanges.AwaitDeletes();
            if (Directory.EnumerateFileSystemEntries(folder).Any(e => Path.GetFileName(e) != SummaryName))
                return;
            File.Delete(summary);
            Directory.Delete(folder);
        }

        /// <summary>Takes away the scan that was made, and its octree; what was there before stays.</summary>
        public static void ClearDemo(string demo, HashSet<string> before)
        {
            string cloud = Path.Combine(Path.GetDirectoryName(demo)!, CloudName.Of(demo) + StoreFormat.FolderExtension);
            if (!before.Contains(demo))
                File.Delete(demo);
            if (Directory.Exists(cloud) && !before.Contains(cloud))
                FileChanges.DeleteFolder(cloud);
            FileChanges.AwaitDeletes();
        }

        public static void WriteSummary(string folder, string file, Action<Utf8JsonWriter> writeKeys, PointCounts counts) =>
            Summary.WriteJsonFile(Path.Combine(folder, SummaryName), json =>
            {
                json.WriteString("input", NameIn(file));
                writeKeys(json);
                counts.WriteKeys(json);
            });

        public static Report Make(string[] files, ReadOptions source, (PictureOptions Options, bool IsPlain) look,
            (string Folder, bool IsKept) target, string command, CliRun run)
        {
            string folder = target.Folder;
            int firstStage = run.Progress.Finished.Count;
            using var reader = PointReaders.Open(files, source);
            string file = files[0];
            if (reader.Tree != null && !reader.BlocksAreKnown)
                run.RunSteps(reader.IndexBlocks());
            var facts = new SourceFacts(reader);
            facts.Write(run.Out);
            run.Out.WriteLine();
            run.Out.Flush();
            run.Warn(reader.Info, isAlreadyShown: true);
            LookSettings.ResolveColor(look.Options, reader.Info.Schema, reader.Info.Path);
            Mark(folder, file);

            string previewPath = Path.Combine(folder, "preview.png"), picturePath = Path.Combine(folder, "picture.png");
            var picture = look.Options;
            run.Progress.Group = "preview";
            var preview = PreviewStep.Run(reader, new PreviewOptions { Points = PreviewPoints, Picture = picture }, run);
            OutputFile.Write(previewPath, preview.ToPng(look.IsPlain));
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
            var drawn = DrawOctree(cloudPath, picture, run);
            OutputFile.Write(picturePath, Png.Encode(drawn.ToImage(look.IsPlain)));
            run.Out.WriteLine("  picture  " + drawn.Describe());
            foreach (string assumption in drawn.Assumptions)
                run.Out.WriteLine("           " + assumption);
            // Before the GPU: a software one keeps its memory to the end.
            run.Progress.Group = PageGroup;
            var view = ViewCloud.OfSource(() => PointReaders.Open(files, source),
                target.IsKept ? string.Join(' ', files.Select(CloudReportPage.QuotedWithoutQuery)) : "", cloudPath, picture, run);
            run.Progress.Group = "gpu";
            var gpu = HeadlessGraphics.IsAvailable && picture.ColorAttribute == null
                ? DrawStep.RunOnGpu([cloudPath], picture, GpuPoints, run) : null;
            run.Progress.Group = null;
            if (gpu != null)
                OutputFile.Write(Path.Combine(folder, "gpu.png"), Png.Encode(gpu.ToImage(look.IsPlain)));
            run.Out.WriteLine("  gpu      " +
                (gpu != null ? gpu.Describe() + ", " + gpu.Device : "no picture: " + HeadlessGraphics.UnsupportedReason));
            run.Out.WriteLine();
            var page = new CloudReportPage
            {
                Name = files.Length > 1 ? reader.Info.ShownPath : NameOf(file),
                Command = command,
                Facts = facts,
                View = view,
                Preview = preview,
                Convert = convert,
                CloudPath = cloudPath,
                Drawn = drawn,
                Gpu = gpu,
                Stages = run.Progress.Finished.Skip(firstStage)
                    .Where(s => !s.Name.StartsWith(PageGroup + ":", StringComparison.Ordinal)).ToList(),
                Inputs = files,
                IsKept = target.IsKept,
                UpAxis = picture.UpAxis,
            };
            string pagePath = Path.Combine(folder, PageName);
            OutputFile.Write(pagePath, page.ToBytes());
            return new Report
            {
                PointCounts = PointCounts.Of(reader.Info, convert.PointsFound),
                Page = pagePath,
                Facts = facts,
                Preview = preview,
                Convert = convert,
                Picture = drawn,
                Gpu = gpu,
            };
        }

        /// <summary>As in a game, to compare the GPU's picture with.</summary>
        static DrawStep DrawOctree(string cloud, PictureOptions options, CliRun run)
        {
            FlightCloud.SetSize(options, cloud);
            return options.ColorAttribute != null ? DrawStep.RunConverted(cloud, options, GpuPoints, run)
                : StreamedPictureStep.Run([cloud], options, GpuPoints, run);
        }

        static string NameOf(string file) => Directory.Exists(file) || SourceFolder.IsIndex(SourcePath.NameOf(file))
            ? CloudName.Of(file) : SourcePath.NameOf(file);

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
