namespace FastPoints.Cli.Cluster;

/// <summary>What a task has put into the store; with it, put last, the task is done.</summary>
sealed class TaskMarker
{
    /// <summary>Records of a bucket that belong to a build, or are outside of all.</summary>
    /// <param name="Offset">Of their blocks in the object.</param>
    public record struct Range(int Task, long Count, long Offset, long Bytes, ulong Hash);

    public record struct StoredObject(string Name, long Bytes, ulong Hash);

    ulong m_plan;

    public required string Task { get; init; }
    public required long Points { get; init; }
    public required ulong Checksum { get; init; }

    /// <summary>Points outside of the plan's cube, which the last merge takes.</summary>
    public long OutsidePoints { get; init; }
    public IReadOnlyList<Range> Ranges { get; init; } = [];
    public IReadOnlyList<StoredObject> Objects { get; init; } = [];

    public static string NameOf(string task) => ObjectStore.WorkFolder + task + ".json";

    public string ToText(BuildPlan plan) => PlanFile.ToText(json =>
    {
        json.WriteString("plan", PlanFile.ToHex(plan.Hash));
        json.WriteString("task", Task);
        json.WriteNumber("points", Points);
        json.WriteString("checksum", PlanFile.ToHex(Checksum));
        json.WriteNumber("outsidePoints", OutsidePoints);
        json.WriteObjects("ranges", Ranges, range =>
        {
            json.WriteNumber("task", range.Task);
            json.WriteNumber("count", range.Count);
            json.WriteNumber("offset", range.Offset);
            json.WriteNumber("bytes", range.Bytes);
            json.WriteString("hash", PlanFile.ToHex(range.Hash));
        });
        json.WriteObjects("objects", Objects, stored =>
        {
            json.WriteString("name", stored.Name);
            json.WriteNumber("bytes", stored.Bytes);
            json.WriteString("hash", PlanFile.ToHex(stored.Hash));
        });
    });

    /// <returns>Null if the task is not done: there is none, it is another plan's, or damaged.</returns>
    public static TaskMarker? Read(ObjectStore store, BuildPlan plan, string task)
    {
        if (store.ReadText(NameOf(task)) is not { } text)
            return null;
        try
        {
            var marker = Parse(text, NameOf(task));
            return marker.m_plan == plan.Hash && marker.Task == task ? marker : null;
        }
        catch (PointCloudException e) when (e.IsInputAtFault)
        {
            return null;
        }
    }

    public static TaskMarker Parse(string text, string path)
    {
        var json = PlanFile.Parse(text, path);
        return new TaskMarker
        {
            m_plan = json.Hex("plan"),
            Task = json.Text("task"),
            Points = json.NonNegative("points"),
            Checksum = json.Hex("checksum"),
            OutsidePoints = json.NonNegative("outsidePoints"),
            Ranges = json.Objects("ranges").ConvertAll(r =>
                new Range(r.Int("task"), r.NonNegative("count"), r.NonNegative("offset"), r.NonNegative("bytes"), r.Hex("hash"))),
            Objects = json.Objects("objects").ConvertAll(o =>
                new StoredObject(o.Text("name"), o.NonNegative("bytes"), o.Hex("hash"))),
        };
    }

    /// <summary>Those of several tasks, all of which must be done.</summary>
    /// <param name="missing">Receives the names of those that are not.</param>
    /// <exception cref="PointCloudException">Some are not.</exception>
    public static TaskMarker[] ReadAll(ObjectStore store, BuildPlan plan, IReadOnlyList<string> tasks, List<string> missing)
    {
        var markers = new TaskMarker?[tasks.Count];
        store.ForEach(Enumerable.Range(0, tasks.Count), t => markers[t] = Read(store, plan, tasks[t]));
        missing.AddRange(tasks.Where((_, t) => markers[t] == null));
        RefuseMissing(store, missing);
        return markers!;
    }

    public static void RefuseMissing(ObjectStore store, IReadOnlyList<string> missing)
    {
        const int shown = 20;
        if (missing.Count > 0)
            throw new PointCloudException(FailureCode.NotFound, store.Name, -1, NumberFormat.Count(missing.Count, "task")
                + " not done: " + string.Join(", ", missing.Take(shown)) + (missing.Count > shown ? ", ..." : ""));
    }
}
