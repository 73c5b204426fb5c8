namespace FastPoints.Cli.Page;

/// <summary>The page of a flight: the clouds in 3D, the camera path to play, and the cost of each frame.</summary>
static class FlightPage
{
    const int FramesPerCamera = 6; // Frames between recorded cameras: ten cameras a second.
    const int ViewBytes = 4_500_000; // The picture takes some of a page's 8 MB.

    public static byte[] Make(string[] clouds, CameraPath path, FlightLog log, PictureOptions options, RgbaImage last,
        CliRun run)
    {
        run.Progress.Begin("page");
        var cameras = Enumerable.Range(0, (log.Count + FramesPerCamera - 1) / FramesPerCamera)
            .Select(i => path.CameraAt(i * FramesPerCamera)).ToList();
        var view = ViewCloud.OfFlight(clouds, options, cameras, FramesPerCamera, run);
        run.Progress.End();
        string name = string.Join(", ", clouds.Select(c => SourcePath.NameOf(Path.TrimEndingDirectorySeparator(c))));
        var page = new ReportPage("Flight over " + name,
            "Made by FastPoints " + CloudReportPage.Version + " on " + CloudReportPage.Today);
        page.Tiles(
        [
            ("frames", NumberFormat.Count(log.Count)),
            ("main thread, p99", Ms(log.MainThreadMs[1])),
            ("main thread, most", Ms(log.MainThreadMs[2])),
            ("points in the last frame", NumberFormat.Count(log.Last.DrawnPoints)),
            ("read", NumberFormat.Bytes(log.BytesRead)),
            ("pool, most", NumberFormat.Bytes(log.PoolBytesPeak)),
        ]);
        string json = view.ToJson(ViewBytes, out int shown);
        string note = ReportPage.Escape(NumberFormat.Count(shown, "point") + " stand for the clouds here: the upper levels of "
            + "octrees, previews of files. "
            + "The flight itself streamed others, as each frame needed them.");
        page.View(json, Png.Encode(last), name + ": " + NumberFormat.Count(shown, "point"), "Frames of the flight", note,
            view.Unit);
        page.Heading("Each frame");
        page.Charts([Chart("Points drawn", "points", log.Of(s => s.DrawnPoints)),
            Chart("Main thread", "milliseconds", log.MainThreadByFrame), Chart("Read", "MB", log.Of(s => s.ReadBytes / 1e6)),
            Chart("Copied to the pool", "MB", log.Of(s => s.UploadedBytes / 1e6))]);
        if (log.Popping != null)
            page.Charts([Chart("Popping: what the level of detail changes in each frame", "FLIP", log.PoppingByFrame)]);
        page.Facts([("machine", Machine.Describe()),
            ("memory", "at most " + NumberFormat.Bytes(PeakMemory.ResidentBytes) + " resident")]);
        return page.ToBytes();
    }

    static string Ms(double ms) => ms.ToString("0.00", CultureInfo.InvariantCulture) + " ms";

    static LineChart Chart(string title, string unit, IEnumerable<(double, double)> points)
    {
        var chart = new LineChart(title, "frame", unit) { PlotWidth = 310, HasMarkers = false, HasLegend = false };
        chart.Add(title, points);
        return chart;
    }
}
