namespace FastPoints.HostTests.Writing;

/// <summary>Builds by Windows' rules: what somebody reads is neither renamed nor deleted.</summary>
[NonParallelizable]
public sealed class FilesInUseTests : ScratchPerTest
{
    /// <summary>What a reader is in the way of, by the operation that it has refused.</summary>
    static readonly (string Name, FileChange Change, Func<string, string, bool> IsIt)[] s_operations =
    {
        ("replace of cloud.json", FileChange.Replace, (_, to) => to.EndsWith("cloud.json") && File.Exists(to)),
        ("delete of a generation", FileChange.Delete, (path, _) => path.Contains("hierarchy-") && File.Exists(path)),
        ("rename of a finished file", FileChange.Replace, (_, to) => to.EndsWith(".bin") && !File.Exists(to)),
        ("the folder's name", FileChange.MoveFolder, (path, _) => path.EndsWith(StoreFormat.UnfinishedSuffix)),
    };

    static readonly int s_retryTimeoutMs = FileChanges.RetryTimeoutMs;

    readonly Dictionary<string, int> m_refused = new Dictionary<string, int>();
    readonly List<Timer> m_timers = new List<Timer>();
    IDisposable m_windows;

    [SetUp]
    public void BeWindows()
    {
        m_windows = WindowsRules.On();
        m_refused.Clear();
    }

    [TearDown]
    public void BeAsBefore()
    {
        m_windows.Dispose();
        FileChanges.RetryTimeoutMs = s_retryTimeoutMs;
        foreach (var timer in m_timers)
            timer.Dispose();
        m_timers.Clear();
    }

    static ConvertSettings Settings() => new ConvertSettings
    {
        MemoryBytes = 1 << 20,
        PointsPerChunk = 500,
        SecondsPerGeneration = 0,
        SecondsToFirstGeneration = 0,
    };

    static ConvertResult Convert(string source, string target, ConvertSettings settings)
    {
        ConvertResult result = null;
        using var reader = PointReaders.Open(new[] { source });
        JobCoroutine.RunToEnd(ConvertCloud.Run(new[] { reader }, target, settings, r => result = r, null));
        return result;
    }

    void ReadAt(int heldMs)
    {
        var done = new HashSet<string>();
        FileChanges.Intercept = (change, path, to) =>
        {
            var held = new List<IDisposable>();
            foreach (var operation in s_operations)
                if (operation.Change == change && operation.IsIt(path, to) && done.Add(operation.Name))
                {
                    string read = change == FileChange.MoveFolder ? Path.Combine(path, StoreFormat.ManifestName)
                        : change == FileChange.Replace && File.Exists(to) ? to : path;
                    held.Add(WindowsFiles.Hold(read));
                    m_refused[operation.Name] = m_refused.GetValueOrDefault(operation.Name) + 1;
                }
            try
            {
                WindowsRules.Check(change, path, to);
            }
            finally
            {
                foreach (var reader in held)
                    m_timers.Add(new Timer(_ => reader.Dispose(), null, heldMs, Timeout.Infinite));
            }
        };
    }

    [Test]
    public void Convert_FileReadDuringEachOperation_Finishes() => Conversions(4);

    [Test, Category("Long")]
    public void Convert_TwoHundredTimesWithFileReadDuringEachOperation_Finishes() => Conversions(200);

