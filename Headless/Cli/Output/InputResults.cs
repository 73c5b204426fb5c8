namespace FastPoints.Cli.Output;

public sealed class InputResults(IEnumerable<string> inputs)
{
    sealed record Entry(string Input)
    {
        public Action<Utf8JsonWriter>? WriteKeys;
        public PointCounts Points = new();
        public Failure? Failure;
    }

    readonly List<Entry> m_all = inputs.Select(i => new Entry(SourcePath.WithoutQuery(i))).ToList();
    int m_runCount;

    public void Run(CliRun run, Func<(Action<Utf8JsonWriter> WriteKeys, PointCounts Points)> work)
    {
        var entry = m_all[m_runCount++];
        entry.Failure = run.TryInput(() => (entry.WriteKeys, entry.Points) = work());
        run.Points.Add(entry.Points);
    }

    public void WriteKeys(Utf8JsonWriter json)
    {
        if (m_all.Count == 1)
            m_all[0].WriteKeys?.Invoke(json);
        json.WriteObjects("files", m_all, entry =>
        {
            json.WriteString("input", entry.Input);
            json.WriteNumber("status", entry.Failure?.Status ?? ExitStatus.Done);
            entry.WriteKeys?.Invoke(json);
            entry.Points.WriteKeys(json);
            if (entry.Failure != null)
                Summary.WriteFailure(json, entry.Failure);
        });
    }
}
