namespace FastPoints.Cli.Preview;

public static class ErrorReport
{
    static readonly string[] s_viewNames = ["top", "front", "iso"];

    public static void Write(string folder, ErrorStep step, SourceInfo info)
    {
        OutputFile.MakeFolder(folder);
        OutputFile.Write(Path.Combine(folder, "errors.csv"), Encoding.UTF8.GetBytes(step.ToCsv()));
        var charts = Charts(step);
        foreach (var (name, chart) in charts)
            OutputFile.Write(Path.Combine(folder, name + ".svg"), chart.ToBytes());
        var pictures = new List<(byte[] Png, string Caption)>();
        for (int view = 0; view < s_viewNames.Length; view++)
        {
            byte[] png = Png.Encode(step.FullViews[view]);
            OutputFile.Write(Path.Combine(folder, "full-" + s_viewNames[view] + ".png"), png);
            pictures.Add((png, "all " + NumberFormat.Count(step.PointsInCloud, "point") + ", " + s_viewNames[view]));
        }
        string cloud = SourcePath.NameOf(Path.TrimEndingDirectorySeparator(info.Path));
        var page = new ReportPage("Preview of " + cloud + ": error against time");
        page.Facts([
            ("cloud", cloud + ", " + info.Format + ", " + NumberFormat.Count(step.PointsInCloud, "point") + ", "
                + NumberFormat.Bytes(info.FileBytes)),
            ("machine", Machine.Describe()),
            ("times", "from the open call, the file in the system's cache, the process warmed; the fastest of three runs, "
                + "but one run of what takes more than a second"),
        ]);
        page.Heading("Error over time");
        page.Paragraph("Each mark is a sample; a hollow one on the lower edge is an error of zero. Dashed: what chance "
            + "alone would give for as many points.");
        page.Charts(charts.Select(c => c.Chart));
        page.Heading("The same number of points, chosen differently");
        foreach (int points in step.Curves[0].Waves.Select(w => w.Wave.Points))
            page.Pictures(Pictures(step, points, folder));
        page.Heading("All points");
        page.Pictures(pictures);
        page.Heading("All figures");
        page.Table(step.ToTable());
        page.Heading("What is measured");
        page.Facts(step.Curves.Select(c => (c.Name, c.Description)));
        page.Facts(Definitions(step));
        step.ReportPath = Path.Combine(folder, "report.html");
        OutputFile.Write(step.ReportPath, page.ToBytes());
    }

    static IEnumerable<(byte[], string)> Pictures(ErrorStep step, int points, string folder)
    {
        foreach (var curve in step.Curves)
            foreach (var wave in curve.Waves.Where(w => w.Wave.Points == points).TakeLast(1))
            {
                string name = string.Concat(curve.Name.Where(c => char.IsAsciiLetter(c) || c == ' ')).Replace(' ', '-');
                OutputFile.Write(Path.Combine(folder, "iso-" + points + "-" + name + ".png"), wave.IsoPng);
                yield return (wave.IsoPng,
                    curve.Name + ": " + NumberFormat.Count(points, "point") + " in " + NumberFormat.Seconds(wave.Wave.Seconds));
            }
    }

    static List<(string Name, LineChart Chart)> Charts(ErrorStep step) =>
    [
        ("rms", Chart(step, "RMS distance to the sample", "share of the diagonal", true, w => w.Error.Distance.Rms)),
        ("hausdorff95", Chart(step, "95 % ranked Hausdorff distance", "share of the diagonal", true,
            w => w.Error.Distance.Ranked95)),
        ("hausdorff99", Chart(step, "99 % ranked Hausdorff distance", "share of the diagonal", true,
            w => w.Error.Distance.Ranked99)),
        ("uncovered64", Chart(step, "Bare cells (a 64th of the extent)", "share", true, w => w.Error.Cells.Uncovered64)),
        ("uncovered128", Chart(step, "Bare cells (a 128th)", "share", true, w => w.Error.Cells.Uncovered128)),
        ("uncovered256", Chart(step, "Bare cells (a 256th)", "share", true, w => w.Error.Cells.Uncovered256)),
        ("uncovered512", Chart(step, "Bare cells (a 512th)", "share", true, w => w.Error.Cells.Uncovered512)),
        ("variation", Chart(step, "Variation of the share sampled", "coefficient of variation", true,
            w => w.Error.Cells.Variation, w => w.Error.Cells.VariationByChance)),
        ("bias", Chart(step, "Largest deviation of a region's share", "relative", true,
            w => w.Error.Cells.Bias, w => w.Error.Cells.BiasByChance)),
        ("flip", PictureChart(step, "Three views against all points: FLIP", "FLIP", e => e.Flip)),
        ("psnr", PictureChart(step, "Three views against all points: PSNR", "dB", e => e.Psnr)),
        ("ssim", PictureChart(step, "Three views against all points: SSIM", "SSIM", e => e.Ssim)),
        ("pixels", PictureChart(step, "Three views: bare pixels", "share", e => e.Uncovered)),
    ];

