namespace FastPoints.Cli.Verbs;

public sealed class MergeVerb : Verb
{
    readonly TaskSettings m_task;
    readonly ValueOption<int> m_level = new("--level", "L",
        "Level of the merge, from 1; each needs all of the one before it, and the first one all builds.")
    { Required = true };

    public MergeVerb() : base(new Command("merge", "Merge what tasks of a plan have left open to upper levels of the octree."))
    {
        m_task = new TaskSettings(Command, isNumbered: true);
        Command.Add(m_level);
    }

    public override IReadOnlyList<(string, string)> Examples =>
    [
        ("./fastpoints merge country.json --level 1 --task 0", "a task of the first level"),
    ];

    public override void Run(ParseResult parsed, CliRun run)
    {
        var plan = m_task.ReadPlan(parsed, run);
        int level = parsed.GetValue(m_level);
        if (level < 1 || level > plan.MergeTasks.Count)
            throw new UsageException("--level: the plan has " + NumberFormat.Count(plan.MergeTasks.Count, "level")
                + ", from 1: got " + level);
        int number = m_task.Number(parsed, null, plan.MergeTasks[level - 1], "merge task");
        using var task = m_task.Open(plan, TaskNames.Merge(level, number), parsed, run);
        var report = new TaskReport(run, number, "point");
        report.Run(task, () => MergeTaskRun.Run(task));
        report.WriteStages();
    }
}
