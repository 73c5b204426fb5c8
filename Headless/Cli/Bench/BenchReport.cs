namespace FastPoints.Cli.Bench;

public static class BenchReport
{
    const double WideRange = 8;
    static readonly Regex s_number = new("[0-9]+");

    public static byte[] Make(PerformanceRun run, IReadOnlyList<WorkloadSamples> samples, Baseline? baseline,
        IReadOnlyList<BaselineRow>? rows, int points)
    {
        var page = new ReportPage("Benchmarks");
        page.Facts(
        [
            ("run", DateTimeOffset.FromUnixTimeMilliseconds(run.Date).ToString("yyyy-MM-dd HH:mm",
                CultureInfo.InvariantCulture) + " UTC"),
            ("machine", Machine.Describe()),
            ("made inputs", NumberFormat.Count(points, "point")),
            ("samples", samples.Max(s => s.Ms.Count) + " of each workload, in turns with its limit; short runs "
                + "are repeated within one"),
        ]);
        if (baseline != null && rows != null)
            Compare(page, run, samples, baseline, rows);
        foreach (var family in samples.Select((s, i) => (Samples: s, Row: rows?[i])).GroupBy(p => FamilyOf(p.Samples.Name)))
        {
            page.Heading(family.Key);
            var present = family.Where(p => p.Samples.HadInput).ToList();
            if (present.Count > 0)
                page.Chart(Times(family.Key, present, baseline != null));
            if (ErrorsOf(family.Select(p => p.Samples)) is { IsEmpty: false } errors)
                page.Chart(errors);
            page.Table(BenchTable.Of(family.Select(p => p.Samples).ToList(),
                rows == null ? null : family.Select(p => p.Row!).ToList()));
            foreach (var noted in family.Where(p => p.Samples.Note != null))
                page.Paragraph(noted.Samples.Name + ": " + noted.Samples.Note);
        }
        page.Heading("How to read this");
        page.Paragraph("Each marker is a sample, the tick across the bar is their median, which tables give. "
            + "\"Scatter\" is the shortest and the longest sample. \"x limit\" is time by point over that of what bounds the "
            + "workload (a plain read and copy, the same loop over raw pointers), sample by sample, in turns. An error is "
            + "that of an approximation; what has none is exact.");
        return page.ToBytes();
    }

    static void Compare(ReportPage page, PerformanceRun run, IReadOnlyList<WorkloadSamples> samples, Baseline baseline,
        IReadOnlyList<BaselineRow> rows)
    {
        page.Heading("Against the earlier run");
        page.Paragraph(baseline.Describe());
        if (baseline.Differences(run) is { } differences)
            page.Warning("warning: " + differences);
        foreach (string line in Caveats(rows))
            page.Paragraph(line);
        var chart = new RowChart("Time, by the earlier run's", "ratio and its 95 %: left of 1 is faster now", "", "time",
            "time by the limit's")
        {
            LogX = true,
            Reference = 1,
        };
        foreach (var row in rows.Where(r => r.Time != null))
            chart.Add(row.Name, row.Outcome, Interval(row.Time), Interval(row.Limit));
        page.Chart(chart);
        for (int i = 0; i < rows.Count; i++)
            if (rows[i].EarlierError is { } before && samples[i].HadInput && before != samples[i].MedianError)
                page.Paragraph($"{rows[i].Name}: its error was {NumberFormat.FourDigits(before)}, now "
                    + $"{BenchTable.Error(samples[i])}.");
    }

    static double[] Interval(SampleComparison? comparison) => comparison == null ? []
        : comparison.IsUnknown ? [comparison.Ratio] : [comparison.Low, comparison.Ratio, comparison.High];

    public static IEnumerable<string> Caveats(IReadOnlyList<BaselineRow> rows)
    {
        var times = rows.Select(r => r.Time).OfType<SampleComparison>().ToList();
        if (times.Count == 0)
        {
            yield return "No workload of that run can be compared with this one.";
            yield break;
        }
        yield return string.Create(CultureInfo.InvariantCulture,
            $"\"slower\" and \"faster\" mark what is beyond the scatter of the samples of both runs (95 %); of {times.Count} "
                + $"compared, {Math.Max(1, (int)Math.Round(times.Count * 0.05))} would be marked by "
            + $"chance if nothing had changed. The median ratio of all is "
            + $"{WorkloadSamples.Median(times.Select(t => t.Ratio)):0.00}: what slows "
            + $"all alike is the machine or what all share. Samples of one run know nothing of how a machine changes from "
            + $"hour to hour: repeat both runs in turns before believing a difference, or go by those that are "
            + $"judged by their limit.");
        if (times.Any(t => t.IsUnknown))
            yield return "Fewer than four samples in one of the runs (or a --json summary, which holds medians only): "
                + "nothing can be said of noise there.";
    }

    static RowChart Times(string family, IReadOnlyList<(WorkloadSamples Samples, BaselineRow? Row)> workloads, bool isCompared)
    {
        var ms = workloads.SelectMany(w => w.Samples.Ms.Concat(w.Row?.EarlierTimes ?? [])).Where(v => v > 0).ToList();
        var chart = new RowChart("Time of one run: " + family, "milliseconds", "error",
            isCompared ? ["now", "earlier"] : ["now"])
        {
            LogX = ms.Count > 0 && ms.Max() / ms.Min() > WideRange,
        };
        foreach (var (samples, row) in workloads)
            chart.Add(samples.Name, BenchTable.Error(samples), isCompared ? [samples.Ms, row!.EarlierTimes] : [samples.Ms]);
        return chart;
    }

    /// <summary>Of workloads that are told apart by one number in their names, N.</summary>
    public static LineChart ErrorsOf(IEnumerable<WorkloadSamples> workloads)
    {
        var known = workloads.Where(w => w.HadInput && w.MedianError > 0 && w.ErrorUnit != null).ToList();
        var chart = new LineChart("Error by N", "N", known.FirstOrDefault()?.ErrorUnit ?? "");
        foreach (var series in known.GroupBy(w => s_number.Replace(w.Name, "N")).Where(s => s.Count() > 2))
            chart.Add(series.Key, series.Select(w => (double.Parse(s_number.Match(w.Name).Value, CultureInfo.InvariantCulture),
                w.MedianError)));
        return chart;
    }

    static string FamilyOf(string workload) => workload.Split(' ', ',')[0];
}
