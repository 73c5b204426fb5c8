namespace FastPoints.Cli.Verbs;

public sealed class BuildVerb : Verb
{
    readonly TaskSettings m_task;
    readonly ValueOption<int?> m_bucket = new("--bucket", "[N]",
        "Sort some of the sources' points by the tasks that they belong to, where the plan has such tasks; before all "
            + "others.")
    { Arity = ArgumentArity.ZeroOrOne };

    public BuildVerb() : base(new Command("build",
        "Build one of a plan's tasks: as often as it takes, anywhere, with the same outcome."))
    {
        m_task = new TaskSettings(Command, isNumbered: true);
        Command.Add(m_bucket);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints build country.json --task 12", "the thirteenth"),
        ("./fastpoints build country.json --offset 1000", "in an array of Slurm's, Kubernetes' or AWS Batch's"),
        ("./fastpoints build country.json --bucket 3", "where the plan has buckets"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var plan = m_task.ReadPlan(parsed, run);
        bool isBucket = parsed.GetResult(m_bucket) is { Implicit: false };
        int number = m_task.Number(parsed, isBucket ? parsed.GetValue(m_bucket) : null,
            isBucket ? plan.BucketTasks : plan.BuildTasks, isBucket ? "bucket task" : "task");
        var report = new TaskReport(run, number, "point");
        foreach (int build in isBucket ? [number] : plan.Builds.Of(number))
        {
            using var task = m_task.Open(plan, isBucket ? TaskNames.Bucket(build) : plan.Builds.NameOf(build), parsed, run);
            report.Run(task, () => isBucket ? BuildTask.RunBucket(task, build) : BuildTask.Run(task, build));
        }
        report.WriteStages();
    }
}
