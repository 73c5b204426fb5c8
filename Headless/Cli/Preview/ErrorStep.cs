namespace FastPoints.Cli.Preview;

public sealed class ErrorStep
{
    public const string OursName = "ours, in waves", ScanName = "full scan", FloorName = "all points, one sample a pixel";
    static readonly (double Share, string Name)[] s_shares = [(1 / 15.0, "1/15"), (1 / 5.0, "1/5"), (1 / 2.0, "1/2"), (1, "all")];
    const int TimesDecoded = 5;

    readonly CliRun m_run;
    readonly CompareSamples m_comparison;
    readonly SampleMethods m_methods;
    readonly Dictionary<int, RgbaImage[]> m_viewsOfScan = [];

    ErrorStep(CliRun run, CompareSamples comparison, SampleMethods methods) =>
        (m_run, m_comparison, m_methods) = (run, comparison, methods);

    public List<ErrorCurve> Curves { get; } = [];
    public long PointsInCloud => m_comparison.PointCount;
    public RgbaImage[] FullViews => m_comparison.FullViews;
    internal ImageError Floor => m_comparison.Floor;
    public string? ReportPath { get; set; }
    public ErrorCurve? Ours => Curves.FirstOrDefault(c => c.Name == OursName);
    public ErrorWave? Last => Ours?.Waves.LastOrDefault();

    public static ErrorStep Run(Func<PointReader> open, PreviewOptions options, CliRun run)
    {
        using var reader = open();
        // Half the size of the picture: many views are drawn and compared.
        using var comparison = new CompareSamples(reader, options.Picture, (options.Picture.WidthPx + 1) / 2,
            (options.Picture.HeightPx + 1) / 2);
        var methods = new SampleMethods(open, options, run);
        var step = new ErrorStep(run, comparison, methods);
        run.Progress.Group = "error";
        run.RunSteps(comparison.Prepare(run.Progress));
        step.MeasureAll(reader);
        run.RunSteps(comparison.LookUp(run.Progress));
        run.Progress.Group = null;
        return step;
    }

    void MeasureAll(PointReader reader)
    {
        m_run.Progress.Begin(OursName);
        List<int> counts;
        var curve = new ErrorCurve(OursName,
            "the preview's own sample; each wave is the beginning of the next, or (LAZ, text, tiles) gives way to it");
        var scan = new ErrorCurve(ScanName,
            "one hashed point of each of N equal parts of the file, by a scan of all points: the reference");
        using (var ours = m_methods.Ours())
        {
            counts = ours.Waves.Select(w => w.Wave.Points).Distinct().ToList();
            // The full scan comes first: the views of the others are compared with its views.
            foreach (int count in counts)
                Measure(scan, () => m_methods.FullScan(count));
            Measure(curve, ours);
        }
        Curves.Add(curve);
        Curves.Add(scan);
        MeasureOthers(reader, counts);

        // The load of the machine changes within minutes: ours ran first, and is timed again among the others.
        m_run.Progress.Begin(OursName);
        using var again = m_methods.Ours();
        curve.KeepFaster(again.Waves.Select(w => w.Wave));
        m_run.Progress.End();
    }

    void MeasureOthers(PointReader reader, List<int> counts)
    {
        var nth = new ErrorCurve("every n-th point", "as far apart in the file as it takes");
        foreach (int count in counts)
            Measure(nth, () => m_methods.EveryNth(count));
        Curves.Add(nth);
        var first = new ErrorCurve("first N points", "the beginning of the file");
        foreach (int count in counts)
            Measure(first, () => m_methods.First(count));
        Curves.Add(first);
        if (reader.HasCheapRanges || reader.BlockCount < 2 || reader.PointCount == 0)
            return;
        var prefixes = new ErrorCurve("block prefixes", "N points from the prefixes of all blocks (LAZ chunks, octree nodes)");
        foreach (int count in counts)
            Measure(prefixes, () => m_methods.Prefixes(count / (double)reader.PointCount, count));
        Curves.Add(prefixes);
        var thinned = new ErrorCurve("thinned prefixes", "N points of " + TimesDecoded
            + " times as many from the prefixes of all blocks: first those that stand where no other does");
        foreach (int count in counts.Where(c => (long)c * TimesDecoded <= reader.PointCount))
            Measure(thinned, () => m_methods.ThinnedPrefixes(count, TimesDecoded));
        Curves.Add(thinned);
        var deeper = new ErrorCurve("deeper prefixes", "as many points as the last wave, evenly from the first "
            + string.Join(", ", s_shares.Select(s => s.Name)) + " of each block");
        foreach (var (share, _) in s_shares)
            Measure(deeper, () => m_methods.Prefixes(share, counts[^1]));
        Curves.Add(deeper);
    }

    void Measure(ErrorCurve curve, Func<MeasuredSample> take)
    {
        m_run.Progress.Begin(curve.Name);
        using var taken = take();
        Measure(curve, taken);
    }

    void Measure(ErrorCurve curve, MeasuredSample taken)
    {
        m_run.Progress.Begin("measure");
        foreach (var (wave, points) in taken.Waves)
        {
            var error = new SampleError();
            m_viewsOfScan.TryGetValue(wave.Points, out var sameCount);
            m_run.RunSteps(m_comparison.Measure(points, wave.Points, taken.Transform, sameCount, error));
            if (curve.Name == ScanName)
                m_viewsOfScan.TryAdd(wave.Points, error.Views);
            curve.Waves.Add(new ErrorWave(wave, error, Png.Encode(error.Views[2])));
            error.Views = null;
        }
        m_run.Progress.End();
    }

