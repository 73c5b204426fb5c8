namespace FastPoints.Cli.Convert;

/// <summary>Error beside run time: one cloud built by each sampler and with several spacings, the spacing of each level
/// measured, and fixed views drawn under several budgets against a picture of all points.</summary>
public sealed class SamplerReport(PointReader reader, string folder, ConvertSettings settings, CliRun run)
{
    static readonly (Sampler Sampler, int CellsLog2, int MemoryMiB)[] s_settings =
    [
        (Sampler.Random, 7, 0), (Sampler.Poisson, 6, 0), (Sampler.Poisson, 7, 0),
        (Sampler.Poisson, 8, 0), (Sampler.Average, 7, 0), (Sampler.Poisson, 7, 64),
    ];
    static readonly long[] s_budgets = [250_000, 500_000, 1_000_000, 2_000_000, 5_000_000];
    const double CloseUp = 0.2;

    sealed record Built(string Name, double Seconds, double BytesPerPoint, List<LevelQuality> Levels, List<Drawn> Pictures);
    sealed record Drawn(string View, long Budget, long Points, double Seconds, ImageError Error);
    sealed record View(string Name, PictureOptions Options, RgbaImage Reference);

    public void Write()
    {
        OutputFile.MakeFolder(folder);
        var views = DrawReferences();
        var built = s_settings.Select(s => Build(s.Sampler, s.CellsLog2, s.MemoryMiB, views)).ToList();
        WriteLevels(built);
        WritePictures(built);
        WritePage(built, views);
    }

    List<View> DrawReferences()
    {
        var standard = new DrawCloud(reader, new PictureOptions { View = ViewDirection.Iso });
        run.RunSteps(standard.Run(run.Progress));
        var close = standard.Plan.Camera;
        var center = standard.Ranges.Robust.Center;
        close.EyeGeo += close.Forward * ((1 - CloseUp) * math.dot(center - close.EyeGeo, close.Forward));
        var options = new PictureOptions { Camera = standard.Plan.Camera, Color = standard.Plan.Mode };
        var closeOptions = new PictureOptions { Camera = close, Color = standard.Plan.Mode };
        var closer = new DrawCloud(reader, closeOptions);
        run.RunSteps(closer.Run(run.Progress));
        return [new View("iso", options, standard.Image), new View("close", closeOptions, closer.Image)];
    }

    Built Build(Sampler sampler, int cellsLog2, int memoryMiB, List<View> views)
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
            var pictures = new List<Drawn>();
            foreach (var view in views)
            {
                foreach (long budget in s_budgets)
                {
                    var drawn = DrawStep.RunStored(target, view.Options, budget, run);
                    pictures.Add(new Drawn(view.Name, budget, drawn.Points, drawn.Seconds,
                        ImageError.Compare(drawn.Image, view.Reference, view.Options.Background)));
                }
            }
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

    static string Decibels(Drawn drawn) =>
        double.IsPositiveInfinity(drawn.Error.Psnr) ? "the same" : Human.Value(Math.Round(drawn.Error.Psnr, 2));

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
        var csv = new StringBuilder("setting,buildSeconds,bytesPerPoint,view,budget,points,drawSeconds,psnr,ssim,uncovered\n");
        foreach (var b in built)
            foreach (var p in b.Pictures)
                csv.Append('"').Append(b.Name).Append("\",")
                    .AppendJoin(',', Number(b.Seconds), Number(b.BytesPerPoint), p.View, p.Budget,
                    p.Points, Number(p.Seconds), Number(p.Error.Psnr), Number(p.Error.Ssim),
                    Number(p.Error.Uncovered)).Append('\n');
        Save("pictures.csv", csv.ToString());
    }

    void WritePage(List<Built> built, List<View> views)
    {
        var page = new ReportPage("Samplers: " + Path.GetFileName(reader.Info.Path));
        page.Paragraph("Built by each sampler and with several spacings (a node's edge by the number given); drawn "
            + "under budgets of points, against a picture of all points. Errors are of what is drawn, times "
            + "of this machine and run.");
        var times = new TextTable("setting", "build, s", "bytes a point", "PSNR iso 1 M, dB", "PSNR close 1 M, dB");
        foreach (var b in built)
            times.Add(b.Name, Human.Value(Math.Round(b.Seconds, 2)), Human.Value(Math.Round(b.BytesPerPoint, 2)),
                Decibels(At(b, "iso")), Decibels(At(b, "close")));
        page.Table(times);
        foreach (var view in views)
        {
            page.Heading("View: " + view.Name);
            Chart(page, "PSNR", "dB", built, view.Name, e => e.Psnr);
            Chart(page, "SSIM", "SSIM", built, view.Name, e => e.Ssim);
            Chart(page, "Uncovered pixels", "%", built, view.Name, e => 100 * e.Uncovered);
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
        foreach (var view in views)
        {
            var chart = new LineChart("PSNR under 1 M points by build time, view " + view.Name, "seconds", "dB");
            foreach (var b in built)
                chart.Add(b.Name, [(b.Seconds, At(b, view.Name).Error.Psnr)]);
            Add(page, "time-" + view.Name, chart);
        }
        OutputFile.Write(Path.Combine(folder, "report.html"), page.ToBytes());
    }

    static Drawn At(Built built, string view) => built.Pictures.First(p => p.View == view && p.Budget == 1_000_000);

    void Chart(ReportPage page, string name, string unit, List<Built> built, string view, Func<ImageError, double> of)
    {
        var chart = new LineChart(name + ", view " + view, "points", unit) { LogX = true };
        foreach (var b in built)
            chart.Add(b.Name, b.Pictures.Where(p => p.View == view).Select(p => ((double)p.Points, of(p.Error))));
        Add(page, name.Split(' ')[0].ToLowerInvariant() + "-" + view, chart);
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
