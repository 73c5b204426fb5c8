namespace FastPoints.HostTests.Editor;

public sealed class LockedFileTests : EditorFixture
{
    const string Handle = "Assets/a.pointcloud", Settings = "ProjectSettings/FastPoints.asset";

    readonly List<string> m_asked = new List<string>();

    [SetUp]
    public void Forget() => m_asked.Clear();

    void Lock(string path) => File.SetAttributes(m_project.Paths.Absolute(path), FileAttributes.ReadOnly);

    void AnswerCheckOuts(bool agrees) => AssetDatabase.s_checksOut = path =>
    {
        m_asked.Add(path);
        return agrees;
    };

    void Take() => m_project.Imports.CreateAsset(m_project.Scratch.Demo("a.las", 2000), "Assets");

    [Test]
    public void Handle_IsCheckedOutWhenItsCloudIsConverted()
    {
        AnswerCheckOuts(true);
        Take();
        Assert.That(m_asked, Is.Empty, "a new file");
        Lock(Handle);

        m_project.UpdateToTheEnd();

        Assert.That(m_asked, Is.EqualTo(new[] { Handle }));
        Assert.That(HandleFile.Read(Handle).Stamp, Is.Not.Null);
        Assert.That(m_logged, Is.Empty);
    }

    [TestCase(true, "version control does not check it out")]
    [TestCase(false, "is read-only")]
    public void Handle_CannotBeCheckedOut_IsOneErrorAndLosesNothing(bool hasVersionControl, string reason)
    {
        Take();
        if (hasVersionControl)
            AnswerCheckOuts(false);
        string before = File.ReadAllText(Handle);
        Lock(Handle);

        m_project.UpdateToTheEnd();

        Assert.That(m_logged.Single(), Does.StartWith("Error: FastPoints: ").And.Contains(Handle).And.Contains(reason));
        Assert.That(File.ReadAllText(Handle), Is.EqualTo(before));
        Assert.That(CloudFolder.IsCloud(Path.Combine(m_project.Paths.Clouds, "a.fastpoints")), "the cloud stays");
        Assert.That(Directory.GetFiles("Assets", "*.tmp"), Is.Empty);
    }

    [Test]
    public void Settings_Unchanged_AreNotWritten()
    {
        var settings = FastPointsSettings.instance;
        settings.UpdateMs = 6;
        settings.Save();
        int written = SettingsFile.s_writes;
        try
        {
            settings.Save();
            Assert.That(SettingsFile.s_writes, Is.EqualTo(written), "as each Undo of anything does");
            Object.DestroyImmediate(settings);
            settings = FastPointsSettings.instance;
            settings.Save();
            Assert.That((SettingsFile.s_writes, settings.UpdateMs), Is.EqualTo((written, 6)), "the next session knows");
            settings.UpdateMs = 5;
            settings.Save();
            Assert.That(SettingsFile.s_writes, Is.EqualTo(written + 1));
        }
        finally
        {
            settings.UpdateMs = 4;
        }
    }

    [Test]
    public void Settings_CannotBeCheckedOut_ApplyAndAreSavedLater()
    {
        var settings = FastPointsSettings.instance;
        settings.Save();
        Lock(Settings);
        AnswerCheckOuts(false);
        string before = File.ReadAllText(Settings);
        settings.PlayerWarningMiB = 7;
        settings.Save();
        Assert.That(m_logged.Single(), Does.StartWith("Error: FastPoints: the settings hold").And.Contains(Settings));
        Assert.That((settings.PlayerWarningMiB, File.ReadAllText(Settings)), Is.EqualTo((7, before)));

        settings.Save();
        Assert.That((m_asked.Count, m_logged.Count), Is.EqualTo((1, 1)), "the same again, as each Undo has it saved");

        AnswerCheckOuts(true);
        settings.PlayerWarningMiB = 8;
        settings.Save();

        Assert.That(m_asked, Is.EqualTo(new[] { Settings, Settings }));
        Assert.That(File.ReadAllText(Settings), Does.Contain("PlayerWarningMiB: 8"));
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Meta_OfAClaimedFile_IsCheckedOut(bool agrees)
    {
        SessionState.EraseString("FastPoints.PointFilePrompt");
        FastPointsSettings.instance.PointFiles = PointFiles.Leave;
        foreach (string name in new[] { "locked", "open" })
            m_project.Scratch.Demo("project/Assets/" + name + ".las", 500);
        AssetDatabase.Refresh();
        File.WriteAllText("Assets/locked.las.meta", "guid: 1\n");
        Lock("Assets/locked.las.meta");
        AnswerCheckOuts(agrees);
        FastPointsSettings.instance.PointFiles = PointFiles.Import;

        m_project.Imports.Update(DateTime.UtcNow);

        Assert.That(m_asked, Is.EqualTo(new[] { "Assets/locked.las.meta" }));
        Assert.That(AssetDatabase.Overrides.Keys, Is.EquivalentTo(agrees
            ? new[] { "Assets/locked.las", "Assets/open.las" } : new[] { "Assets/open.las" }));
        Assert.That(m_logged.Count(l => l.StartsWith("Warning: FastPoints: not all")), Is.EqualTo(agrees ? 0 : 1));
    }

    [Test]
    public void Write_LockedFile_Fails()
    {
        var settings = FastPointsSettings.instance;
        settings.Save();
        Lock(Settings);
        Assert.That(() => SettingsFile.Write(Settings, settings), Throws.TypeOf<UnauthorizedAccessException>());
        Assert.That(AssetDatabase.MakeEditable(Settings), Is.True, "nobody else locks it");
        Assert.That(AssetDatabase.MakeEditable("../elsewhere.txt"), Is.True);
        Assert.That(() => AssetDatabase.MakeEditable(null), Throws.ArgumentNullException);
    }
}