    void Conversions(int count)
    {
        string source = Scratch.Demo("a.las", 6000), target = Scratch["a.fastpoints"];
        for (int i = 0; i < count; i++)
        {
            ReadAt(30);
            long before = WindowsFiles.Refused;
            var result = Convert(source, target, Settings());
            Assert.That(result.Manifest.Points, Is.EqualTo(6000));
            Assert.That(WindowsFiles.Refused - before, Is.GreaterThanOrEqualTo(s_operations.Length));
            Assert.That(Directory.Exists(target + StoreFormat.UnfinishedSuffix), Is.False);
            Assert.That(File.Exists(Path.Combine(target, BuildFiles.JournalName)), Is.False);
        }
        Assert.That(m_refused.Values, Is.EqualTo(Enumerable.Repeat(count, s_operations.Length)));
        FileChanges.Intercept = WindowsRules.Check;
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories(Scratch.Root), Is.EqualTo(new[] { target }));
        Assert.That(CliCall.Of("verify", target, "--against", source, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
    }

    /// <summary>The time to try again is over: the error says what to do, and nothing is read again.</summary>
    [TestCase(1L << 20)]
    [TestCase(1L << 30)]
    public void Convert_FolderInUseUntilTheEnd_ReportsItAndTheNextBuildResumes(long memory)
    {
        string source = Scratch.Demo("a.las", 6000), target = Scratch["a.fastpoints"];
        string part = target + StoreFormat.UnfinishedSuffix;
        var settings = Settings();
        settings.MemoryBytes = memory;
        FileChanges.RetryTimeoutMs = 500;
        var reader = WindowsRules.ReadAt((change, path, _) => change == FileChange.MoveFolder && path == part,
            (path, _) => Path.Combine(path, StoreFormat.ManifestName));
        var failure = Assert.Throws<PointCloudException>(() => Convert(source, target, settings));
        Assert.That(failure.Message, Does.StartWith(target + ": is converted but for its name: wanted to rename " + part)
            .And.Contains("denied").And.EndsWith("goes on from here"));
        Assert.That(failure.IsInputAtFault, Is.False);
        reader.Dispose();
        var result = Convert(source, target, settings);
        Assert.That(result.Note, Does.StartWith("continued a build that was broken off: 6000 of 6000"));
        Assert.That(CliCall.Of("verify", target, "--against", source, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
    }

    [Test]
    public void Convert_ReplacedCloudInUseUntilTheEnd_KeepsIt()
    {
        string source = Scratch.Demo("a.las", 6000), target = Scratch.Converted("a.fastpoints", 3000);
        FileChanges.RetryTimeoutMs = 500;
        using (WindowsFiles.Hold(Path.Combine(target, StoreFormat.ManifestName)))
            Assert.Throws<PointCloudException>(() => Convert(source, target, Settings()));
        using (var folder = CloudFolder.Open(target))
            Assert.That(folder.Manifest.Points, Is.EqualTo(3000));
        Assert.That(Convert(source, target, Settings()).Manifest.Points, Is.EqualTo(6000));
    }

    [Test]
    public void BeginDelete_ProcessEndedEarly_NextProcessFinishesIt()
    {
        string folder = Scratch["a.fastpoints"];
        foreach (string name in new[] { folder, folder + ".deleted", folder + ".deleted2" })
            File.WriteAllText(Path.Combine(Directory.CreateDirectory(name).FullName, "a"), "a");
        FileChanges.BeginDelete(folder, _ => { });
        Assert.That(Directory.Exists(folder), Is.False);
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(Scratch.Root), Is.Empty);
    }

    [Test]
    public void BeginDelete_FileInUse_RetriesUntilItIsClosed()
    {
        string folder = Directory.CreateDirectory(Scratch["a.fastpoints"]).FullName, file = Path.Combine(folder, "a");
        File.WriteAllText(file, "a");
        Exception failure = null;
        bool isMoved = false;
        using (WindowsFiles.Hold(file))
        {
            FileChanges.BeginDelete(folder, e => (failure, isMoved) = (e, true));
            Assert.That(isMoved, Is.False);
        }
        FileChanges.AwaitDeletes();
        Assert.That((failure, isMoved), Is.EqualTo(((Exception)null, true)));
        Assert.That(Directory.GetFileSystemEntries(Scratch.Root), Is.Empty);
    }

    /// <summary>What the rules themselves are: a test in Windows' mode would show nothing without them.</summary>
    [Test]
    public void Rules_OfOpenFiles_AreThoseOfWindows()
    {
        string a = Scratch["a"], b = Scratch["b"], folder = Scratch["folder"];
        File.WriteAllText(a, "a");
        File.WriteAllText(b, "b");
        File.WriteAllText(Path.Combine(Directory.CreateDirectory(folder).FullName, "c"), "c");
        using (WindowsFiles.Hold(a))
        {
            Assert.Throws<IOException>(() => FileChanges.Replace(b, a));
            Assert.Throws<IOException>(() => FileChanges.Replace(a, b));
            Assert.Throws<IOException>(() => FileChanges.Delete(a));
            Assert.Throws<IOException>(() => FileChanges.OpenToWrite(a, FileMode.Create));
            FileChanges.OpenToRead(a, 1).Dispose();
        }
        using (FileChanges.OpenToRead(a, 1))
        {
            FileChanges.Delete(a);
            Assert.Throws<UnauthorizedAccessException>(() => FileChanges.OpenToWrite(a, FileMode.Create), "its name is there");
        }
        FileChanges.OpenToWrite(a, FileMode.Create).Dispose();
        using (FileChanges.OpenToRead(a, 1))
            FileChanges.Replace(b, a);
        using (FileChanges.OpenToRead(Path.Combine(folder, "c"), 1))
        {
            Assert.Throws<UnauthorizedAccessException>(() => FileChanges.MoveFolder(folder, b));
            Assert.Throws<IOException>(() => FileChanges.DeleteFolder(folder));
        }
        // The ninth differs in case from a file that is there.
        foreach (string name in new[] { "con", "NUL.txt", "a.", "a ", "a:b", "a?", "a\u0001", new string('x', 260), "A" })
            Assert.Throws<IOException>(() => FileChanges.OpenToWrite(Scratch[name], FileMode.Create), name);
    }
}
