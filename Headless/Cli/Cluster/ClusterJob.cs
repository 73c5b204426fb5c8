namespace FastPoints.Cli.Cluster;

/// <summary>What a scheduler is told of a plan: its stages, and what each task takes.</summary>
/// <param name="Plan">Where tasks read it: a path or an address.</param>
sealed record ClusterJob(string Plan, IReadOnlyList<ClusterStage> Stages, PlanEstimate Estimate)
{
    /// <summary>What a container or a node counts beside what <c>--memory</c> bounds: pages of files being written.</summary>
    const double MemoryReserve = 1.25;

    public string Name { get; } = NameOf(Plan);
    public long TaskMebibytes => (long)Math.Ceiling(Estimate.MemoryBytes * MemoryReserve / (256 << 20)) * 256;
    public long ScratchGibibytes => (Estimate.ScratchBytes >> 30) + 1;

    /// <summary>Twice the estimate of one core, by halves of an hour: what is not done by then goes on.</summary>
    public int TaskLimitMinutes => Math.Max(1, (int)Math.Ceiling(2 * Estimate.TaskSeconds / 1800)) * 30;

    public string Contents => string.Join(", ", Stages.Select(s => NumberFormat.Count(s.Tasks, s.Name + " task")));

    public static ClusterJob Of(BuildPlan plan)
    {
        var stages = new List<ClusterStage> { new("build", ["build"], plan.BuildTasks) };
        if (plan.BucketTasks > 0)
            stages.Insert(0, new ClusterStage("bucket", ["build", "--bucket"], plan.BucketTasks));
        for (int level = 1; level <= plan.MergeTasks.Count; level++)
        {
            string number = level.ToString(CultureInfo.InvariantCulture);
            stages.Add(new ClusterStage("merge-" + number, ["merge", "--level", number], plan.MergeTasks[level - 1]));
        }
        stages.Add(new ClusterStage("commit", ["commit"], 1));
        return new ClusterJob(S3Addresses.NameOf(SourcePath.Full(plan.Path)), stages, plan.Estimate);
    }

    /// <summary>A name that all schedulers take, of the plan's.</summary>
    static string NameOf(string plan)
    {
        string name = SourcePath.NameOf(plan).ToLowerInvariant();
        name = new string([.. name.Split('.')[0].Select(c => char.IsAsciiLetterOrDigit(c) ? c : '-')]).Trim('-');
        return name.Length == 0 ? "cloud" : name[..Math.Min(name.Length, 30)].TrimEnd('-');
    }
}
