namespace FastPoints.HostTests.Editor;

public sealed class ImportQueueTests
{
    ImportProject m_project;
    readonly List<string> m_ended = new List<string>();

    [SetUp]
    public void MakeProject()
    {
        m_project = new ImportProject();
        m_ended.Clear();
    }

    [TearDown]
    public void DeleteProject() => m_project.Dispose();

    ImportQueue Open()
    {
        var queue = new ImportQueue(m_project.Paths, _ => ImportProject.Settings());
        queue.ConversionEnded += (request, session) => m_ended.Add(request.AssetGuid + ": " + session.State);
        return queue;
    }

    string FilePath => Path.Combine(m_project.Paths.Clouds, ImportQueue.FileName);

    static void UpdateUntil(ImportQueue queue, Func<bool> isDone) =>
        ImportProject.Updates(() => queue.Tick(1, DateTime.UtcNow), isDone);

    void ResumeAndFinish(ImportQueue queue)
    {
        queue.Resume(queue.Requests[0]);
        UpdateUntil(queue, () => queue.Requests.Count == 0);
        m_project.AssertIsWhole(m_project.Target());
    }

    string[] Crash(ImportQueue queue)
    {
        string list = File.ReadAllText(FilePath), part = queue.Session == null ? null : m_project.Target() + ".part";
        string aside = m_project.Scratch["aside"];
        queue.Session?.Suspend();
        if (part != null && Directory.Exists(part))
            Directory.Move(part, aside);
        queue.Dispose();
        File.WriteAllText(FilePath, list);
        if (Directory.Exists(aside))
            Directory.Move(aside, part);
        return list.Split('\n');
    }

