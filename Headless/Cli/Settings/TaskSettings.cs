namespace FastPoints.Cli.Settings;

sealed class TaskSettings
{
    /// <summary>Where Slurm, Kubernetes and AWS Batch tell a task its number.</summary>
    static readonly string[] s_variables = ["SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "AWS_BATCH_JOB_ARRAY_INDEX"];

    readonly Argument<string> m_plan = new("PLAN.json") { Description = "What the verb plan made; an address as well." };
    readonly ValueOption<int?> m_task = new("--task", "N",
        "Number of the task, from 0 (default: what " + string.Join(", ", s_variables[..^1]) + " or " + s_variables[^1] + " "
            + "says).");
    readonly ValueOption<int> m_offset = new("--offset", "N", "Added to the number: of an array that was split.");
    readonly ValueOption<string?> m_memory = new("--memory", "SIZE",
        "Resident memory that the process may take (default: the plan's). What is stored is the same.");
    readonly ValueOption<string?> m_scratch = new("--scratch", "DIR",
        "Folder for temporary files, on a disk of this machine (default: the system's).");

    public TaskSettings(Command command, bool isNumbered)
    {
        command.Add(m_plan);
        if (isNumbered)
            command.Add(m_task, m_offset);
        command.Add(m_memory, m_scratch);
    }

    public BuildPlan ReadPlan(ParseResult parsed, CliRun run)
    {
        string path = run.Begin([parsed.GetRequiredValue(m_plan)])[0];
        return BuildPlan.Read(path);
    }

    public int Number(ParseResult parsed, int? given, int count, string what)
    {
        given ??= parsed.GetValue(m_task);
        if (given == null && s_variables.Select(Environment.GetEnvironmentVariable).FirstOrDefault(v => !string.IsNullOrEmpty(v))
            is { } text)
            given = int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int index) ? index
                : throw new UsageException("the array's index: wanted a whole number, got " + text);
        int number = (given ?? throw new UsageException("--task: wanted the number of a " + what + ", or one of "
            + string.Join(", ", s_variables))) + parsed.GetValue(m_offset);
        return number >= 0 && number < count ? number
            : throw new UsageException("--task: the plan has " + NumberFormat.Count(count, what) + ", from 0: got " + number);
    }

    public TaskRun Open(BuildPlan plan, string name, ParseResult parsed, CliRun run) =>
        new(plan, name, parsed.GetValue(m_memory), parsed.GetValue(m_scratch), run);
}
