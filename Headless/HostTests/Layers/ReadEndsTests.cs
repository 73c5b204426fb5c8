namespace FastPoints.HostTests.Layers;

/// <summary>Reads as the manual of Unity's FileHandle and of AsyncReadManager.CloseCachedFileAsync has them.</summary>
public sealed class ReadEndsTests
{
    static readonly Regex s_wrong = new Regex(@"\bReadStatus\.InProgress\b|\bAsyncReadManager\.Read\((?!kept\.Handle\b|file\b)");

    /// <summary>A read that waits for its file to be opened is neither in progress nor ended: only its JobHandle shows. A file
    /// that is read by its name stays open on macOS and Linux.</summary>
    [Test]
    public void Reads_OfThePackage_EndByTheirJobAndHaveHandles()
    {
        string root = Checkout.Repository.PackageRoot;
        var wrong = new[] { "Runtime", "Editor" }
            .SelectMany(folder => Directory.GetFiles(Path.Combine(root, folder), "*.cs", SearchOption.AllDirectories))
            // In a player's package nothing changes, and on pool threads no job is completed.
            .Where(path => Path.GetFileName(path) != "AssetFile.cs" && s_wrong.IsMatch(File.ReadAllText(path)))
            .Select(Path.GetFileName);
        Assert.That(wrong, Is.Empty);
        Assert.That(s_wrong.IsMatch("if (status == ReadStatus.InProgress)"));
        Assert.That(s_wrong.IsMatch("AsyncReadManager.Read(path, commands, 1)"));
    }

    [Test]
    public void Frames_DuringFileOpening_LoseNothing() => Show("", (stream, views) =>
    {
        Assert.That(FramesWithoutDisk(stream, views), Is.GreaterThan(0));
        for (int frame = 0; frame < 100_000 && !FrameStep.Run(stream, views).IsSettled; frame++)
            System.Threading.Thread.Yield();
        Assert.That(stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
        Assert.That(stream.Drawn.Length, Is.GreaterThan(0));
    });

    /// <summary>Another build, whose cloud is shown all the time, keeps none from its last rename.</summary>
    [Test]
    public void HasReleased_AnotherFolderIsRead_IsTrue() => Show(StoreFormat.UnfinishedSuffix, (stream, views) =>
    {
        const string Released = "released" + StoreFormat.UnfinishedSuffix;
        FolderReleases.Release(Released);
        try
        {
            bool hasReleased = false;
            Assert.That(FramesWithoutDisk(stream, views, () => hasReleased = FolderReleases.HasReleased), Is.GreaterThan(0));
            Assert.That(hasReleased);
        }
        finally
        {
            FolderReleases.Reacquire(Released);
        }
    });

    /// <summary>Shows a cloud whose folder's name ends so.</summary>
    static void Show(string suffix, Action<StreamContext, NativeArray<StreamView>> act)
    {
        string folder = Directory.CreateTempSubdirectory("fastpoints-").FullName;
        try
        {
            string las = Path.Combine(folder, "a.las"), cloud = Path.Combine(folder, "a.fastpoints");
            JobCoroutine.RunToEnd(LasScan.Run(las, 50_000, 1, ScanOrder.Strip, null));
            using (var reader = PointReaders.Open(las))
                JobCoroutine.RunToEnd(ConvertCloud.Run([reader], cloud, new ConvertSettings(), _ => { }, null));
            if (suffix.Length > 0)
                Directory.Move(cloud, cloud += suffix);
            using var stream = new StreamContext(new MemoryNodePool(64 << 20, 1 << 20));
            stream.Settings.MaxTries = 1;
            var source = new FolderSource(CloudFolder.Open(cloud));
            stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
            using var views = new NativeArray<StreamView>(1, Allocator.Persistent)
            {
                [0] = StreamView.Everything(1),
            };
            act(stream, views);
        }
        finally
        {
            Directory.Delete(folder, true);
        }
    }

    /// <returns>How many reads were begun meanwhile.</returns>
    static int FramesWithoutDisk(StreamContext stream, NativeArray<StreamView> views, Action then = null)
    {
        IoThreads.Pause(true);
        // A frame that waits for a read would wait for ever.
        using var end = new System.Threading.Timer(_ => IoThreads.Pause(false), null, 5000, -1);
        int inFlight = 0;
        try
        {
            for (int frame = 0; frame < 5; frame++)
                inFlight = FrameStep.Run(stream, views).ReadsInFlight;
            then?.Invoke();
        }
        finally
        {
            IoThreads.Pause(false);
        }
        return inFlight;
    }
}
