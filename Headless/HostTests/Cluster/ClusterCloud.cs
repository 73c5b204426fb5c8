namespace FastPoints.HostTests.Cluster;

/// <summary>A small cloud with many base cells, as one convert and as tasks make it.</summary>
sealed class ClusterCloud : IDisposable
{
    static readonly string[] s_small = ["--chunk-points", "1000", "--leaf-points", "200"];

    readonly Dictionary<string, string> m_whole = [];

    public ScratchFolder Scratch { get; } = new();
    public string Plan => Scratch["plan.json"];
    public string Store { get => field ?? Scratch["store"]; init; }
    public string[] Scratches => Directory.Exists(Scratch["scratch"]) ? Directory.GetDirectories(Scratch["scratch"]) : [];
    public JsonElement Planned { get; private set; }

    public int Count(string key) => Planned.GetProperty(key).GetInt32();

    /// <summary>Sources by their kind: one file, or 4 by 4 tiles that share some points.</summary>
    public string Sources(string kind)
    {
        string path = Scratch[kind.StartsWith("tiles", StringComparison.Ordinal) ? kind : "cloud." + kind];
        string las = Scratch["cloud.las"];
        if (!File.Exists(las))
            Scratch.Demo("cloud.las", 120_000);
        if (Path.Exists(path))
            return path;
        if (kind == "tiles" || kind == "tiles-laz")
            MakeTiles(las, Directory.CreateDirectory(path).FullName, kind == "tiles" ? ".las" : ".laz");
        else
            Done("export", las, "-o", path, "--quiet");
        return path;
    }

    static void MakeTiles(string las, string folder, string extension)
    {
        const double width = 74, height = 45;
        for (int x = 0; x < 4; x++)
            for (int y = 0; y < 4; y++)
                Done("export", las, "-o", Path.Combine(folder, x + "-" + y + extension), "--quiet", "--clip-local",
                    string.Create(CultureInfo.InvariantCulture,
                        $"{x * width},{y * height},0,{(x + 1) * width},{(y + 1) * height},100"));
    }

    public string Whole(string kind, params string[] options)
    {
        string key = kind + " " + string.Join(" ", options);
        if (m_whole.TryGetValue(key, out string made))
            return made;
        string path = m_whole[key] = Scratch["whole" + m_whole.Count + ".fastpoints"];
        Done(["convert", Sources(kind), "-o", path, "--quiet", .. s_small, .. options]);
        return path;
    }

    public void MakePlan(string kind, int taskPoints, params string[] options)
    {
        if (Directory.Exists(Store))
            Directory.Delete(Store, true);
        Planned = Done(["plan", Sources(kind), "-o", Plan, "--store", Store, "--task-points", taskPoints.ToString(), "--json",
            "-", "--quiet", .. s_small, .. options]).Json;
    }

    public IEnumerable<string[]> Stage(string verb) => verb switch
    {
        "bucket" => Numbers(Count("bucketTasks")).Select(n => new[] { "build", Plan, "--bucket", n }),
        "build" => Numbers(Count("tasks")).Select(n => new[] { "build", Plan, "--task", n }),
        _ => Planned.GetProperty("mergeLevels").EnumerateArray().SelectMany(level =>
            Numbers(level.GetProperty("tasks").GetInt32()).Select(n =>
                new[] { "merge", Plan, "--level", level.GetProperty("level").GetRawText(), "--task", n })),
    };

    static IEnumerable<string> Numbers(int count) => Enumerable.Range(0, count).Select(n => n.ToString());

    /// <summary>Buckets and builds in some order, then merges.</summary>
    public void RunTasks(Func<IEnumerable<string[]>, IEnumerable<string[]>> order = null, params string[] options)
    {
        order ??= same => same;
        foreach (var line in order(Stage("bucket")).Concat(order(Stage("build"))).Concat(Stage("merge")))
            Run([.. line, .. options]);
    }

    public CliCall Run(params string[] line) => Done([.. line, "--quiet", "--scratch", Scratch["scratch"]]);

    public CliCall Commit(params string[] options) =>
        CliCall.Of(["commit", Plan, "--quiet", "--json", "-", "--scratch", Scratch["scratch"], .. options]);

    public static CliCall Done(params string[] line)
    {
        var call = CliCall.Of(line);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), string.Join(" ", line) + "\n" + call.Error);
        return call;
    }

    /// <summary>What diff -r compares.</summary>
    public static void AssertSame(string wanted, string got)
    {
        string[] Names(string folder) => Directory.GetFileSystemEntries(folder, "*", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(folder, f)).Order(StringComparer.Ordinal).ToArray();
        Assert.That(Names(got), Is.EqualTo(Names(wanted)));
        foreach (string name in Names(wanted).Where(n => File.Exists(Path.Combine(wanted, n))))
            Assert.That(File.ReadAllBytes(Path.Combine(got, name)), Is.EqualTo(File.ReadAllBytes(Path.Combine(wanted, name))),
                name);
    }

    public void Dispose() => Scratch.Dispose();
}
