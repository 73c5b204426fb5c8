namespace FastPoints.Cli.Verbs;

public sealed class PlanVerb : Verb
{
    readonly Inputs m_sources = new("SOURCE",
        "Point clouds as convert takes them; besides patterns (in quotes: 'tiles/*.laz') and @LIST, a file with a source a "
            + "line.");
    readonly ValueOption<string> m_output = new("--output", "PLAN.json",
        "The plan to make; files for its tasks come into the folder PLAN.parts beside it.")
    { Aliases = { "-o" }, Required = true };
    readonly ValueOption<string> m_store = new(S3Addresses.StoreOption, "STORE",
        "Where the cloud comes to be: a folder that all machines see, or s3://bucket/prefix.")
    { Required = true };
    readonly Option<long> m_taskPoints = Counts.Of("--task-points", "Points of a task, about (default: 50M).", 50_000_000);
    readonly ValueOption<string> m_memory = new("--memory", "SIZE",
        "Resident memory that a task may take, unless it is told otherwise (default: 1GiB).", "1GiB");
    readonly Flag m_buckets = new("--buckets",
        "Read each source once and sort its points by task first, even if it seems cheaper that tasks read all that "
            + "overlaps them.");
    readonly Flag m_cells = new("--cells", "Have each task read all that overlaps it, even if that seems dearer than buckets.");
    readonly ValueOption<int?> m_divisors = new("--divisors", "1",
        "Take intensities and colours as they are, and not as the sample shows: as 8 bits in 16. For sources that a task "
            + "refuses.");
    readonly CloudSettings m_cloud;

    public PlanVerb() : base(new Command("plan", "Plan the build of a cloud by many machines, from headers and a sample."))
    {
        Command.Add(m_sources, m_output, m_store, m_taskPoints, m_memory, m_buckets, m_cells, m_divisors);
        m_cloud = new CloudSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints plan tiles/ -o country.json --store /data/country.fastpoints", "tasks for an array of jobs"),
        ("./fastpoints plan @tiles.txt -o country.json --store s3://clouds/country", "of a list, into object storage"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        string output = parsed.GetRequiredValue(m_output), store = parsed.GetRequiredValue(m_store);
        var settings = m_cloud.Read(parsed);
        if (parsed.GetValue(m_divisors) is { } divisor && divisor != 1)
            throw new UsageException("--divisors: wanted 1, got " + divisor);
        if (parsed.GetValue(m_buckets) && parsed.GetValue(m_cells))
            throw new UsageException("--buckets and --cells exclude each other");
        var words = m_cloud.ToWords(parsed);
        if (words.Any(w => w.StartsWith("--every-nth", StringComparison.Ordinal)))
            throw new UsageException("--every-nth: no plan can say which point is which; export such a file first");
        OutputNames.RefuseOtherKind("--output", "a plan", output);
        string[] sources = run.Begin(SourceList.Of(parsed.GetRequiredValue(m_sources)), output);
        run.Progress.Begin("headers");
        using var reader = PointReaders.Open(sources, m_cloud.ReadOptions(parsed));
        run.Warn(reader.Info);
        CloudSettings.RequireAttributes(settings, reader);
        using var filter = m_cloud.Filter(parsed, reader);
        var wanted = filter == null ? reader : new FilteredReader(reader, filter);
        string full = S3Addresses.IsS3(store) ? store : Path.GetFullPath(store);
        using (var there = ObjectStore.Open(full))
            if (!run.Settings.IsForced && there.ReadText(StoreFormat.ManifestName) != null)
                throw new UsageException("--store: there is a cloud already: " + store + "; --force plans all the same");
        string memory = parsed.GetRequiredValue(m_memory);
        var (plan, reads) = PlanStep.Run(wanted, settings, new PlanRequest(output, full, words, parsed.GetValue(m_taskPoints),
            parsed.GetValue(m_buckets) ? true : parsed.GetValue(m_cells) ? false : null,
            parsed.GetValue(m_divisors) ?? 0, Memory.Parse(memory)), run);
        run.Warn(reader.Info);
        run.Report(reader.Info.Losses);
        Report(plan, reads, run);
    }

    static void Report(BuildPlan plan, double reads, CliRun run)
    {
        string mode = plan.BucketTasks > 0 ? "buckets" : "cells";
        run.WriteKeys = json =>
        {
            json.WriteInteger("points", plan.Whole.Points);
            json.WriteNumber("tasks", plan.BuildTasks);
            json.WriteNumber("bucketTasks", plan.BucketTasks);
            plan.WriteMergeLevels(json);
            json.WriteString("mode", mode);
            json.WriteReal("readsPerPoint", Math.Round(reads, 3));
            plan.Estimate.Write(json);
        };
        run.Out.WriteLine(plan.Path + ": " + NumberFormat.Count(plan.Whole.Points, "point") + " for "
            + (plan.BucketTasks > 0 ? NumberFormat.Count(plan.BucketTasks, "bucket task") + ", " : "")
            + NumberFormat.Count(plan.BuildTasks, "task") + ", "
            + string.Join(" and ", plan.MergeTasks) + " merges, and the commit");
        run.Out.WriteLine("  mode   " + mode + ": tasks that read what overlaps them would read each point "
            + NumberFormat.Value(Math.Round(reads, 2)) + " times");
        run.Out.WriteLine("  takes  " + plan.Estimate.Describe());
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
