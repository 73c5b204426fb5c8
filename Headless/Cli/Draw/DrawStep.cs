namespace FastPoints.Cli.Draw;

public sealed class DrawStep
{
    public required long Points { get; init; }
    public int? Nodes { get; init; }
    public required double Seconds { get; init; }
    public required RgbaImage Image { get; init; }
    public required Legend Legend { get; init; }
    public required IReadOnlyList<string> Assumptions { get; init; }
    public string Device { get; init; } = "cpu, " + Threads.InUse + (Threads.InUse == 1 ? " thread" : " threads");
    internal ImageError? Difference { get; private set; }

    /// <param name="budget">Points to draw at most; 0 for all.</param>
    public static DrawStep Run(PointReader reader, PictureOptions options, long budget, CliRun run)
    {
        double begin = run.Seconds;
        LookSettings.ResolveColor(options, reader.Info.Schema, reader.Info.Path);
        var draw = new DrawCloud(reader, options, budget);
        run.RunSteps(draw.Run(run.Progress));
        run.Warn(reader.Info);
        return new DrawStep
        {
            Points = draw.PointsDrawn,
            Seconds = run.Seconds - begin,
            Image = draw.Image,
            Legend = Legend.Of(draw.Plan, options, reader.Info.Crs.ToCloudCrs()),
            Assumptions = draw.Plan.Assumptions,
        };
    }

    public static DrawStep RunConverted(string path, PictureOptions options, long budget, CliRun run)
    {
        double begin = run.Seconds;
        using var folder = CloudFolder.Open(path);
        LookSettings.ResolveColor(options, folder.Manifest.Attributes, path);
        var draw = new DrawConvertedCloud(folder, options, budget);
        run.RunSteps(draw.Run(run.Progress));
        if (draw.Refused != null)
            run.Warn(draw.Refused.ToString());
        return new DrawStep
        {
            Points = draw.PointsDrawn,
            Nodes = draw.NodesDrawn,
            Seconds = run.Seconds - begin,
            Image = draw.Image,
            Legend = Legend.Of(draw.Plan, options, folder.Manifest.Crs),
            Assumptions = draw.Plan.Assumptions,
        };
    }

    /// <summary>Streamed to a GPU as in a game, and drawn there when all is resident.</summary>
    /// <param name="budget">Points to draw at most; 0 for the default.</param>
    public static DrawStep RunOnGpu(string[] paths, PictureOptions options, long budget, CliRun run)
    {
        const int BankBytes = 16 << 20;
        double begin = run.Seconds;
        run.Progress.Begin("stream");
        var shaders = new GpuShaders();
        using var stream = new StreamContext(shaders.CreatePool(1L << 30, BankBytes));
        stream.SetClipBoxes(options.ClipBoxes);
        stream.Settings.Selection.PointBudget = budget > 0 ? budget : DrawConvertedCloud.DefaultBudget;
        using var renderer = new GpuFlightRenderer(shaders, stream, options);
        var assumptions = new List<string>();
        Camera? camera = options.Camera;
        Legend? legend = null;
        foreach (string path in paths)
        {
            var added = FlightCloud.Add(path, stream, options, run.Cancellation);
            var (plan, _, number) = added;
            legend ??= Legend.Of(plan, options, added.Crs);
            renderer.Add(number, plan);
            assumptions.AddRange(plan.Assumptions);
            camera ??= plan.Camera;
        }
        var stats = Settle(stream, renderer, camera!.Value, run);
        run.Progress.Begin("draw");
        var image = renderer.Draw(camera.Value);
        run.Progress.End();
        run.WarnOfFailures(stream);
        return new DrawStep
        {
            Points = stats.DrawnPoints,
            Nodes = stats.DrawnNodes,
            Seconds = run.Seconds - begin,
            Image = image,
            Legend = legend!,
            Assumptions = assumptions,
            Device = "gpu, " + UnityEngine.SystemInfo.graphicsDeviceName,
        };
    }

    static FrameStats Settle(StreamContext stream, GpuFlightRenderer renderer, Camera camera, CliRun run)
    {
        using var views = new NativeArray<StreamView>(2, Allocator.Persistent);
        while (true)
        {
            run.Cancellation.ThrowIfCancellationRequested();
            var stats = FrameStep.Run(stream, renderer.Plan!.ViewsFor(stream, camera, views));
            JobHandle.ScheduleBatchedJobs();
            renderer.EndFrame();
            run.Progress.Report(stats.DrawnPoints / (double)Math.Max(1, stats.SelectedPoints), stats.DrawnPoints, 0);
            if (stats.IsSettled)
                return stats;
            Thread.Yield();
        }
    }

    public RgbaImage ToImage(bool isPlain) => isPlain ? Image : Legend.CopyWithLegend(Image);

    public string Describe() => NumberFormat.Count(Points, "point")
        + (Nodes is { } nodes ? " of " + NumberFormat.Count(nodes, "node") : "") + " in " + NumberFormat.Seconds(Seconds);

    public void Compare(RgbaImage image, RgbaImage reference, uint background) =>
        Difference = ImageError.Compare(image, reference, background);

    public string? DescribeDifference() => Difference is not { } error ? null
        : "PSNR " + NumberFormat.Value(error.Psnr) + " dB, SSIM " + NumberFormat.Value(error.Ssim)
            + ", FLIP " + NumberFormat.Value(error.Flip) + " (" + Math.Round(FlipMap.DefaultPixelsPerDegree)
            + " pixels per degree), uncovered " + NumberFormat.Value(100 * error.Uncovered) + "%";

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteInteger("points", Points);
        if (Nodes is { } nodes)
            json.WriteInteger("nodes", nodes);
        else
            json.WriteNull("nodes");
        json.WriteString("device", Device);
        if (Difference is not { } error)
            return;
        json.WriteReal("psnr", error.Psnr);
        json.WriteReal("ssim", error.Ssim);
        json.WriteReal("flip", error.Flip);
        json.WriteReal("uncovered", error.Uncovered);
    }
}
