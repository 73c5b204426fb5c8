namespace FastPoints.Cli.Stability;

static class StreamStage
{
    const int MaxFrames = 100_000_000; // A read that never ends is a failure, not a hang.

    /// <returns>Share of the reference's pixels that the picture leaves uncovered.</returns>
    public static double Run(string target, PictureOptions options, RgbaImage reference, List<string> problems)
    {
        using var stream = new StreamContext(new MemoryNodePool(256 << 20));
        using var picture = new StreamedPicture(options);
        var (plan, _, cloud) = FlightCloud.Add(target, stream, options, CancellationToken.None);
        picture.Add(new StreamedBlocks(stream, cloud, plan), plan.Mode);
        stream.Settings.Selection = new LodSettings { PointBudget = long.MaxValue, Hysteresis = 1 };
        long points = ((FolderSource)stream.Clouds[cloud].Source).Folder.Manifest.Points;
        var all = Settle(stream, StreamView.Everything(1), problems);
        if (all.DrawnPoints != points)
            problems.Add("stream: " + all.DrawnPoints + " points of " + points);
        stream.Settings.Selection = LodSettings.Default;
        Settle(stream, plan.Camera.ToStreamView(options.WidthPx, options.HeightPx), problems);
        while (stream.TryTakeFailure(out var failure))
            problems.Add("stream: " + failure);
        return ImageError.Compare(picture.Draw(plan.Camera), reference, options.Background).Uncovered;
    }

    public static FrameStats Settle(StreamContext stream, StreamView view, List<string> problems, Action? endFrame = null)
    {
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = view };
        for (int frame = 0; frame < MaxFrames; frame++)
        {
            var stats = FrameStep.Run(stream, views);
            endFrame?.Invoke();
            if (stats.IsSettled)
                return stats;
            Thread.Yield();
        }
        problems.Add("stream: does not come to rest");
        return default;
    }
}
