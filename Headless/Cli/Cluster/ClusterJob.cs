namespace FastPoints.Cli.Cluster;

/// <summary>What a scheduler is told of a plan: its stages, and what each task takes.</summary>
/// <param name="Plan">Where tasks read it: a path or an address.</param>
/// <param name="MemoryBytes">What bounds a task's memory.</param>
/// <param name="TaskSeconds">Of the longest task, by one core.</param>
sealed record ClusterJob(string Plan, IReadOnlyList<ClusterStage> Stages, long MemoryBytes, double TaskSeconds, long ScratchBytes)
{
    /// <summary>What a container or a node counts beside what <c>--memory</c> bounds: pages of files that are being written.</summary>
    const double MemoryReserve = 1.25;

    public string Name { get; } = NameOf(Plan);
    public string Memory => (MemoryBytes >> 20) + "MiB";
    public long NodeMebibytes => (long)Math.Ceiling(MemoryBytes * MemoryReserve / (256 << 20)) * 256;
    public long ScratchGibibytes => (ScratchBytes >> 30) + 1;

    /// <summary>Twice the estimate, by halves of an hour: what is not done by then goes on.</summary>
    public int LimitMinutes => Math.Max(1, (int)Math.Ceiling(2 * TaskSeconds / 1800)) * 30;

    public string Contents => string.Join(", ", Stages.Select(s => NumberFormat.Count(s.Tasks, s.Name + " task")));

    /// <summary>A name that all schedulers take, of the plan's.</summary>
    static string NameOf(string plan)
    {
        string name = Path.GetFileName(SourcePath.WithoutQuery(plan)).ToLowerInvariant();
        name = new string([.. name.Split('.')[0].Select(c => char.IsAsciiLetterOrDigit(c) ? c : '-')]).Trim('-');
        return name.Length == 0 ? "cloud" : name[..Math.Min(name.Length, 30)].TrimEnd('-');
    }
}
