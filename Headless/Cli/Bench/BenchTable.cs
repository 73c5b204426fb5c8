namespace FastPoints.Cli.Bench;

public static class BenchTable
{
    public static TextTable Of(IReadOnlyList<WorkloadSamples> samples, IReadOnlyList<BaselineRow>? baseline)
    {
        var heads = new List<string> { "workload", "ms", "scatter", "points/s", "MB/s", "x limit", "error", "garbage" };
        if (baseline != null)
            heads.AddRange(["x baseline (95 %)", "x limit by baseline's", ""]);
        var table = new TextTable(heads.ToArray());
        for (int i = 0; i < samples.Count; i++)
        {
            var s = samples[i];
            if (!s.HadInput)
            {
                table.Add(s.Name, "no input");
                continue;
            }
            var cells = new List<string>
            {
                s.Name,
                s.MedianMs.ToString("0.000", CultureInfo.InvariantCulture),
                Scatter(s),
                s.Points > 0 ? NumberFormat.Short(s.MedianPointsPerSecond) : "",
                s.Bytes > 0 ? (s.MedianBytesPerSecond / 1e6).ToString("N0", CultureInfo.InvariantCulture) : "",
                s.HasLimit ? WorkloadSamples.Median(s.RatioToLimit).ToString("0.00", CultureInfo.InvariantCulture) : "",
                Error(s),
                NumberFormat.Bytes(s.MedianGarbageBytes),
            };
            if (baseline != null)
                cells.AddRange([BaselineRow.Interval(baseline[i].Time), BaselineRow.Interval(baseline[i].Limit),
                    baseline[i].Outcome]);
            table.Add(cells.ToArray());
        }
        return table;
    }

    public static string Error(WorkloadSamples samples) =>
        samples.ErrorUnit != null ? NumberFormat.FourDigits(samples.MedianError) + " " + samples.ErrorUnit
        : samples.MedianError == 0 ? "exact" : NumberFormat.FourDigits(samples.MedianError);

    static string Scatter(WorkloadSamples samples) => samples.Ms.Count < 2 || samples.MedianMs <= 0 ? "" : string.Create(
        CultureInfo.InvariantCulture,
        $"-{100 * (1 - samples.Ms.Min() / samples.MedianMs):0} +{100 * (samples.Ms.Max() / samples.MedianMs - 1):0} %");
}