    public static IEnumerable<(string Key, double Value)> Values(ErrorWave wave)
    {
        var error = wave.Error;
        yield return ("points", wave.Wave.Points);
        yield return ("seconds", wave.Wave.Seconds);
        yield return ("bytesRead", wave.Wave.BytesRead);
        yield return ("share", error.Fraction);
        yield return ("rms", error.Distance.Rms);
        yield return ("hausdorff95", error.Distance.Ranked95);
        yield return ("hausdorff99", error.Distance.Ranked99);
        yield return ("uncoveredCells64", error.Cells.Uncovered64);
        yield return ("uncoveredCells128", error.Cells.Uncovered128);
        yield return ("uncoveredCells256", error.Cells.Uncovered256);
        yield return ("uncoveredCells512", error.Cells.Uncovered512);
        yield return ("shareVariation", error.Cells.Variation);
        yield return ("shareVariationByChance", error.Cells.VariationByChance);
        yield return ("bias", error.Cells.Bias);
        yield return ("biasByChance", error.Cells.BiasByChance);
        yield return ("psnrFull", error.Picture.Psnr);
        yield return ("ssimFull", error.Picture.Ssim);
        yield return ("flipFull", error.Picture.Flip);
        yield return ("uncoveredFull", error.Picture.Uncovered);
        yield return ("psnr", error.PictureAtSameCount?.Psnr ?? double.NaN);
        yield return ("ssim", error.PictureAtSameCount?.Ssim ?? double.NaN);
        yield return ("flip", error.PictureAtSameCount?.Flip ?? double.NaN);
        yield return ("uncovered", error.PictureAtSameCount?.Uncovered ?? double.NaN);
        yield return ("lookedUp", error.LookedUp);
        yield return ("found", error.Found);
    }

    public string ToCsv()
    {
        var lines = new List<string>();
        foreach (var curve in Curves)
            foreach (var wave in curve.Waves)
            {
                if (lines.Count == 0)
                    lines.Add("curve," + string.Join(',', Values(wave).Select(v => v.Key)));
                lines.Add(curve.Name.Replace(",", "") + ","
                    + string.Join(',', Values(wave).Select(v => v.Value.ToString("R", CultureInfo.InvariantCulture))));
            }
        if (lines.Count > 0)
            lines.Add(FloorName.Replace(",", "") + "," + string.Join(',', lines[0].Split(',').Skip(1).Select(key => key switch
            {
                "points" => PointsInCloud,
                "psnrFull" => Floor.Psnr,
                "ssimFull" => Floor.Ssim,
                "flipFull" => Floor.Flip,
                "uncoveredFull" => Floor.Uncovered,
                _ => double.NaN,
            }).Select(v => v.ToString("R", CultureInfo.InvariantCulture))));
        return string.Join('\n', lines) + "\n";
    }

    public TextTable ToTable()
    {
        var table = new TextTable("sample", "points", "seconds", "RMS", "95 %", "99 %", "bare /64", "/128", "/256", "/512",
            "variation (chance)", "bias (chance)", "PSNR dB", "SSIM", "FLIP", "bare pixels",
            "same N: SSIM", "FLIP", "bare pixels");
        foreach (var curve in Curves)
            foreach (var wave in curve.Waves)
            {
                var error = wave.Error;
                string AtSameCount(Func<ImageError, string> text) => error.PictureAtSameCount is { } same ? text(same) : "";
                table.Add(curve.Name, NumberFormat.Count(wave.Wave.Points), Short(wave.Wave.Seconds),
                    Percent(error.Distance.Rms), Percent(error.Distance.Ranked95), Percent(error.Distance.Ranked99),
                    Percent(error.Cells.Uncovered64), Percent(error.Cells.Uncovered128), Percent(error.Cells.Uncovered256),
                    Percent(error.Cells.Uncovered512),
                    Short(error.Cells.Variation) + " (" + Short(error.Cells.VariationByChance) + ")",
                    Short(error.Cells.Bias) + " (" + Short(error.Cells.BiasByChance) + ")",
                    Short(error.Picture.Psnr, "0.0"), Short(error.Picture.Ssim), Short(error.Picture.Flip, "0.0000"),
                    Percent(error.Picture.Uncovered), AtSameCount(e => Short(e.Ssim)),
                    AtSameCount(e => Short(e.Flip, "0.0000")),
                    AtSameCount(e => Percent(e.Uncovered)));
            }
        table.Add(FloorName, NumberFormat.Count(PointsInCloud), "", "", "", "", "", "", "", "", "", "", Short(Floor.Psnr, "0.0"),
            Short(Floor.Ssim), Short(Floor.Flip, "0.0000"), Percent(Floor.Uncovered), "", "", "");
        return table;
    }

    static string Percent(double value) => double.IsFinite(value)
        ? (100 * value).ToString(value < 0.01 ? "0.0000" : "0.00", CultureInfo.InvariantCulture) + "%"
        : "-";

    static string Short(double value, string format = "0.000") =>
        double.IsNaN(value) ? "-" : double.IsInfinity(value) ? "inf" : value.ToString(format, CultureInfo.InvariantCulture);

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteStartObject("error");
        if (Last is { } last)
            WriteValues(json, last);
        json.WriteStartObject("floor");
        json.WriteReal("psnr", Floor.Psnr);
        json.WriteReal("ssim", Floor.Ssim);
        json.WriteReal("flip", Floor.Flip);
        json.WriteReal("uncovered", Floor.Uncovered);
        json.WriteEndObject();
        json.WriteObjects("curves", Curves, curve =>
        {
            json.WriteString("name", curve.Name);
            json.WriteObjects("waves", curve.Waves, wave => WriteValues(json, wave));
        });
        json.WriteEndObject();
        json.WriteString("report", ReportPath);
    }

    static void WriteValues(Utf8JsonWriter json, ErrorWave wave)
    {
        foreach (var (key, value) in Values(wave))
            json.WriteReal(key, value);
    }
}
