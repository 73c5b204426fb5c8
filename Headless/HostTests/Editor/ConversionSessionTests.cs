namespace FastPoints.HostTests.Editor;

public sealed class ConversionSessionTests
{
    ImportProject m_project;

    [SetUp]
    public void MakeProject() => m_project = new ImportProject();

    [TearDown]
    public void DeleteProject() => m_project.Dispose();

    ConversionSession Begin() => new ConversionSession(new[] { m_project.Source }, m_project.Target(), ImportProject.Settings());
    static void UpdateUntil(ConversionSession session, Func<bool> isDone) => ImportProject.Updates(() => session.Tick(1), isDone);

    [Test]
    public void Tick_ToTheEnd_ConvertsWithMonotonicProgress()
    {
        using var session = Begin();
        double share = 0;
        UpdateUntil(session, () =>
        {
            Assert.That(session.Fraction, Is.InRange(share, 1));
            share = session.Fraction;
            return session.IsEnded;
        });

        Assert.That(session.State, Is.EqualTo(ConversionState.Done), session.Failure?.Message);
        Assert.That(session.Fraction, Is.EqualTo(1));
        Assert.That(session.Source.Format, Is.EqualTo("LAS"));
        Assert.That(session.Result.Manifest.Points, Is.EqualTo(ImportProject.Points));
        m_project.AssertIsWhole(m_project.Target());
    }

