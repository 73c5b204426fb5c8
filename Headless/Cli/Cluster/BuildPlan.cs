namespace FastPoints.Cli.Cluster;

/// <summary>PLAN.json: what all tasks of a build over many machines share. What a task needs besides is in a file of its own, in
/// the folder PLAN.parts beside it.</summary>
sealed class BuildPlan
{
    const int Version = 1;
    public const string CubesName = "cubes"; // The file of the builds' cubes, which buckets take points for.

    public required string Path { get; init; }

    public ulong Hash { get; private set; } // Of the file, as it was written; tells this plan from others.

    /// <summary>Where the cloud comes to be: a folder, or s3://bucket/prefix.</summary>
    public required string Store { get; init; }

    /// <summary>Options of the command line that decide the bytes of the cloud: see <see cref="CloudSettings"/>.</summary>
    public required IReadOnlyList<string> Settings { get; init; }

    /// <summary>Schema and transform of all tiles; null of one file.</summary>
    public SourceInfo? Tiles { get; init; }

    /// <summary>Of the filter; 0 for all points.</summary>
    public ulong FilterHash { get; init; }

    /// <summary>Without base cells.</summary>
    public required BuildPart Whole { get; init; }

    public required CloudManifest Cloud { get; init; }

    public required BuildAssignment Builds { get; init; }
    public int BuildTasks => Builds.BuildTasks;

    /// <summary>None where builds read sources.</summary>
    public required int BucketTasks { get; init; }

    /// <summary>By level, from 1.</summary>
    public required IReadOnlyList<int> MergeTasks { get; init; }

    public required PlanEstimate Estimate { get; init; }

    public string LastMerge => TaskNames.Merge(MergeTasks.Count, 0);

    public IEnumerable<string> AllTasks =>
        Enumerable.Range(0, BucketTasks).Select(TaskNames.Bucket).Concat(Builds.Names).Concat(Merges);
    public IEnumerable<string> Merges => MergeTasks.SelectMany((count, level) =>
        Enumerable.Range(0, count).Select(number => TaskNames.Merge(level + 1, number)));

    public static string PartsOf(string path) => SourcePath.Combine(SourcePath.FolderOf(SourcePath.Full(path)),
        System.IO.Path.ChangeExtension(SourcePath.NameOf(path), ".parts"));

    public string PathOf(string name) => SourcePath.Combine(PartsOf(Path), name);

    /// <exception cref="PointCloudException">There is no such task, or its file is damaged or of another plan.</exception>
    public JsonMembers ReadTask(string name)
    {
        var json = PlanFile.Read(PathOf(name + ".json"), out _);
        return json.Hex("plan") == Hash ? json
            : throw new PointCloudException(FailureCode.BadInput, json.Path, -1, "belongs to another plan than " + Path);
    }

    public GridCube[] ReadCubes() => PlanFile.ReadCubes(ReadTask(CubesName), "cubes");

    /// <summary>What the file says; from then on Hash is its hash.</summary>
    public string ToTextAndSetHash()
    {
        string text = PlanFile.ToText(Write, isIndented: true);
        Hash = PlanFile.Parse(text, Path).Hex("hash");
        return text;
    }

    void Write(Utf8JsonWriter json)
    {
        json.WriteString("made by", "FastPoints");
        json.WriteNumber("version", Version);
        json.WriteString("store", Store);
        json.WriteNumber("tasks", BuildTasks);
        json.WriteNumber("builds", Builds.BuildCount);
        json.WriteNumber("bucketTasks", BucketTasks);
        WriteMergeLevels(json);
        Estimate.Write(json);
        json.WriteArray("settings", Settings, json.WriteStringValue);
        json.WriteString("filter", PlanFile.ToHex(FilterHash));
        json.WriteNumber("points", Whole.Points);
        json.WriteNumber("pointsPerChunk", Whole.PointsPerChunk);
        json.WritePropertyName("whole");
        PlanFile.WriteCube(json, Whole.CloudCube);
        json.WritePropertyName("firstBuilds");
        // On a line, not on one each.
        json.WriteRawValue("[" + string.Join(',', Builds.First) + "]");
        json.WriteBoolean("wideRecords", Whole.RecordLayout.IsWide);
        json.WritePropertyName("recordBase");
        var at = Whole.RecordLayout.Base;
        json.WriteNumbers(at.X, at.Y, at.Z);
        if (Tiles != null)
            WriteTiles(json, Tiles);
        json.WritePropertyName("cloud");
        json.WriteRawValue(Cloud.ToJson());
    }

    public void WriteMergeLevels(Utf8JsonWriter json)
    {
        json.WriteObjects("mergeLevels", Enumerable.Range(1, MergeTasks.Count), level =>
        {
            json.WriteNumber("level", level);
            json.WriteNumber("tasks", MergeTasks[level - 1]);
        });
    }

    static void WriteTiles(Utf8JsonWriter json, SourceInfo tiles)
    {
        json.WriteStartObject("tiles");
        json.WriteVector("scale", tiles.Transform.Scale);
        json.WriteVector("offset", tiles.Transform.Offset);
        json.WriteObjects("attributes", tiles.Schema, attribute =>
        {
            json.WriteString("name", attribute.Name);
            json.WriteString("type", attribute.Type.ToString());
            json.WriteNumber("scale", attribute.Scale);
            json.WriteNumber("offset", attribute.Offset);
        });
        json.WriteEndObject();
    }

    /// <exception cref="PointCloudException">There is none, or it is damaged.</exception>
    public static BuildPlan Read(string path)
    {
        var json = PlanFile.Read(path, out string text);
        json.RequireVersion(Version);
        using var document = JsonDocument.Parse(text);
        var cloud = CloudManifest.FromJson(document.RootElement.GetProperty("cloud").GetRawText(), path);
        var whole = PlanFile.ReadCube(json, "whole");
        var at = json.Longs("recordBase", 3);
        return new BuildPlan
        {
            Path = path,
            Hash = json.Hex("hash"),
            Store = json.Text("store"),
            Settings = json.Texts("settings"),
            FilterHash = json.Hex("filter"),
            Tiles = json.Has("tiles") ? ReadTiles(json.Object("tiles"), path) : null,
            Cloud = cloud,
            Whole = new BuildPart
            {
                CloudId = cloud.CloudId,
                Points = json.NonNegative("points"),
                PointsPerChunk = json.NonNegative("pointsPerChunk"),
                Grid = cloud.Grid,
                RecordLayout = new RecordLayout(json.Flag("wideRecords"), new Grid3(at[0], at[1], at[2]),
                    cloud.Attributes.BytesPerPoint),
                Attributes = cloud.Attributes,
                Divisors = cloud.Divisors,
                CloudCube = whole,
                Cube = whole,
                BaseCells = [],
            },
            Builds = new BuildAssignment(json.Longs("firstBuilds", json.Int("tasks")), json.Int("builds")),
            BucketTasks = json.Int("bucketTasks"),
            MergeTasks = json.Objects("mergeLevels").ConvertAll(level => level.Int("tasks")),
            Estimate = PlanEstimate.Read(json.Object("estimate")),
        };
    }

    static SourceInfo ReadTiles(JsonMembers json, string path) => new()
    {
        Path = path,
        Transform = new PositionTransform { Scale = json.Vector("scale"), Offset = json.Vector("offset") },
        Schema = new PointSchema(json.Objects("attributes").ConvertAll(a =>
            System.Enum.TryParse(a.Text("type"), out AttributeType type)
            ? new PointAttribute(a.Text("name"), type, a.Number("scale"), a.Number("offset"))
            : throw a.Wanted("type", "a type of attribute"))),
    };
}
