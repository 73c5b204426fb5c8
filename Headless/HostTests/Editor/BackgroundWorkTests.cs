namespace FastPoints.HostTests.Editor;

public sealed class BackgroundWorkTests : EditorFixture
{
    [TearDown]
    public void Restore()
    {
        (EditorApplication.isPlaying, EditorApplication.isFocused, Application.isBatchMode) = (false, true, false);
        FastPointsSettings.instance.InPlayMode = InPlayMode.OneWorker;
    }

    [TestCase(true, 100, 4)]
    [TestCase(false, 16, 4)]
    [TestCase(false, 100, 24)]
    [TestCase(false, 100_000, 250)]
    public void Pace_RareUpdates_GrowsWithoutFocus(bool isFocused, double apartMs, double wantedMs)
    {
        var budget = new EditorTimeBudget();
        var now = new DateTime(2026, 1, 1, 0, 0, 0, DateTimeKind.Utc);
        Assert.That(budget.Next(now, 4, isFocused), Is.EqualTo(4), "nothing is measured yet");
        Assert.That(budget.Next(now.AddMilliseconds(apartMs), 4, isFocused), Is.EqualTo(wantedMs).Within(1e-9));
        Assert.That(budget.InFlightMs, Is.EqualTo(Math.Clamp(2 * apartMs, 250, 1000)));
        // A slice of 30 ms in 16 would lengthen the next interval, and that the next slice.
        Assert.That(budget.Next(now.AddMilliseconds(apartMs + 100), 30, false), Is.EqualTo(50).Within(1e-9));
    }

