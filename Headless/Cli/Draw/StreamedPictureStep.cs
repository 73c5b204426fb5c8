namespace FastPoints.Cli.Draw;

public static class StreamedPictureStep
{
    const long PoolBytes = 2L << 30;
    const int BankBytes = 64 << 20;
    const int MinIdleFrames = 3;

    public static DrawStep Run(IReadOnlyList<string> clouds, PictureOptions options, long budget, CliRun run)
    {
        double begin = run.Seconds;
        using var stream = new StreamContext(new MemoryNodePool(PoolBytes, BankBytes));
        stream.SetClipBoxes(options.ClipBoxes);
        stream.Settings.Selection.PointBudget = budget > 0 ? budget : DrawConvertedCloud.DefaultBudget;
        stream.Settings.MaxUploadBytesPerFrame = BankBytes;
        stream.Settings.PrefetchFrames = 0;
        using var picture = new StreamedPicture(options);
        run.Progress.Begin("select");
        var bounds = BoundsGeo.Empty;
        FlightCloud? first = null;
        List<double3> sample = [], extremes = [];
        var assumptions = new List<string>();
        foreach (string cloud in clouds)
        {
            var added = FlightCloud.Add(cloud, stream, options, run.Cancellation);
            var (plan, ranges, number) = added;
            first ??= added;
            picture.Add(new StreamedBlocks(stream, number, plan), plan.Mode);
            assumptions.AddRange(plan.Assumptions.Where(a => !assumptions.Contains(a)));
            sample.AddRange(ranges.FramingSample);
            extremes.AddRange(ranges.ExtremePoints);
            if (!ranges.Robust.IsEmpty)
                bounds = bounds.IsEmpty ? ranges.Robust
                    : new BoundsGeo(math.min(bounds.Min, ranges.Robust.Min), math.max(bounds.Max, ranges.Robust.Max));
            if (clouds.Count == 1)
                options.Camera ??= plan.Camera;
        }
        if (bounds.IsEmpty)
            throw new PointCloudException(FailureCode.BadInput, clouds[0], -1, "no points to draw");
        var camera = options.Camera ?? CameraFraming.Frame(options, bounds, sample.ToArray(), extremes.ToArray(),
            new double3(1, 1, 1));

        run.Progress.Begin("stream");
        var stats = RunUntilSettled(stream, first!.Plan, camera, run);
        run.Progress.Begin("draw");
        var image = picture.Draw(camera);
        run.Progress.End();
        run.WarnOfFailures(stream);
        return new DrawStep
        {
            Points = stats.DrawnPoints,
            Nodes = stats.DrawnNodes,
            Seconds = run.Seconds - begin,
            Image = image,
            Legend = new Legend(first!.Plan.Mode, first.Ranges, camera, options, first.Crs),
            Assumptions = assumptions,
        };
    }

    static FrameStats RunUntilSettled(StreamContext stream, PicturePlan plan, in Camera camera, CliRun run)
    {
        using var views = new NativeArray<StreamView>(2, Allocator.Persistent);
        for (int idleFrames = 0; ;)
        {
            run.Cancellation.ThrowIfCancellationRequested();
            var stats = FrameStep.Run(stream, plan.ViewsFor(stream, camera, views));
            JobHandle.ScheduleBatchedJobs();
            bool isIdle = stats.ReadsInFlight + stats.RequestedNodes + stats.UploadedNodes + stats.MissingPages == 0;
            idleFrames = isIdle ? idleFrames + 1 : 0;
            if (stats.IsSettled || idleFrames > stream.Settings.FramesToRetry + MinIdleFrames)
                return stats;
            run.Progress.Report(stats.DrawnPoints / (double)Math.Max(1, stats.SelectedPoints), stats.DrawnPoints, 0);
            Thread.Yield();
        }
    }
}
