namespace FastPoints.Cli.Cluster;

/// <summary>Tasks that may run at once, behind all of the stage before.</summary>
/// <param name="Words">Verb and options of the command line, but for the plan and the task.</param>
sealed record ClusterStage(string Name, string[] Words, int Tasks)
{
    public bool IsNumbered => Words[0] != "commit"; // The last one has one task, which needs no number.

    public IEnumerable<ClusterArray> Arrays(int max)
    {
        for (int first = 0; first < Tasks; first += max)
            yield return new ClusterArray(this, first, Math.Min(max, Tasks - first));
    }
}

/// <summary>Tasks of a stage, which a scheduler numbers from 0.</summary>
sealed record ClusterArray(ClusterStage Stage, int First, int Tasks)
{
    public string Name => Stage.Name + (First == 0 ? "" : "-" + First);

    public IEnumerable<string> Words(string plan) => First == 0 ? [Stage.Words[0], plan, .. Stage.Words[1..]]
        : [Stage.Words[0], plan, .. Stage.Words[1..], "--offset", First.ToString(CultureInfo.InvariantCulture)];
}
