namespace FastPoints.Cli.Convert;

/// <summary>Error beside run time: one cloud built by each sampler and with several spacings, the spacing of each level
/// measured, and fixed views drawn under several budgets against a smooth picture of all points.</summary>
public sealed class SamplerReport(PointReader reader, string folder, ConvertSettings settings, CliRun run)
{
    static readonly (Sampler Sampler, int CellsLog2, int MemoryMiB)[] s_settings =
    [
        (Sampler.Random, 7, 0), (Sampler.Poisson, 6, 0), (Sampler.Poisson, 7, 0),
        (Sampler.Poisson, 8, 0), (Sampler.Average, 7, 0), (Sampler.Poisson, 7, 64),
    ];
    static readonly long[] s_budgets = [250_000, 500_000, 1_000_000, 2_000_000, 5_000_000];
    const double CloseUp = 0.2;
    const int PointsToFrame = 500_000;
    const long AllPoints = 1L << 40;
    const string FloorName = "all points, one sample a pixel";

    sealed record Built(string Name, double Seconds, double BytesPerPoint, List<LevelQuality> Levels, List<Drawn> Pictures);
    sealed record Drawn(string View, long Budget, long Points, double Seconds, ImageError Error);
    sealed record View(string Name, Func<PictureOptions> Options, RgbaImage Reference, Drawn Floor);

    List<View> m_views = [];

    public int WidthPx { get; init; } = 1280;
    public int HeightPx { get; init; } = 720;

    public void Write()
    {
        OutputFile.MakeFolder(folder);
        var built = s_settings.Select(s => Build(s.Sampler, s.CellsLog2, s.MemoryMiB)).ToList();
        WriteLevels(built);
        WritePictures(built);
        WritePage(built);
    }

    /// <summary>As a game draws: sizes by the distance between points.</summary>
    List<View> DrawReferences(string cloud)
    {
        var standard = new DrawCloud(reader, new PictureOptions
        {
            WidthPx = WidthPx,
            HeightPx = HeightPx,
            View = ViewDirection.Iso,
        }, PointsToFrame);
        run.RunSteps(standard.Run(run.Progress));
        var (whole, close) = (standard.Plan.Camera, standard.Plan.Camera);
        var center = standard.Ranges.Robust.Center;
        close.EyeGeo += close.Forward * ((1 - CloseUp) * math.dot(center - close.EyeGeo, close.Forward));
        return [DrawReference(cloud, "iso", whole, standard.Plan.Mode), DrawReference(cloud, "close", close, standard.Plan.Mode)];
    }

    View DrawReference(string cloud, string name, Picture.Camera camera, ColorMode mode)
    {
        PictureOptions Options() => new()
        {
            WidthPx = WidthPx,
            HeightPx = HeightPx,
            Camera = camera,
            Color = mode,
            SizeInWorld = PointSize.Adaptive(),
        };
        var smooth = Options();
        smooth.SamplesPerEdge = PictureCanvas.MaxSamplesPerEdge;
        var reference = StreamedPictureStep.Run([cloud], smooth, AllPoints, run).Image;
        return new View(name, Options, reference, Draw(cloud, name, Options(), AllPoints, reference));
    }

    Drawn Draw(string cloud, string view, PictureOptions options, long budget, RgbaImage reference)
    {
        var drawn = StreamedPictureStep.Run([cloud], options, budget, run);
        return new Drawn(view, budget, drawn.Points, drawn.Seconds,
            ImageError.Compare(drawn.Image, reference, options.Background));
    }

    Built Build(Sampler sampler, int cellsLog2, int memoryMiB)
    {
        string name = sampler.ToString().ToLowerInvariant() + ", edge/" + (1 << cellsLog2)
            + (memoryMiB > 0 ? ", in " + memoryMiB + " MiB" : "");
        string target = Path.Combine(folder, "report" + StoreFormat.FolderExtension);
        var step = ConvertStep.Run([reader], target, new ConvertSettings
        {
            Sampler = sampler,
            CellsLog2 = cellsLog2,
            Attributes = settings.Attributes,
            MemoryBytes = memoryMiB > 0 ? (long)memoryMiB << 20 : settings.MemoryBytes,
        }, run);
        try
        {
            var levels = LevelQuality.Measure(target, run);
            if (m_views.Count == 0)
                m_views = DrawReferences(target);
            var pictures = m_views.SelectMany(v => s_budgets.Select(budget =>
                Draw(target, v.Name, v.Options(), budget, v.Reference))).ToList();
            run.Out.WriteLine(name + ": " + step.Describe());
            return new Built(name, step.Seconds,
                step.Result.BytesOnDisk / (double)Math.Max(1, step.Result.Manifest.Points), levels, pictures);
        }
        finally
        {
            Directory.Delete(target, recursive: true);
        }
    }

    static string Number(double value) => double.IsFinite(value) ? value.ToString("R", CultureInfo.InvariantCulture) : "";

    static string Flip(Drawn drawn) => NumberFormat.Value(Math.Round(drawn.Error.Flip, 4));

    static string Decibels(Drawn drawn) =>
        double.IsPositiveInfinity(drawn.Error.Psnr) ? "the same" : NumberFormat.Value(Math.Round(drawn.Error.Psnr, 2));