    static LineChart PictureChart(ErrorStep step, string title, string unit, Func<ImageError, double> error)
    {
        var chart = Chart(step, title, unit, false, w => error(w.Error.Picture));
        double[] seconds = [.. step.Curves.SelectMany(c => c.Waves).Select(w => w.Wave.Seconds)];
        if (seconds.Length > 0)
            chart.Add(ErrorStep.FloorName, [(seconds.Min(), error(step.Floor)), (seconds.Max(), error(step.Floor))],
                isDashed: true);
        return chart;
    }

    static LineChart Chart(ErrorStep step, string title, string unit, bool isLog, Func<ErrorWave, double> error,
        Func<ErrorWave, double>? byChance = null)
    {
        var chart = new LineChart(title, "seconds from the open call", unit) { LogX = true, LogY = isLog };
        foreach (var curve in step.Curves)
            chart.Add(curve.Name, curve.Waves.Select(w => (w.Wave.Seconds, error(w))));
        if (byChance != null)
            chart.Add(step.Curves[0].Name.Split(',')[0] + ", by chance alone",
                step.Curves[0].Waves.Select(w => (w.Wave.Seconds, byChance(w))), isDashed: true);
        return chart;
    }

    static IEnumerable<(string, string)> Definitions(ErrorStep step)
    {
        yield return ("distances", "From points of the full cloud (a uniform choice of "
            + NumberFormat.Count(step.Last?.Error.Distance.Queries ?? 0) + ") to the nearest point of the sample, in units of "
            + "the diagonal of the robust bounds: root mean square, and the distances that 95 and 99 of 100 points do not "
            + "exceed. The symmetric distance takes the larger of both directions; from the sample to the cloud it is 0, "
            + "since a sample is a part of the cloud" + LookedUp(step));
        yield return ("empty cells", "Of the cells that the full cloud occupies, those with no point of the sample. Cells "
            + "are cubes of a 64th, a 128th, a 256th, a 512th of the longest edge of the robust bounds "
            + "(quantiles 0.5 % to 99.5 %, "
            + "widened by a tenth).");
        yield return ("variation", "Coefficient of variation of the share sampled, over cells of a 64th with at least 100 "
            + "points; beside it what a simple random sample of as many points would give.");
        yield return ("bias", "Largest relative deviation of the share sampled of a region (an eighth of the edge, with "
            + "at least a thousandth of the points) from that of all; beside it what chance would exceed in one sample of "
            + "two.");
        yield return ("views", "Top, front and iso, half the size of the picture, the same camera and colours for all, "
            + "sizes of points as each sample asks for; PSNR of the mean squared error, mean SSIM, mean FLIP (what an eye "
            + "sees of the difference, at 67 pixels per degree), mean share of the pixels left bare; against all points with 4 "
            + "times 4 samples a pixel, averaged in linear light, and against a full scan's sample of as many points. All points "
            + "with one sample a pixel are the floor: what is left is the picture's coarseness, not the sample's.");
    }

    static string LookedUp(ErrorStep step)
    {
        var errors = step.Curves.SelectMany(c => c.Waves).Select(w => w.Error).ToList();
        long lookedUp = errors.Sum(e => (long)e.LookedUp), found = errors.Sum(e => (long)e.Found);
        return " (" + NumberFormat.Count(found) + " of " + NumberFormat.Count(lookedUp)
            + " sampled points that were looked up are in it).";
    }
}