    [TestCase("read")]
    [TestCase("index")]
    [TestCase("merge")]
    public void Suspend_InAnyStage_IsContinuedByTheNextSession(string stage)
    {
        using (var first = Begin())
        {
            // What was read before the first checkpoint is read again, and there is nothing to continue.
            string journal = Path.Combine(m_project.Target() + ".part", BuildFiles.JournalName);
            UpdateUntil(first, () => first.Progress.Current == stage && Appears(journal));
            first.Suspend();
            Assert.That(first.State, Is.EqualTo(ConversionState.Suspended));
            Assert.That(first.Tick(1), Is.True, "it is over");
        }
        Assert.That(Directory.Exists(m_project.Target() + ".part"), Is.True);

        using var second = Begin();
        UpdateUntil(second, () => second.IsEnded);

        Assert.That(second.State, Is.EqualTo(ConversionState.Done), second.Failure?.Message);
        Assert.That(second.Result.Note, Does.StartWith("continued a build"));
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Tick_ContinuedIndex_OpensNoFileOnTheMainThread()
    {
        string part = m_project.Target() + ".part";
        SuspendIndexed();
        var opened = new List<string>();
        int main = Environment.CurrentManagedThreadId;
        using var second = Begin();
        using (WindowsRules.Hear((change, path, _) =>
        {
            bool isOfAChunk = path.StartsWith(Path.Combine(part, BuildFiles.RecordFolderName)) ||
                path.StartsWith(Path.Combine(part, BuildFiles.TopFolderName));
            if (Environment.CurrentManagedThreadId == main && isOfAChunk && change is FileChange.Open or FileChange.Write)
                opened.Add(change + " " + path);
        }))
            UpdateUntil(second, () => second.IsEnded);

        Assert.That(second.State, Is.EqualTo(ConversionState.Done), second.Failure?.Message);
        Assert.That(second.Result.Note, Does.StartWith("continued a build"));
        Assert.That(opened, Is.Empty);
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Tick_MemoryRunsOut_KeepsWhatIsOnDisk()
    {
        SuspendIndexed();
        using (var failing = Begin())
        using (WindowsRules.Hear((change, path, _) =>
        {
            if (change == FileChange.Open && path.EndsWith(BuildFiles.JournalName))
                throw new OutOfMemoryException("planted");
        }))
        {
            UpdateUntil(failing, () => failing.IsEnded);
            Assert.That(failing.State, Is.EqualTo(ConversionState.Failed));
        }
        using var last = Begin();
        UpdateUntil(last, () => last.IsEnded);
        Assert.That(last.Result?.Note, Does.StartWith("continued a build"));
    }

    void SuspendIndexed()
    {
        string tops = Path.Combine(m_project.Target() + ".part", BuildFiles.TopFolderName);
        using var session = Begin();
        UpdateUntil(session, () => session.Progress.Current is "index" or "merge" && Directory.GetFiles(tops).Length > 1);
        session.Suspend();
    }

    /// <summary>Whether the file is there, or comes at once: the thread that writes it may be late.</summary>
    static bool Appears(string file) => SpinWait.SpinUntil(() => File.Exists(file), 20);

    [Test]
    public void Cancel_AtAnyMoment_LeavesNothing()
    {
        foreach (string stage in new[] { null, "read", "index" })
        {
            using var session = Begin();
            UpdateUntil(session, () => session.Progress.Current == stage || stage == null);
            session.Cancel();
            Assert.That(session.State, Is.EqualTo(ConversionState.Cancelled));
            FileChanges.AwaitDeletes();
            if (Directory.Exists(m_project.Paths.Clouds))
                Assert.That(Directory.GetFileSystemEntries(m_project.Paths.Clouds), Is.Empty, stage);
        }
    }

    [Test]
    public void Cancel_SuspendedBuild_LeavesNothing()
    {
        using (var first = Begin())
            UpdateUntil(first, () => first.Progress.Current == "index");
        Assert.That(Directory.Exists(m_project.Target() + ".part"), Is.True);

        using var second = Begin();
        second.Cancel();

        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(m_project.Paths.Clouds), Is.Empty);
    }

    [Test]
    public void Pause_WhileBuilding_TakesNoStep()
    {
        using var session = Begin();
        UpdateUntil(session, () => session.Progress.Current == "read" && session.Progress.Points > 0);
        session.Pause();
        long points = session.Progress.Points;
        double seconds = session.Seconds;
        for (int i = 0; i < 100; i++)
            Assert.That(session.Tick(5), Is.False);
        Assert.That(session.Progress.Points, Is.EqualTo(points));
        Assert.That(session.Seconds, Is.EqualTo(seconds));

        session.Resume();
        UpdateUntil(session, () => session.IsEnded);
        Assert.That(session.State, Is.EqualTo(ConversionState.Done));
    }

    [Test]
    public void Tick_NoSuchSource_Fails()
    {
        File.Delete(m_project.Source);
        using var session = Begin();
        UpdateUntil(session, () => session.IsEnded);

        Assert.That(session.State, Is.EqualTo(ConversionState.Failed));
        Assert.That(session.Failure, Has.Property("Code").EqualTo(FailureCode.NotFound));
    }

    sealed class BrokenList : IReadOnlyList<string>
    {
        public int Count => 1;

        public string this[int index] => throw new InvalidOperationException("planted");

        public IEnumerator<string> GetEnumerator() => throw new InvalidOperationException("planted");
        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }

    [Test]
    public void Tick_UnexpectedExceptionOnOpening_FailsAndSaysWhere()
    {
        using var session = new ConversionSession(new BrokenList(), m_project.Target(), ImportProject.Settings());
        UpdateUntil(session, () => session.IsEnded);

        Assert.That(session.State, Is.EqualTo(ConversionState.Failed));
        Assert.That(session.Failure, Has.Property("Code").EqualTo(FailureCode.Unexpected));
        Assert.That(session.Failure,
            Has.Property("FullMessage").Contains("InvalidOperationException: planted").And.Property("FullMessage")
            .Contains(nameof(ConversionSessionTests)));
    }

    [Test]
    public void Suspend_UnexpectedExceptionOnOpening_Ends()
    {
        using var session = new ConversionSession(new BrokenList(), m_project.Target(), ImportProject.Settings());
        session.Suspend();
        Assert.That(session.State, Is.EqualTo(ConversionState.Suspended));
    }

    [Test]
    public void Tick_OneOfSeveralSourcesIsBroken_FailsWithItsName()
    {
        string broken = m_project.Scratch["broken.las"];
        File.WriteAllText(broken, "LASF");
        string[] sources = { m_project.Source, broken };
        using var session = new ConversionSession(sources, m_project.Target(), ImportProject.Settings());
        UpdateUntil(session, () => session.IsEnded);

        Assert.That(session.Failure, Has.Property("Code").EqualTo(FailureCode.Truncated).And.Message.StartsWith(broken));
    }

    [Test]
    public void Tick_SourceShrinksMeanwhile_Fails()
    {
        using var session = Begin();
        UpdateUntil(session, () => session.Progress.Current == "read");
        using (var file = new FileStream(m_project.Source, FileMode.Open, FileAccess.Write, FileShare.ReadWrite))
            file.SetLength(2000);
        UpdateUntil(session, () => session.IsEnded);
        Assert.That(session.State, Is.EqualTo(ConversionState.Failed));
        Assert.That(session.Failure.Message, Does.StartWith(m_project.Source));
    }

    [Test]
    public void Tick_FullDisk_FailsAndResumesWithFreeSpace()
    {
        Directory.CreateDirectory(m_project.Paths.Clouds);
        if (!TryMount("-t tmpfs -o size=3m tmpfs " + m_project.Paths.Clouds))
            Assert.Ignore("a disk of three megabytes takes a mount, which this user may not make");
        try
        {
            using (var session = Begin())
            {
                UpdateUntil(session, () => session.IsEnded);
                Assert.That(session.State, Is.EqualTo(ConversionState.Failed));
                Assert.That(session.Failure, Has.Property("Code").EqualTo(FailureCode.DiskFull));
            }
            Assert.That(TryMount("-o remount,size=100m " + m_project.Paths.Clouds), Is.True);
            using var again = Begin();
            UpdateUntil(again, () => again.IsEnded);
            Assert.That(again.State, Is.EqualTo(ConversionState.Done), again.Failure?.Message);
            m_project.AssertIsWhole(m_project.Target());
        }
        finally
        {
            Process.Start("umount", m_project.Paths.Clouds).WaitForExit();
        }
    }

    static bool TryMount(string arguments)
    {
        try
        {
            using var mount = Process.Start(new ProcessStartInfo("mount", arguments) { RedirectStandardError = true });
            mount.WaitForExit();
            return mount.ExitCode == 0;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false;
        }
    }
}
