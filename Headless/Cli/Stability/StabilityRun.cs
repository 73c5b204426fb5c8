namespace FastPoints.Cli.Stability;

public sealed class StabilityRun
{
    const int PictureWidthPx = 320, PictureHeightPx = 200;

    /// <param name="Error">Read and build: points too many or too few. Preview and draw: share of the pixels of a picture
    /// of all points that are left uncovered. Card: share of the covered pixels that differ from the software
    /// rasteriser's.</param>
    public sealed record StageResult(string Stage, string Outcome, double Error, double Seconds, long ResidentBytes);

    readonly StabilityCase m_case;
    readonly string m_folder;
    readonly Sampler m_sampler;

    StabilityRun(StabilityCase stabilityCase, string folder, Sampler sampler) =>
        (m_case, m_folder, m_sampler) = (stabilityCase, folder, sampler);

    public string Name => m_case.Name;
    public List<StageResult> Stages { get; } = [];

    /// <summary>Failed expectations; empty if the case passes.</summary>
    public List<string> Problems { get; } = [];

    public static StabilityRun Run(StabilityCase stabilityCase, int points, string scratch, Sampler sampler)
    {
        string folder = Path.Combine(scratch, "case");
        Directory.CreateDirectory(folder);
        try
        {
            var run = new StabilityRun(stabilityCase, folder, sampler);
            run.RunStages(stabilityCase.Make(folder, points));
            return run;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    void RunStages(StabilityInput input)
    {
        string target = m_case.Target?.Invoke(m_folder) ?? Path.Combine(m_folder, "cloud" + StoreFormat.FolderExtension);
        RgbaImage? reference = null;
        var options = new PictureOptions { WidthPx = PictureWidthPx, HeightPx = PictureHeightPx, View = ViewDirection.Iso };
        RunStage("read", () =>
        {
            using var reader = PointReaders.Open(input.Files);
            var scan = new SummariseCloud(reader);
            JobCoroutine.RunToEnd(scan.Run(null));
            var all = new DrawCloud(reader, options);
            JobCoroutine.RunToEnd(all.Run(null));
            reference = all.Image;
            options.Camera = all.Plan.Camera;
            options.Color = all.Plan.Mode;
            return Math.Abs(scan.Summary.Points - input.Points) + Math.Abs(scan.Summary.NonFiniteCount - input.LeftOut);
        });
        RunStage("preview", () =>
        {
            using var reader = PointReaders.Open(input.Files);
            using var preview = new PreviewPicture(reader, new PreviewOptions { Points = 50000, Picture = options });
            JobCoroutine.RunToEnd(preview.Run(null));
            return ImageError.Compare(preview.Image, reference!, options.Background).Uncovered;
        });
        RunStage("build", () => Build(input, target));
        if (m_case.MustSucceed)
        {
            RunStage("draw", () =>
            {
                using var folder = CloudFolder.Open(target);
                var draw = new DrawConvertedCloud(folder, options);
                JobCoroutine.RunToEnd(draw.Run(null));
                return ImageError.Compare(draw.Image, reference!, options.Background).Uncovered;
            });
            RunStage("stream", () => StreamStage.Run(target, options, reference!, Problems));
            if (HeadlessGraphics.IsAvailable)
                RunStage("card", () => GpuStage.Run(target, options, Problems));
        }
    }

    double Build(StabilityInput input, string target)
    {
        using var reader = PointReaders.Open(input.Files);
        ConvertResult? made = null;
        var settings = new ConvertSettings { Sampler = m_sampler };
        using var work = new CoroutineStack(ConvertCloud.Run([reader], target, settings, r => made = r, null));
        if (m_case.IsBuiltTwice)
        {
            using var other = PointReaders.Open(input.Files);
            Step(work, 5);
            try
            {
                JobCoroutine.RunToEnd(ConvertCloud.Run([other], target, settings, r => { }, null));
                Problems.Add("a second build of the same target was let in");
            }
            catch (PointCloudException)
            {
                // Expected.
            }
        }
        Step(work, int.MaxValue);
        var verified = new VerifyResult();
        JobCoroutine.RunToEnd(VerifyCloud.Run(target, [reader], verified, null));
        Problems.AddRange(verified.Problems);
        if (m_sampler != Sampler.Random && verified.Ok)
        {
            var spacings = new List<LevelSpacing>();
            JobCoroutine.RunToEnd(MeasureSpacing.Run(target, spacings));
            foreach (var (near, level) in spacings.Zip(verified.Levels))
                if (near.MinDistance < 0.99 * level.Spacing)
                    Problems.Add(string.Format(CultureInfo.InvariantCulture, "points at {0} where the spacing is {1}",
                        near.MinDistance, level.Spacing));
        }
        return Math.Abs(made!.Manifest.Points + input.LeftOut - input.Points)
            + Math.Abs(made.Manifest.PointsLeftOut - input.LeftOut);
    }

    static void Step(CoroutineStack work, int steps)
    {
        for (int i = 0; i < steps && work.MoveNext(); i++)
        {
            work.Current.Complete();
            // A step that awaits no job may wait for another thread.
            Thread.Yield();
        }
    }

    void RunStage(string stage, Func<double> run)
    {
        long begin = Stopwatch.GetTimestamp();
        string outcome = "ok";
        double error = 0;
        try
        {
            error = run();
            if (stage is "read" or "build" && error != 0)
                Problems.Add(stage + ": " + error + " points too many or too few");
            if (!m_case.MustSucceed && stage == "build")
                Problems.Add("build: wanted an error, got a cloud");
        }
        catch (PointCloudException e)
        {
            outcome = "error: " + e.Code;
            if (m_case.MustSucceed)
                Problems.Add(stage + ": " + e.Message);
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            outcome = e.GetType().Name;
            Problems.Add(stage + ": " + e);
        }
        using var process = Process.GetCurrentProcess();
        Stages.Add(new StageResult(stage, outcome, error, Stopwatch.GetElapsedTime(begin).TotalSeconds, process.WorkingSet64));
    }
}
