namespace FastPoints.Cli.Preview;

public sealed class PreviewStep
{
    public required int Points { get; init; }
    public required double Fraction { get; init; }
    public required long BytesRead { get; init; }
    public required string Method { get; init; }
    public required IReadOnlyList<PreviewSample.Wave> Waves { get; init; }
    public required JobDurations Slices { get; set; }
    public required double Seconds { get; init; }
    public required RgbaImage Image { get; init; }
    public required Legend Legend { get; init; }
    public required Camera Camera { get; init; }
    public required ColorMode Mode { get; init; }
    public required IReadOnlyList<string> Assumptions { get; init; }

    public ErrorStep? Error { get; set; }

    public static PreviewStep Run(PointReader reader, PreviewOptions options, CliRun run)
    {
        double begin = run.Seconds;
        LookSettings.ResolveColor(options.Picture, reader.Info.Schema, reader.Info.Path);
        using var preview = new PreviewPicture(reader, options);
        var slices = JobDurations.Measure(() => run.RunSteps(preview.Run(run.Progress)));
        run.Warn(reader.Info);
        return new PreviewStep
        {
            Points = preview.Sample.Count,
            Fraction = preview.Sample.Fraction,
            BytesRead = preview.Sample.BytesRead,
            Method = preview.Sample.Method,
            Waves = preview.Waves,
            Slices = slices,
            Seconds = run.Seconds - begin,
            Image = preview.Image,
            Legend = Legend.Of(preview.Plan, options.Picture, reader.Info.Crs.ToCloudCrs()),
            Camera = preview.Plan.Camera,
            Mode = preview.Plan.Mode,
            Assumptions = preview.Plan.Assumptions,
        };
    }

    public byte[] ToPng(bool isPlain) => Png.Encode(isPlain ? Image : Legend.CopyWithLegend(Image));

    public string Describe() => NumberFormat.Count(Points, "point") + ", " + NumberFormat.Value(100 * Fraction) + "% of the cloud"
        + ", from " + NumberFormat.Bytes(BytesRead) + " read in " + NumberFormat.Seconds(Seconds) + " (" + Method + ")";

    public void WriteKeys(Utf8JsonWriter json)
    {
        json.WriteInteger("points", Points);
        json.WriteInteger("bytesRead", BytesRead);
        json.WriteObjects("waves", Waves, wave =>
        {
            json.WriteInteger("points", wave.Points);
            json.WriteReal("seconds", wave.Seconds);
        });
        Slices.WriteKey(json);
        Error?.WriteKeys(json);
    }
}