    void WriteLevels(List<Built> built)
    {
        var csv = new StringBuilder("setting,level,nodes,sampledPoints,spacing,minDistanceBySpacing,shareNearAcrossChunks,"
            + "coefficientOfVariation\n");
        foreach (var b in built)
            foreach (var l in b.Levels)
                csv.Append('"').Append(b.Name).Append("\",").AppendJoin(',', l.Level, l.Nodes, l.Points, Number(l.Spacing),
                    Number(l.MinDistance / l.Spacing), Number(l.ShareNearAcrossChunks), Number(l.Variation)).Append('\n');
        Save("levels.csv", csv.ToString());
    }

    void WritePictures(List<Built> built)
    {
        var csv = new StringBuilder("setting,buildSeconds,bytesPerPoint,view,budget,points,drawSeconds,psnr,ssim,flip,"
            + "uncovered\n");
        void Write(string setting, string seconds, string bytes, Drawn p) =>
            csv.Append('"').Append(setting).Append("\",").AppendJoin(',', seconds, bytes, p.View, p.Budget, p.Points,
                Number(p.Seconds), Number(p.Error.Psnr), Number(p.Error.Ssim), Number(p.Error.Flip),
                Number(p.Error.Uncovered)).Append('\n');
        foreach (var view in m_views)
            Write(FloorName, "", "", view.Floor);
        foreach (var b in built)
            foreach (var p in b.Pictures)
                Write(b.Name, Number(b.Seconds), Number(b.BytesPerPoint), p);
        Save("pictures.csv", csv.ToString());
    }

    void WritePage(List<Built> built)
    {
        var page = new ReportPage("Samplers: " + SourcePath.NameOf(reader.Info.Path));
        page.Paragraph("Built by each sampler and with several spacings (a node's edge by the number given); drawn "
            + "under budgets of points with adaptive sizes, against a picture of all points with 4 times 4 samples a pixel, "
            + "averaged in linear light. FLIP is what an eye sees of the difference, at 67 pixels per degree. All points with "
            + "one sample a pixel are the floor. Errors are of what is drawn, times of this machine and run.");
        var times = new TextTable("setting", "build, s", "bytes a point", "FLIP iso 1 M", "FLIP close 1 M", "PSNR iso 1 M, dB",
            "PSNR close 1 M, dB");
        foreach (var b in built)
            times.Add(b.Name, NumberFormat.Value(Math.Round(b.Seconds, 2)), NumberFormat.Value(Math.Round(b.BytesPerPoint, 2)),
                Flip(At(b, "iso")), Flip(At(b, "close")), Decibels(At(b, "iso")), Decibels(At(b, "close")));
        times.Add(FloorName, "", "", Flip(m_views[0].Floor), Flip(m_views[1].Floor), Decibels(m_views[0].Floor),
            Decibels(m_views[1].Floor));
        page.Table(times);
        foreach (var view in m_views)
        {
            page.Heading("View: " + view.Name);
            Chart(page, "FLIP", "FLIP", built, view, e => e.Flip);
            Chart(page, "PSNR", "dB", built, view, e => e.Psnr);
            Chart(page, "SSIM", "SSIM", built, view, e => e.Ssim);
            Chart(page, "Uncovered pixels", "%", built, view, e => 100 * e.Uncovered);
            page.Picture(Png.Encode(view.Reference), "all points");
        }
        page.Heading("Evenness");
        var variation = new LineChart("Coefficient of variation of the distance to the nearest neighbour", "level", "variation");
        var near = new LineChart("Smallest distance inside chunks by spacing", "level", "spacings");
        foreach (var b in built)
        {
            variation.Add(b.Name, b.Levels.Select(l => ((double)l.Level, l.Variation)));
            near.Add(b.Name, b.Levels.Select(l => ((double)l.Level, l.MinDistance / l.Spacing)));
        }
        Add(page, "variation", variation);
        Add(page, "distance", near);
        page.Heading("Error beside build time");
        foreach (var view in m_views)
        {
            var chart = new LineChart("FLIP under 1 M points by build time, view " + view.Name, "seconds", "FLIP");
            foreach (var b in built)
                chart.Add(b.Name, [(b.Seconds, At(b, view.Name).Error.Flip)]);
            Add(page, "time-" + view.Name, chart);
        }
        OutputFile.Write(Path.Combine(folder, "report.html"), page.ToBytes());
    }

    static Drawn At(Built built, string view) => built.Pictures.First(p => p.View == view && p.Budget == 1_000_000);

    void Chart(ReportPage page, string name, string unit, List<Built> built, View view, Func<ImageError, double> of)
    {
        var chart = new LineChart(name + ", view " + view.Name, "points", unit) { LogX = true };
        var drawn = built.Select(b => (b.Name, Pictures: b.Pictures.Where(p => p.View == view.Name).ToList())).ToList();
        foreach (var (setting, pictures) in drawn)
            chart.Add(setting, pictures.Select(p => ((double)p.Points, of(p.Error))));
        double[] points = [.. drawn.SelectMany(d => d.Pictures).Select(p => (double)p.Points)];
        chart.Add(FloorName, [(points.Min(), of(view.Floor.Error)), (points.Max(), of(view.Floor.Error))], isDashed: true);
        Add(page, name.Split(' ')[0].ToLowerInvariant() + "-" + view.Name, chart);
    }

    void Add(ReportPage page, string file, LineChart chart)
    {
        if (chart.IsEmpty)
        {
            page.Paragraph(chart.Title + ": all pictures are the same as that of all points, so that there is nothing to chart.");
            return;
        }
        OutputFile.Write(Path.Combine(folder, file + ".svg"), chart.ToBytes());
        page.Chart(chart);
    }

    void Save(string name, string text) => OutputFile.Write(Path.Combine(folder, name), Encoding.UTF8.GetBytes(text));
}
