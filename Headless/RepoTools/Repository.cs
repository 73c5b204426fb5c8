namespace FastPoints.RepoTools;

public sealed class Repository(string root)
{
    public static readonly string[] Generations = UnityApi.Generations;

    public string Root { get; } = Path.GetFullPath(root);
    public string PackageRoot => Path.Combine(Root, "Packages", "com.fastpoints.dots");
    public string Headless => Path.Combine(Root, "Headless");
    public string StandIns => Path.Combine(Root, "UnityOutside", "StandIns");
    public string PhysicsApi => Path.Combine(Headless, "Api", "com.unity.physics.tsv"); // What the full list lacks.
    public string UsedApi => Path.Combine(Headless, "Api", "used.tsv");
    public string UsedThreads => Path.Combine(Headless, "Api", "threads.tsv");
    public string Behaviour => Path.Combine(Headless, "Api", "behaviour.tsv");
    public string House => Path.Combine(Headless, "Api", "house.tsv");

    /// <summary>How large it may be at most after each part of the work: a copy of what may lie beside the repository.</summary>
    public string Ceilings => Path.Combine(Headless, "Api", "ceilings.tsv");

    /// <summary>What <see cref="Ceilings"/> is a copy of; it may be absent.</summary>
    public string GivenCeilings => Path.Combine(DataRoot, "design", "ceilings.tsv");

    /// <summary>The full list of Unity's signatures; it may be absent.</summary>
    public string FullApi => Path.Combine(DataRoot, "unity-api");

    private string DataRoot => Environment.GetEnvironmentVariable("FASTPOINTS_DATA") ?? Path.Combine(Root, "..", "shared");

    public string BuildOf(string assembly, string generation) =>
        Path.Combine(Headless, "artifacts", "bin", assembly, "unity-" + generation);

    /// <summary>Paths of the files that are committed or would be, with '/'.</summary>
    public IReadOnlyList<string> Files()
    {
        var start = new ProcessStartInfo("git", "ls-files --cached --others --exclude-standard")
        {
            WorkingDirectory = Root,
            RedirectStandardOutput = true,
        };
        using Process git = Process.Start(start) ?? throw new ToolException("git did not start");
        string output = git.StandardOutput.ReadToEnd();
        git.WaitForExit();
        if (git.ExitCode != 0)
            throw new ToolException("git ls-files failed");
        return output.Split('\n').Where(f => f.Length > 0 && File.Exists(Path.Combine(Root, f))).Distinct().ToList();
    }

    public static Repository Find()
    {
        for (var folder = new DirectoryInfo(AppContext.BaseDirectory); folder != null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, "Packages", "com.fastpoints.dots", "package.json")))
                return new Repository(folder.FullName);
        }
        throw new ToolException($"no repository above {AppContext.BaseDirectory}; give it with --root");
    }
}