    [Test]
    public void Tick_SeveralRequests_ConvertsOneByOneAndLeavesOnlyClouds()
    {
        using var queue = Open();
        queue.Add(new[] { m_project.Request("one"), m_project.Request("two") });
        UpdateUntil(queue, () =>
        {
            Assert.That(queue.Requests.Count(r => r.State == ImportState.Running), Is.LessThanOrEqualTo(1));
            return queue.Requests.Count == 0;
        });

        Assert.That(m_ended, Is.EqualTo(new[] { "asset of one: Done", "asset of two: Done" }));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(m_project.Paths.Clouds).Select(Path.GetFileName),
            Is.EquivalentTo(new[] { "one.fastpoints", "two.fastpoints" }));
        m_project.AssertIsWhole(m_project.Target("two"));
    }

    /// <summary>Windows deletes nothing that somebody reads, and a queue that is found again would be worked off again.</summary>
    [Test]
    public void Tick_QueueFileInUseAtTheEnd_IsDeletedLater()
    {
        using var windows = WindowsRules.On();
        using var queue = Open();
        queue.Add(m_project.Request());
        using (WindowsRules.ReadAt((change, path, _) => change == FileChange.Delete && path == FilePath, (path, _) => path))
        {
            UpdateUntil(queue, () => queue.Requests.Count == 0);
            for (int seconds = 0; seconds < 60; seconds++)
                queue.Tick(1, DateTime.UtcNow.AddSeconds(seconds));
            Assert.That(File.Exists(FilePath), Is.True);
            Assert.That(queue.Problem, Does.Contain("used by another process"));
        }
        queue.Tick(1, DateTime.UtcNow.AddSeconds(70));
        Assert.That((File.Exists(FilePath), queue.Problem), Is.EqualTo((false, (string)null)));
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of scan: Done" }));
    }

    [Test]
    public void Tick_NothingToDo_WritesNothing()
    {
        using var queue = Open();
        for (int i = 0; i < 10; i++)
            queue.Tick(1, DateTime.UtcNow.AddMinutes(i));
        Assert.That(Directory.Exists(m_project.Paths.Clouds), Is.False);
    }

    [Test]
    public void Suspend_InTheMiddle_NextQueueResumes()
    {
        using (var before = Open())
        {
            before.Add(m_project.Request("scan"));
            before.Add(m_project.Request("other"));
            UpdateUntil(before, () => before.Session?.Progress.Current == "index");
            before.Suspend();
        }
        Assert.That(File.Exists(Path.Combine(m_project.Paths.Clouds, ImportQueue.LockName)), Is.False);

        using var after = Open();
        string note = null;
        after.ConversionEnded += (request, session) => note ??= session.Result.Note;
        UpdateUntil(after, () => after.Session != null);
        Assert.That(after.Requests.Select(r => r.AssetGuid), Is.EqualTo(new[] { "asset of scan", "asset of other" }));
        UpdateUntil(after, () => after.Requests.Count == 0);
        Assert.That(note, Does.StartWith("continued a build"));
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Crash_InTheMiddle_NextQueueRetriesALimitedNumberOfTimes()
    {
        for (int crash = 1; crash <= ImportQueue.MaxAttempts; crash++)
        {
            var queue = Open();
            if (crash == 1)
                queue.Add(m_project.Request());
            UpdateUntil(queue, () => queue.Session?.Progress.Current == "read");
            Assert.That(queue.CurrentRequest.Attempts, Is.EqualTo(crash));
            Assert.That(Crash(queue), Has.Some.Contains("\"Running\""));
        }

        using var last = Open();
        UpdateUntil(last, () => last.Requests.Count == 1);
        Assert.That(last.Requests[0].State, Is.EqualTo(ImportState.Failed));
        Assert.That(last.Requests[0].Failure, Does.Contain("3 times"));

        ResumeAndFinish(last);
    }

    [Test]
    public void Tick_TwoEditorsOnOneProject_OneImportsAndTheOtherNamesIt()
    {
        using var first = Open();
        using var second = Open();
        first.Add(m_project.Request("one"));
        UpdateUntil(first, () => first.Session != null);
        second.Add(m_project.Request("two"));
        second.Tick(1, DateTime.UtcNow);
        Assert.That(second.Session, Is.Null);
        Assert.That(second.Problem, Does.StartWith("process " + Environment.ProcessId + " on "));

        UpdateUntil(first, () => first.Requests.Count == 0);
        var now = DateTime.UtcNow.AddMinutes(1);
        ImportProject.Updates(() => second.Tick(1, now), () => second.Requests.Count == 0);
        Assert.That(second.Problem, Is.Null);
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of one: Done", "asset of two: Done" }));
    }

    [Test]
    public void Tick_MissingSource_FailsAndTheOthersContinue()
    {
        using var queue = Open();
        var gone = m_project.Request("gone");
        gone.Sources[0] = "Assets/none.las";
        queue.Add(gone);
        queue.Add(m_project.Request("two"));
        UpdateUntil(queue, () => m_ended.Count == 2);

        Assert.That(m_ended, Is.EqualTo(new[] { "asset of gone: Failed", "asset of two: Done" }));
        Assert.That(queue.Requests.Single().Failure, Does.EndWith("no such file or folder"));
        queue.Cancel(gone);
        queue.Tick(1, DateTime.UtcNow);
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetFileSystemEntries(m_project.Paths.Clouds), Has.Length.EqualTo(1));
    }

    [Test]
    public void Tick_UnwritableFolder_ReportsItAndKeepsTheRequests()
    {
        Directory.CreateDirectory(m_project.Paths.Project);
        File.WriteAllText(m_project.Paths.Clouds, "a file where the folder would be");
        using var queue = Open();
        queue.Add(m_project.Request());
        queue.Tick(1, DateTime.UtcNow);
        Assert.That(queue.Problem, Does.StartWith(m_project.Paths.Clouds));

        File.Delete(m_project.Paths.Clouds);
        var now = DateTime.UtcNow.AddMinutes(1);
        ImportProject.Updates(() => queue.Tick(1, now), () => queue.Requests.Count == 0);
        Assert.That(queue.Problem, Is.Null);
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Pause_WaitingAndRunning_OthersRunFirst()
    {
        using var queue = Open();
        ImportRequest one = m_project.Request("one"), two = m_project.Request("two");
        queue.Add(one);
        queue.Add(two);
        queue.Pause(one);
        UpdateUntil(queue, () => m_ended.Count == 1);
        Assert.That(m_ended[0], Is.EqualTo("asset of two: Done"));
        for (int i = 0; i < 20; i++)
            queue.Tick(1, DateTime.UtcNow);
        Assert.That(queue.Session, Is.Null);

        queue.Resume(one);
        UpdateUntil(queue, () => queue.Session?.Progress.Current == "read");
        queue.Pause(one);
        Assert.That(queue.Session.State, Is.EqualTo(ConversionState.Paused));
        queue.Resume(one);
        UpdateUntil(queue, () => queue.Requests.Count == 0);
    }

    [Test]
    public void Pause_RunningRequest_SurvivesReload()
    {
        using (var before = Open())
        {
            before.Add(m_project.Request());
            UpdateUntil(before, () => before.Session?.Progress.Current == "read");
            before.Pause(before.CurrentRequest);
            Assert.That(File.ReadAllText(FilePath), Does.Contain("\"Paused\""), "after a crash, too");
        }
        using var after = Open();
        for (int i = 0; i < 20; i++)
            after.Tick(1, DateTime.UtcNow);
        Assert.That(after.Requests.Single().State, Is.EqualTo(ImportState.Paused));
        Assert.That((after.Session, after.HasWork), Is.EqualTo(((ConversionSession)null, false)));

        ResumeAndFinish(after);
    }

    [Test]
    public void Pause_RunningRequest_OthersRunFirst()
    {
        using var queue = Open();
        ImportRequest one = m_project.Request("one"), two = m_project.Request("two");
        string note = null;
        queue.ConversionEnded += (request, session) => note = session.Result.Note;
        queue.Add(one);
        UpdateUntil(queue, () => queue.Session?.Progress.Current == "index");
        queue.Pause(one);
        for (int i = 0; i < 20; i++)
            queue.Tick(1, DateTime.UtcNow);
        Assert.That(queue.Session.State, Is.EqualTo(ConversionState.Paused));
        queue.Add(two);
        queue.Tick(1, DateTime.UtcNow);
        Assert.That((queue.CurrentRequest, one.State), Is.EqualTo((two, ImportState.Paused)));
        UpdateUntil(queue, () => m_ended.Count == 1);

        queue.Resume(one);
        UpdateUntil(queue, () => queue.Requests.Count == 0);
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of two: Done", "asset of one: Done" }));
        Assert.That(note, Does.StartWith("continued a build"));
        m_project.AssertIsWhole(m_project.Target("one"));
    }

    [Test]
    public void Cancel_RunningRequest_LeavesNothingAndTheNextBegins()
    {
        using var queue = Open();
        var one = m_project.Request("one");
        queue.Add(one);
        queue.Add(m_project.Request("two"));
        UpdateUntil(queue, () => queue.Session?.Progress.Current == "index");
        queue.Cancel(one);
        Assert.That(Directory.Exists(m_project.Target("one") + ".part"), Is.False);
        UpdateUntil(queue, () => queue.Requests.Count == 0);
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of one: Cancelled", "asset of two: Done" }));
    }

    [Test]
    public void Add_FolderAlreadyRequested_KeepsOneRequest()
    {
        using var queue = Open();
        queue.Add(m_project.Request());
        queue.Add(m_project.Request());
        Assert.That(queue.Requests, Has.Count.EqualTo(1));
        Assert.That(queue.ReservedPaths, Is.EqualTo(new[] { m_project.Target() }));
        UpdateUntil(queue, () => queue.Session != null);
        var running = queue.CurrentRequest;
        queue.Add(m_project.Request());
        Assert.That(queue.Requests, Is.EqualTo(new[] { running }), "a folder that is being made stays with its request");
    }

    [Test]
    public void Add_ManyWithDuplicates_KeepsOrderAndTheLaterDuplicate()
    {
        using var queue = Open();
        queue.Add(m_project.Request("first"));
        UpdateUntil(queue, () => queue.Session != null);
        int saves = queue.SaveCount;
        queue.Add(new[] { "b", "a", "c", "A" }.Select(m_project.Request).Append(m_project.Request("first")).ToArray());
        Assert.That(queue.Requests.Select(r => r.AssetGuid),
            Is.EqualTo(new[] { "asset of first", "asset of b", "asset of c", "asset of A" }));
        Assert.That(queue.SaveCount - saves, Is.EqualTo(1));
    }

    ImportRequest RequestWithNormals()
    {
        var request = m_project.Request();
        request.AddsNormals = true;
        return request;
    }

    [Test]
    public void Tick_Normals_AreAddedBehindTheBuild()
    {
        using var queue = Open();
        queue.Add(RequestWithNormals());
        queue.Add(m_project.Request("other"));
        double share = 0;
        UpdateUntil(queue, () =>
        {
            if (queue.CurrentRequest?.OnlyNormalsLeft == true)
            {
                Assert.That(queue.Session.Fraction, Is.InRange(share, 1));
                share = queue.Session.Fraction;
            }
            return queue.Requests.Count == 0;
        });
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of scan: Done", "asset of scan: Done", "asset of other: Done" }));
        Assert.That(share, Is.GreaterThan(0));
        Assert.That(ImportProject.NormalLayerOf(m_project.Target()), Is.EqualTo(1));
        Assert.That(ImportProject.NormalLayerOf(m_project.Target("other")), Is.Zero);
        m_project.AssertIsWhole(m_project.Target());
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Suspend_DuringNormals_NextQueueAddsThemWithoutBuilding(bool crashes)
    {
        using (var before = Open())
        {
            before.Add(RequestWithNormals());
            UpdateUntil(before, () => before.Session?.Progress.Current == AddNormals.Stage);
            if (crashes)
                Crash(before);
        }
        Assert.That(ImportProject.NormalLayerOf(m_project.Target()), Is.Zero);
        m_ended.Clear();
        using var after = Open();
        UpdateUntil(after, () => after.Session != null);
        UpdateUntil(after, () => after.Requests.Count == 0);
        Assert.That(m_ended, Is.EqualTo(new[] { "asset of scan: Done" }));
        Assert.That(ImportProject.NormalLayerOf(m_project.Target()), Is.EqualTo(1));
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Cancel_DuringNormals_LeavesTheCloudWithoutThem()
    {
        using var queue = Open();
        queue.Add(RequestWithNormals());
        UpdateUntil(queue, () => queue.Session?.Progress.Current == AddNormals.Stage);
        queue.Cancel(queue.CurrentRequest);
        Assert.That((queue.Requests.Count, m_ended.Last()), Is.EqualTo((0, "asset of scan: Cancelled")));
        Assert.That(ImportProject.NormalLayerOf(m_project.Target()), Is.Zero);
        m_project.AssertIsWhole(m_project.Target());
    }

    [Test]
    public void Load_DamagedList_IsRenamedAndReported()
    {
        Directory.CreateDirectory(m_project.Paths.Clouds);
        File.WriteAllText(FilePath, "{\"version\": 1, \"requests\": [{}]}");
        using var queue = Open();
        queue.Tick(1, DateTime.UtcNow);
        Assert.That(queue.Problem, Does.Contain("\"asset\": missing"));
        Assert.That(File.Exists(FilePath + ".bad"), Is.True);
        Assert.That(queue.Requests, Is.Empty);
    }

    [Test]
    public void Load_ListOfALaterVersion_IsNotChanged()
    {
        Directory.CreateDirectory(m_project.Paths.Clouds);
        File.WriteAllText(FilePath, "{\"version\": 2}");
        using var queue = Open();
        queue.Tick(1, DateTime.UtcNow);
        Assert.That(queue.Problem, Does.Contain("\"version\": wanted 1, got 2"));
        Assert.That(File.ReadAllText(FilePath), Is.EqualTo("{\"version\": 2}"));
    }
}
