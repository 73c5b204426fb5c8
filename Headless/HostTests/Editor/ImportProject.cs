namespace FastPoints.HostTests.Editor;

/// <summary>A project's folder, a scan, and settings with temporary files, so that a build can be resumed.</summary>
sealed class ImportProject : IDisposable
{
    public const int Points = 60_000;

    public ImportProject()
    {
        Paths = new ProjectPaths(Scratch["project"]);
        Source = Scratch.Demo("scan.las", Points);
    }

    public ScratchFolder Scratch { get; } = new ScratchFolder();
    public ProjectPaths Paths { get; }
    public string Source { get; }

    public string Target(string name = "scan") => Path.Combine(Paths.Clouds, name + ".fastpoints");

    public static ConvertSettings Settings() => new ConvertSettings
    {
        MemoryBytes = 1 << 20,
        PointsPerChunk = 5_000,
        PointsPerCheckpoint = 20_000,
    };

    public ImportRequest Request(string name = "scan") => new ImportRequest
    {
        AssetGuid = "asset of " + name,
        Sources = { Source },
        Cloud = Paths.Stored(Target(name)),
    };

    /// <summary>0 for none.</summary>
    public static int NormalLayerOf(string target)
    {
        using var folder = CloudFolder.Open(target);
        return folder.Manifest.NormalLayer;
    }

    /// <summary>Ends an endless wait; not a bound on speed: on a busy machine any number of turns may pass
    /// idly.</summary>
    public static readonly TimeSpan MaxWait = TimeSpan.FromMinutes(4);

    public static void Updates(Action update, Func<bool> isDone)
    {
        for (var wait = Stopwatch.StartNew(); !isDone() && wait.Elapsed < MaxWait;)
        {
            update();
            Thread.Yield();
        }
        Assert.That(isDone(), Is.True, "nothing came of it");
    }

    public void AssertIsWhole(string target)
    {
        var verified = CliCall.Of("verify", target, "--against", Source, "--quiet");
        Assert.That(verified.Status, Is.EqualTo(ExitStatus.Done), verified.Output + verified.Error);
        Assert.That(Directory.Exists(target + ".part"), Is.False);
    }

    public void Dispose() => Scratch.Dispose();
}