    [Test]
    public void PlayMode_Paused_TakesNoStepUntilItEnds()
    {
        FastPointsSettings.instance.InPlayMode = InPlayMode.Pause;
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 20_000), "Assets");
        var queue = m_project.Imports.Queue;
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => queue.Session?.State == ConversionState.Building);
        EditorApplication.isPlaying = true;
        m_project.Imports.Update(DateTime.UtcNow.AddSeconds(1));
        string stage = queue.Session.Progress.Current;
        long points = queue.Session.Progress.Points;
        for (int i = 0; i < 200; i++)
            m_project.Imports.Update(DateTime.UtcNow.AddSeconds(i));
        Assert.That((queue.Session.Progress.Current, queue.Session.Progress.Points), Is.EqualTo((stage, points)));
        Assert.That(Progress.Entries.Single().Description, Is.EqualTo("until play mode ends"));

        EditorApplication.isPlaying = false;
        m_project.UpdateToTheEnd();
        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(20_000));
    }

    [Test]
    public void PlayMode_DuringAConversion_UsesOneWorkerAndAllAfterwards()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 20_000), "Assets");
        var queue = m_project.Imports.Queue;
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => queue.Session?.State == ConversionState.Building);
        Assert.That(queue.Session.Workers, Is.Zero, "all");
        EditorApplication.isPlaying = true;
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(queue.Session?.Workers ?? 1, Is.EqualTo(1));
        EditorApplication.isPlaying = false;
        m_project.UpdateToTheEnd();
        var verified = CliCall.Of("verify", m_project.Paths.Absolute("PointClouds/scan.fastpoints"), "--quiet");
        Assert.That(verified.Status, Is.EqualTo(ExitStatus.Done), verified.Error);
    }

    [Test]
    public void BatchConvert_UnconvertedClouds_AreConvertedWithoutUpdates()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 5000), "Assets");
        m_project.Imports.CreateAsset(m_project.Copc("streamed.copc.laz"), "Assets");
        m_project.Scratch.Demo("project/Assets/inside.las", 4000);
        AssetDatabase.Refresh();
        Application.isBatchMode = true;
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);

        BatchConvert.All();

        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(5000));
        Assert.That(m_project.Imports.Catalog.Find(m_project.Imports.HandleOf("Assets/inside.las"), out _),
            Is.EqualTo(CatalogMatch.InPlace));
        long written = File.GetLastWriteTimeUtc("PointClouds/scan.fastpoints/cloud.json").Ticks;
        BatchConvert.All();
        Assert.That(File.GetLastWriteTimeUtc("PointClouds/scan.fastpoints/cloud.json").Ticks, Is.EqualTo(written));
        Assert.That(m_logged.Where(l => !l.StartsWith("Log")), Is.Empty);
    }

    [Test]
    public void BatchConvert_MissingSource_FailsAndNamesIt()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        string source = m_project.Scratch.Demo("gone.las", 1000);
        m_project.Imports.CreateAsset(source, "Assets");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 1000), "Assets");
        File.Delete(source);
        Assert.That(BatchConvert.All, Throws.InvalidOperationException.With.Message.Contains(
            "1 of 2 point clouds were not converted").And.Message.Contains("gone.las"));
        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(1000));
    }

    [Test]
    public void BatchConvert_FilesLockedForAMoment_AreWrittenLater()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 1000), "Assets");
        var refused = new HashSet<string>();
        var before = FileChanges.Intercept;
        FileChanges.Intercept = (change, from, to) =>
        {
            before?.Invoke(change, from, to);
            string name = Path.GetFileName(to);
            if (change == FileChange.Replace && (name == "imports.json" || name == "scan.pointcloud") && refused.Add(name))
                throw new IOException("somebody reads it");
        };
        try
        {
            BatchConvert.All();
        }
        finally
        {
            FileChanges.Intercept = before;
        }
        Assert.That(refused, Has.Count.EqualTo(2));
        Assert.That(m_project.Asset("Assets/scan.pointcloud").Points, Is.EqualTo(1000));
    }

    [Test]
    public void Imports_AtStart_FinishInterruptedDeletions()
    {
        Directory.CreateDirectory("PointClouds/far.fastpoints.deleted2/chunks");
        Directory.CreateDirectory("PointClouds/near.fastpoints");
        using (new EditorImports(m_project.Paths, FastPointsSettings.instance))
            FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories("PointClouds").Select(Path.GetFileName), Is.EqualTo(new[] { "near.fastpoints" }));
    }

    [Test]
    public void BatchConvert_FolderLockedByAnotherEditor_NamesIt()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 1000), "Assets");
        Assert.That(FolderLock.TakeOrGetOwner(Path.Combine("PointClouds", ImportQueue.LockName), out var held), Is.Null);
        int retryTimeoutMs = FileChanges.RetryTimeoutMs;
        FileChanges.RetryTimeoutMs = 500;
        using (held)
            Assert.That(BatchConvert.All, Throws.InvalidOperationException.With.Message.Contains("imports into"));
        FileChanges.RetryTimeoutMs = retryTimeoutMs;
    }

    /// <summary>Its Assets are those of the project, which only the main editor imports; its updates would ask a second
    /// time.</summary>
    [Test]
    public void VirtualPlayer_OfMultiplayerPlayMode_LeavesImportsToTheMainEditor()
    {
        var (heard, arguments) = (EditorApplication.update, PointCloudImports.s_arguments);
        try
        {
            foreach (bool isClone in new[] { true, false })
            {
                PointCloudImports.s_arguments = new[] { "Unity", isClone ? "--virtual-project-clone" : "-projectPath" };
                EditorApplication.update = null;
                PointCloudImports.Listen();
                string name = isClone ? "clone.las" : "main.las";
                m_project.Scratch.Demo("project/Assets/" + name, 1000);
                AssetDatabase.Refresh();
                m_project.Imports.TryCreateIgnoredFolder(m_project.Paths.Clouds);
                Assert.That(EditorApplication.update == null, Is.EqualTo(isClone));
                Assert.That(AssetDatabase.GetImporterOverride("Assets/" + name), isClone ? Is.Null : Is.Not.Null);
                Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(isClone ? 0 : 1));
                Assert.That(Directory.Exists("PointClouds"), Is.Not.EqualTo(isClone));
                Directory.CreateDirectory("PointClouds/gone.fastpoints.deleted1");
                using (new EditorImports(m_project.Paths, FastPointsSettings.instance))
                    FileChanges.AwaitDeletes();
                Assert.That(Directory.Exists("PointClouds/gone.fastpoints.deleted1"), Is.EqualTo(isClone));
                Directory.Delete("PointClouds", true);
            }
        }
        finally
        {
            (EditorApplication.update, PointCloudImports.s_arguments) = (heard, arguments);
        }
    }

    [Test]
    public void BatchMode_AtStart_SubscribesToNoUpdates()
    {
        var heard = EditorApplication.update;
        try
        {
            foreach (bool isBatch in new[] { true, false })
            {
                (Application.isBatchMode, EditorApplication.update) = (isBatch, null);
                PointCloudImports.Listen();
                Assert.That(EditorApplication.update == null, Is.EqualTo(isBatch));
            }
        }
        finally
        {
            EditorApplication.update = heard;
        }
    }
}
