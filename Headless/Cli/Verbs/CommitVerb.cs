namespace FastPoints.Cli.Verbs;

public sealed class CommitVerb : Verb
{
    readonly TaskSettings m_task;

    public CommitVerb() : base(new Command("commit",
        "Make a cloud of what all tasks of a plan have built; refused as long as one lacks."))
    {
        m_task = new TaskSettings(Command, isNumbered: false);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints commit country.json", "the cloud is there when this has ended"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var plan = m_task.ReadPlan(parsed, run);
        using var task = m_task.Open(plan, "commit", parsed, run);
        CloudManifest? manifest = null;
        run.WriteKeys = json =>
        {
            if (manifest != null)
            {
                json.WriteInteger("points", manifest.Points);
                json.WriteInteger("nodes", manifest.NodeCount);
                json.WriteString("checksum", PlanFile.ToHex(manifest.Checksum));
            }
            json.WriteArray("missing", task.Missing, json.WriteStringValue);
        };
        manifest = task.FindCommitted();
        bool wasDone = manifest != null;
        if (wasDone)
            CommitTask.Clean(task.Store);
        manifest ??= CommitTask.Run(task);
        run.Out.WriteLine(plan.Store + ": " + (wasDone ? "was committed already, " : "")
            + NumberFormat.Count(manifest.Points, "point") + " in " + NumberFormat.Count(manifest.NodeCount, "node"));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
