namespace FastPoints.Cli.Bench;

public sealed class Baseline
{
    const double SamePoints = 1e-3; // Points are recovered from points a second and times, both rounded.

    public const string Slower = "slower", Faster = "faster";

    readonly PerformanceRun m_run;
    readonly Dictionary<string, PerformanceTestResult> m_results = [];

    public Baseline(string path, PerformanceRun run)
    {
        (Path, m_run) = (path, run);
        foreach (var result in run.Results)
            if (PerformanceResults.WorkloadOf(result) is { } name)
                m_results[name] = result;
    }

    public string Path { get; }

    public string Describe() => m_run.Date == 0 ? Path : string.Create(CultureInfo.InvariantCulture,
        $"{Path}: {DateTimeOffset.FromUnixTimeMilliseconds(m_run.Date):yyyy-MM-dd HH:mm} UTC, "
            + $"{m_run.Hardware.ProcessorType}, "
        + $"{m_run.Hardware.ProcessorCount} cores, {m_run.Hardware.DeviceName}, {m_run.Editor.Version}");

    /// <summary>What differed in the earlier run, so that ratios are less reliable; or null.</summary>
    public string? Differences(PerformanceRun now)
    {
        if (m_run.Date == 0)
            return null;
        var pairs = new[]
        {
            (m_run.Hardware.ProcessorType, now.Hardware.ProcessorType), (m_run.Hardware.DeviceName, now.Hardware.DeviceName),
            (m_run.Hardware.ProcessorCount + " cores", now.Hardware.ProcessorCount + " cores"),
            (m_run.Editor.Version, now.Editor.Version),
        };
        var different = pairs.Where(p => p.Item1 != p.Item2).Select(p => p.Item1 + ", now " + p.Item2).ToList();
        return different.Count == 0 ? null : "not the same machine or runtime: " + string.Join("; ", different);
    }

    public List<BaselineRow> Compare(IReadOnlyList<WorkloadSamples> now)
    {
        var rows = now.Select(Compare).ToList();
        double all = WorkloadSamples.Median(rows.Select(r => r.Time).OfType<SampleComparison>().Select(t => t.Ratio));
        return rows.Select(row => row.BesideAll(all)).ToList();
    }

    BaselineRow Compare(WorkloadSamples now)
    {
        if (!m_results.TryGetValue(now.Name, out var before) || Samples(before, WorkloadSamples.Time) is not { Count: > 0 } times)
            return new BaselineRow(now.Name, times: [], null, null, null, "new");
        var error = before.SampleGroups.Find(g => g.Name.StartsWith(WorkloadSamples.Error, StringComparison.Ordinal));
        double? earlierError = error == null ? null : WorkloadSamples.Median(error.Samples);
        if (Differ(Amount(before, WorkloadSamples.PointsPerSecond), now.Points)
            || Differ(Amount(before, WorkloadSamples.BytesPerSecond), now.Bytes))
            return new BaselineRow(now.Name, times, null, null, earlierError, "other input");
        var time = SampleComparison.Of(now.Ms, times);
        var limit = SampleComparison.Of(now.RatioToLimit.ToList(), Samples(before, WorkloadSamples.TimesLimit));
        return new BaselineRow(now.Name, times, time, limit, earlierError, Outcome(time, limit));
    }

    /// <summary>Relative to the limit of each run if there is one: a machine that is slower overall slows both.</summary>
    static string Outcome(SampleComparison? time, SampleComparison? limit)
    {
        bool isByLimit = limit is { IsUnknown: false };
        var compared = isByLimit ? limit : time;
        if (compared == null || compared.IsUnknown)
            return "too few samples";
        return (!compared.IsBeyondNoise ? "within the noise" : compared.Ratio > 1 ? Slower : Faster)
            + (isByLimit ? ", by its limit" : "");
    }

    /// <summary>Points or bytes of one run, from those per second; 0 if unknown.</summary>
    static double Amount(PerformanceTestResult result, string perSecond)
    {
        var rates = Samples(result, perSecond);
        var times = Samples(result, WorkloadSamples.Time);
        return rates.Count == 0 ? 0 : WorkloadSamples.Median(rates.Zip(times, (rate, ms) => rate * ms / 1000));
    }

    static bool Differ(double before, long now) => Math.Abs(before - now) > SamePoints * Math.Max(before, now);

    static List<double> Samples(PerformanceTestResult result, string group) =>
        result.SampleGroups.Find(g => g.Name == group)?.Samples ?? [];
}

/// <param name="time">Null if nothing can be compared.</param>
public sealed class BaselineRow(string name, IReadOnlyList<double> times, SampleComparison? time, SampleComparison? limit,
    double? error, string result)
{
    const double CommonChange = 0.03;

    public string Name => name;
    public IReadOnlyList<double> EarlierTimes => times;
    public SampleComparison? Time => time;
    public SampleComparison? Limit => limit;
    public double? EarlierError => error;
    public string Outcome => result;

    /// <summary>A workload without a limit is not called slower if all are: that may be the machine.</summary>
    public BaselineRow BesideAll(double all)
    {
        if (time == null || (result != Baseline.Slower && result != Baseline.Faster))
            return this;
        // Between no change and the common one, or with the common one within the scatter.
        bool isAsAll = time.Low <= all && all <= time.High;
        bool isLess = result == Baseline.Slower ? all > time.High : all < time.Low;
        string beside = isAsAll && Math.Abs(Math.Log(all)) > CommonChange ? ", as all are" : isLess ? ", less than all are" : "";
        return new BaselineRow(name, times, time, limit, error, result + beside);
    }

    /// <summary>0.93 (0.90 to 0.97): a ratio and what the scatter allows.</summary>
    public static string Interval(SampleComparison? comparison) => comparison == null ? ""
        : comparison.IsUnknown ? comparison.Ratio.ToString("0.00", CultureInfo.InvariantCulture)
        : string.Create(CultureInfo.InvariantCulture,
            $"{comparison.Ratio:0.00} ({comparison.Low:0.00} to {comparison.High:0.00})");
}
