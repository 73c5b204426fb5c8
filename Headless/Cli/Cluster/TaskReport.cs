namespace FastPoints.Cli.Cluster;

sealed class TaskReport
{
    readonly CliRun m_run;
    readonly string m_unit;
    readonly List<string> m_missing = [];
    long m_points;
    ulong m_checksum;
    bool m_hasOutcome;

    public TaskReport(CliRun run, int? number, string unit)
    {
        (m_run, m_unit) = (run, unit);
        run.WriteKeys = json =>
        {
            if (number is { } n)
                json.WriteNumber("task", n);
            if (m_hasOutcome)
            {
                json.WriteInteger("points", m_points);
                json.WriteString("checksum", PlanFile.ToHex(m_checksum));
            }
            json.WriteArray("missing", m_missing, json.WriteStringValue);
        };
    }

    /// <param name="work">Runs it, if it is not done already.</param>
    public void Run(TaskRun task, Func<TaskMarker> work)
    {
        if (task.FindCommitted() != null)
        {
            m_run.Out.WriteLine(task.Name + ": the cloud is committed already");
            return;
        }
        double began = m_run.Seconds;
        var marker = task.CompleteIfDone();
        bool wasDone = marker != null;
        try
        {
            marker ??= work();
        }
        finally
        {
            m_missing.AddRange(task.Missing);
        }
        (m_points, m_checksum, m_hasOutcome) = (m_points + marker.Points, m_checksum + marker.Checksum, true);
        m_run.Out.WriteLine(task.Name + ": " + (wasDone ? "was done already, " : "") + NumberFormat.Count(marker.Points, m_unit)
            + (task.Name.StartsWith("merge", StringComparison.Ordinal) ? " below it" : "") + " in "
            + NumberFormat.Seconds(m_run.Seconds - began));
    }

    public void WriteStages()
    {
        if (m_hasOutcome)
            StageTable.Of(m_run.Progress).Write(m_run.Out, "  ");
    }
}
