namespace FastPoints.Cli.Cluster;

/// <summary>What a task says at its end.</summary>
static class TaskReport
{
    /// <param name="work">Runs it, if it is not done already.</param>
    public static void Run(TaskRun task, int? number, string points, Func<TaskMarker> work)
    {
        var run = task.Run;
        TaskMarker? marker = null;
        bool isMerge = task.Name.StartsWith("merge", StringComparison.Ordinal);
        run.WriteKeys = json =>
        {
            if (number is { } n)
                json.WriteNumber("task", n);
            if (marker != null)
            {
                json.WriteInteger("points", marker.Points);
                json.WriteString("checksum", PlanFile.ToHex(marker.Checksum));
            }
            PlanFile.WriteTexts(json, "missing", task.Missing);
        };
        if (task.FindCommitted() != null)
        {
            run.Out.WriteLine(task.Name + ": the cloud is committed already");
            return;
        }
        marker = task.FindDone();
        bool wasDone = marker != null;
        marker ??= work();
        run.Out.WriteLine(task.Name + ": " + (wasDone ? "was done already, " : "") + NumberFormat.Count(marker.Points, points)
            + (isMerge ? " below it" : "") + " in " + NumberFormat.Seconds(run.Seconds));
        StageTable.Of(run.Progress).Write(run.Out, "  ");
    }
}
