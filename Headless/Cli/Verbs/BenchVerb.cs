using FastPoints.Cli.Bench;
using FastPoints.Cli.Stability;

namespace FastPoints.Cli.Verbs;

public sealed class BenchVerb : Verb
{
    readonly Argument<string[]> m_names = new("NAME")
    {
        Arity = ArgumentArity.ZeroOrMore,
        Description = "Workloads whose name contains this (default: all). --list names them. stability: "
            + "extremes of input through every stage, with error, time, memory and outcome.",
    };
    readonly ValueOption<string?> m_baseline = new("--baseline", "FILE",
        "An earlier run on this machine (its PerformanceTestResults.json, here or from Unity, or its --json summary): each "
            + "workload's time is given by that run's, and marked where the difference is beyond the scatter of the samples.");
    readonly ValueOption<string> m_out = new("--output", "DIR",
        "Folder for report.html and PerformanceTestResults.json, in the format of Unity's Performance Testing package "
            + "(default: ./bench-report/).", "bench-report")
    { Aliases = { "-o", "--out" } };
    readonly Option<long> m_points = Counts.Of("--points", "Points that a made input has (default: 4,000,000).", 4_000_000);
    readonly Option<long> m_runs = Counts.Of("--runs",
        "Timed runs of each workload, interleaved (default: 7). The median counts.", 7);
    readonly Flag m_list = new("--list", "Name the workloads and run none.");

    public BenchVerb() : base(new Command("bench",
        "Run the benchmarks: median times, speeds, errors, garbage, and ratios to what bounds each "
            + "workload in the same run."))
    {
        Command.Add(m_names, m_baseline, m_out, m_points, m_runs, m_list);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints bench", "all workloads"),
        ("./fastpoints bench las --json las.json", "those with las in their name"),
        ("./fastpoints bench stability --points 1000000", "extremes of input, a million points each"),
        ("./fastpoints bench -o now-report --baseline bench-report/PerformanceTestResults.json",
            "compare with an earlier run"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var names = parsed.GetValue(m_names) ?? [];
        if (names is ["stability"])
        {
            StabilityTable.Run(parsed.GetResult(m_points)?.Implicit == false
                ? Counts.ToInt(parsed.GetValue(m_points))
                : StabilityTable.DefaultPoints, run);
            return;
        }
        var all = WorkloadList.All();
        var chosen = all.Where(w => names.Length == 0 ||
            names.Any(n => w.Name.Contains(n, StringComparison.OrdinalIgnoreCase))).ToList();
        if (chosen.Count == 0)
            throw new UsageException("no workload is called that: " + string.Join(", ", names) + " (--list names them)");
        var groups = WorkloadTurns.Groups(all, chosen).ToList();
        if (parsed.GetValue(m_list))
        {
            foreach (var workload in groups.SelectMany(g => g))
                run.Out.WriteLine(workload.Name + (workload.LimitName == null ? "" : "   (limit: " + workload.LimitName + ")"));
            return;
        }
        int points = Counts.ToInt(parsed.GetValue(m_points)), runs = Counts.ToInt(parsed.GetValue(m_runs));
        var baseline = parsed.GetValue(m_baseline) is { } path ? new Baseline(path, PerformanceResults.Read(path)) : null;
        string folder = parsed.GetValue(m_out)!;
        OutputNames.RefuseForeignFolder("a report", folder, PerformanceResults.FileName, run.Settings.IsForced);
        run.Begin([]);
        OutputFile.MakeFolder(folder);
        Report(RunWorkloads(groups, points, runs, run), baseline, points, folder, run);
    }

    static List<WorkloadSamples> RunWorkloads(List<List<IWorkload>> groups, int points, int runs, CliRun run)
    {
        string scratch = Directory.CreateTempSubdirectory("fastpoints-bench-").FullName;
        try
        {
            var context = new WorkloadContext { ScratchFolder = scratch, Points = points, DataFolder = DataFolder() };
            var settings = new TurnSettings
            {
                Turns = runs,
                AllocatedBytes = () => GC.GetTotalAllocatedBytes(true),
                Progress = share => run.Progress.Report(share, 0, 0),
                Cancellation = run.Cancellation,
            };
            var results = new List<WorkloadSamples>();
            foreach (var group in groups)
            {
                run.Progress.Begin(group[0].Name);
                try
                {
                    results.AddRange(WorkloadTurns.Run(group, context, settings));
                }
                finally
                {
                    run.Progress.End();
                }
            }
            return results;
        }
        finally
        {
            Directory.Delete(scratch, recursive: true);
        }
    }

    static void Report(List<WorkloadSamples> results, Baseline? baseline, int points, string folder, CliRun run)
    {
        var performance = PerformanceResults.Of(results);
        var rows = baseline?.Compare(results);
        run.WriteKeys = json => WriteJson(json, results);
        OutputFile.Write(Path.Combine(folder, PerformanceResults.FileName), PerformanceResults.ToBytes(performance));
        string page = Path.Combine(folder, "report.html");
        OutputFile.Write(page, BenchReport.Make(performance, results, baseline, rows, points));

        if (BenchReport.ErrorsOf(results) is { IsEmpty: false } errors)
            OutputFile.Write(Path.Combine(folder, "errors.svg"), errors.ToBytes());
        BenchTable.Of(results, rows).Write(run.Out, "");
        run.Out.WriteLine();
        foreach (var noted in results.Where(m => m.Note != null))
            run.Out.WriteLine(noted.Name + ": " + noted.Note);
        run.Out.WriteLine($"{Threads.InUse} threads, median of interleaved runs; \"x limit\": time by point over the "
            + "limit's of the same run.");
        if (baseline?.Differences(performance) is { } differences)
            run.Out.WriteLine("warning: the baseline is " + differences);
        foreach (string line in rows == null ? [] : BenchReport.Caveats(rows))
            run.Out.WriteLine(line);
        run.Out.WriteLine("all samples: " + page + ", " + Path.Combine(folder, PerformanceResults.FileName));
    }

    static string? DataFolder()
    {
        string? named = Environment.GetEnvironmentVariable("FASTPOINTS_DATA");
        return named != null && Directory.Exists(named) ? named : null;
    }

    static void WriteJson(Utf8JsonWriter json, List<WorkloadSamples> results)
    {
        json.WriteObjects("workloads", results, samples =>
        {
            json.WriteString("name", samples.Name);
            json.WriteReal("ms", samples.MedianMs);
            json.WriteReal("pointsPerSecond", samples.MedianPointsPerSecond);
            json.WriteReal("bytesPerSecond", samples.MedianBytesPerSecond);
            json.WriteReal("error", samples.MedianError);
            json.WriteInteger("garbageBytes", (long)Math.Round(samples.MedianGarbageBytes));
            if (samples.Note != null)
                json.WriteString("note", samples.Note);
        });
    }
}
