namespace FastPoints.Cli.Verbs;

public sealed class InfoVerb : Verb
{
    readonly Inputs m_files = new("FILE", "Point clouds, folders of them, or converted clouds.");
    readonly Flag m_scan = new("--scan",
        "Decode every point: how many there are, their bounds, each attribute's range and sum, where nearly all are, and "
            + "how densely.");

    readonly Flag m_asOne = new("--as-one", "The files are tiles of one cloud: say what that is.");
    readonly SourceSettings m_source;

    public InfoVerb() : base(new Command("info", "Say what files are: format, version, count, bounds, attributes, coordinate "
        + "system, anomalies."))
    {
        Command.Add(m_files, m_scan, m_asOne);
        m_source = new SourceSettings(Command);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints info scan.las", "from the header, whatever the size"),
        ("./fastpoints info --scan scan.ply --json facts.json", "from every point"),
        ("./fastpoints info *.las --json - | jq '.files[].points'", "many files, for a script"),
        ("./fastpoints info scan.fastpoints", "levels, sizes and sources of a converted cloud"),
        ("./fastpoints info tiles/", "all clouds in a folder as one"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var files = parsed.GetRequiredValue(m_files);
        bool scan = parsed.GetValue(m_scan);
        files = run.Begin(files);
        var options = m_source.Read(parsed);
        var clouds = parsed.GetValue(m_asOne) ? [files] : files.Select(f => new[] { f }).ToArray();
        var all = new InputResults(clouds.Select(c => c[0]));
        run.WriteKeys = all.WriteKeys;
        foreach (var cloud in clouds)
            all.Run(run, () => Describe(cloud, options, scan, run));
        if (scan)
            StageTable.Of(run.Progress).Write(run.Out, "  ");
    }

    static (Action<Utf8JsonWriter>, PointCounts) Describe(string[] cloud, ReadOptions options, bool scan, CliRun run)
    {
        if (cloud is [var path] && CloudFolder.IsCloud(path))
        {
            var stored = new ConvertedCloudFacts(path);
            stored.Write(run.Out);
            run.Out.WriteLine();
            return (stored.WriteKeys, stored.PointCounts);
        }
        using var reader = PointReaders.Open(cloud, options);
        if (reader.Tree != null && !reader.BlocksAreKnown)
            run.RunSteps(reader.IndexBlocks());
        var facts = new SourceFacts(reader);
        if (scan)
        {
            using var sample = new SpreadSample(reader);
            var summarise = new SummariseCloud(reader) { BlockCompleted = sample.Add };
            run.RunSteps(summarise.Run(run.Progress));
            facts.Found = summarise.Summary;
            facts.Spread = Spread.Of(reader, sample, run);
        }
        facts.Write(run.Out);
        run.Out.WriteLine();
        run.Warn(reader.Info, isAlreadyShown: true);
        return (facts.WriteKeys, facts.PointCounts);
    }
}
