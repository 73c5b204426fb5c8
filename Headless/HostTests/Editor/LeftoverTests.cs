namespace FastPoints.HostTests.Editor;

public sealed class LeftoverTests : EditorFixture
{
    [SetUp]
    public void DisablePrompts()
    {
        EditorUtility.s_agrees = false;
        EditorUtility.s_dialogs.Clear();
    }

    [TearDown]
    public void Restore() => (FastPointsSettings.instance.GitIgnore, EditorUtility.s_agrees, Application.isBatchMode,
        EditorApplication.isPlaying) = (true, false, false, false);

    [Test]
    public void DataFolder_Created_IsIgnoredByGitUnlessSettingsCommitIt([Values] bool ignores)
    {
        FastPointsSettings.instance.GitIgnore = ignores;
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("scan.las", 1000), "Assets");
        Assert.That(File.Exists("PointClouds/.gitignore"), Is.EqualTo(ignores));
        if (!ignores)
            return;
        Assert.That(File.ReadAllLines("PointClouds/.gitignore"), Does.Contain("*"));
        File.Delete("PointClouds/.gitignore");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("other.las", 1000), "Assets");
        Assert.That(File.Exists("PointClouds/.gitignore"), Is.False, "who has taken it away wants it so");
    }

    void Updates() => ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
        () => !m_project.Imports.Thumbnails.IsDrawing);

    [TestCase(true)]
    [TestCase(false)]
    public void Delete_ByTheUser_AsksOnceWhetherToDeleteTheData(bool agrees)
    {
        AssetDatabase.CreateFolder("Assets", "Scans");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets/Scans");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("two.las", 1000), "Assets/Scans");
        m_project.UpdateToTheEnd();
        Updates();
        EditorUtility.s_agrees = agrees;

        AssetDatabase.DeleteAsset("Assets/Scans");
        Assert.That(EditorUtility.s_dialogs, Is.Empty, "not while Unity imports");
        Updates();
        m_project.Imports.Update(DateTime.UtcNow);

        Assert.That(EditorUtility.s_dialogs.Single(), Does.Contain("one.fastpoints\ntwo.fastpoints"));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories("PointClouds").Length, Is.EqualTo(agrees ? 0 : 2));
        Assert.That(Directory.GetFiles("PointClouds", "*.png").Length, Is.EqualTo(agrees ? 0 : 2));
    }

    /// <summary>There is nothing to ask about yet, and there would be a cloud that nobody uses.</summary>
    [Test]
    public void Delete_BeforeItIsConverted_CancelsTheConversion()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets");
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("two.las", 1000), "Assets");
        Assert.That(m_project.Imports.Assets.All, Has.Count.EqualTo(2));
        AssetDatabase.DeleteAsset("Assets/two.pointcloud");
        m_project.UpdateToTheEnd();
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories("PointClouds").Select(Path.GetFileName), Is.EqualTo(new[] { "one.fastpoints" }));
    }

    [Test]
    public void Delete_ByABranchChange_AsksNothing()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        File.Delete("Assets/one.pointcloud");
        AssetDatabase.Refresh();
        Updates();
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        Assert.That(Directory.Exists("PointClouds/one.fastpoints"), Is.True);
    }

    [Test]
    public void Delete_OneOfTwoAssets_KeepsTheDataForTheOther()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        File.Copy("Assets/one.pointcloud", "Assets/one 1.pointcloud");
        AssetDatabase.Refresh();
        EditorUtility.s_agrees = true;

        AssetDatabase.DeleteAsset("Assets/one.pointcloud");
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(EditorUtility.s_dialogs, Is.Empty);

        AssetDatabase.DeleteAsset("Assets/one 1.pointcloud");
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1));
        Assert.That(Directory.Exists("PointClouds/one.fastpoints"), Is.False);
    }

    [Test]
    public void Delete_OfAFolderElsewhere_IsNotOffered()
    {
        string folder = m_project.Scratch.Converted("far.fastpoints");
        m_project.Imports.CreateAsset(folder, "Assets");
        EditorUtility.s_agrees = true;
        AssetDatabase.DeleteAsset("Assets/far.pointcloud");
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        Assert.That(Directory.Exists(folder), Is.True);
    }

    [Test]
    public void Duplicate_OfAHandle_SharesTheCloudAndItsConversion()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 3000), "Assets");
        File.Copy("Assets/one.pointcloud", "Assets/one 1.pointcloud");
        AssetDatabase.Refresh();
        Assert.That(m_project.Imports.RequestOf("Assets/one 1.pointcloud"),
            Is.SameAs(m_project.Imports.RequestOf("Assets/one.pointcloud")).And.Not.Null);

        m_project.UpdateToTheEnd();

        Assert.That((m_project.Asset("Assets/one.pointcloud").Points, m_project.Asset("Assets/one 1.pointcloud").Points),
            Is.EqualTo((3000L, 3000L)));
        Assert.That(HandleFile.Read("Assets/one 1.pointcloud").CloudId,
            Is.EqualTo(HandleFile.Read("Assets/one.pointcloud").CloudId).And.Not.Zero);
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories("PointClouds"), Has.Length.EqualTo(1));
    }

    void Clone(params string[] names)
    {
        foreach (string name in names)
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        Updates();
        AssemblyReloadEvents.Reload();
        Directory.Delete("PointClouds", true);
        SessionState.EraseString("FastPoints.MissingDataPrompt");
        EditorUtility.s_dialogs.Clear();
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Clone_SourcesWithoutData_AsksOnceForAll(bool agrees)
    {
        Clone("one", "two", "gone");
        File.Delete(m_project.Scratch["gone.las"]);
        string handle = File.ReadAllText("Assets/one.pointcloud");
        EditorUtility.s_agrees = agrees;

        Look();
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(agrees ? 2 : 0));
        m_project.UpdateToTheEnd();
        Updates();

        Assert.That(EditorUtility.s_dialogs.Single(), Does.StartWith("2 point clouds have").And.Contains("of 1 other"));
        Assert.That(Directory.GetDirectories("PointClouds").Select(Path.GetFileName),
            Is.EquivalentTo(agrees ? new[] { "one.fastpoints", "two.fastpoints" } : new string[0]));
        Assert.That(File.Exists("PointClouds/.gitignore"));
        Assert.That(File.ReadAllText("Assets/one.pointcloud"), Is.EqualTo(handle), "nothing to commit");
    }

    void Look() => ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
        () => !m_project.Imports.MissingData.IsSearchPending);

    [Test]
    public void Clone_Declined_AsksAboutLaterCloudsOnly()
    {
        Clone("one");
        Look();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1));
        AssemblyReloadEvents.Reload();
        SessionState.EraseString("FastPoints.MissingDataPrompt");
        Look();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1), "the next session");

        string pulled = File.ReadAllText("Assets/one.pointcloud").Replace("one.fastpoints", "two.fastpoints");
        File.WriteAllText("Assets/two.pointcloud", pulled);
        AssetDatabase.Refresh();
        Look();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(2));
        Assert.That(EditorUtility.s_dialogs[1], Does.StartWith("1 point clouds"));
        m_project.Imports.Convert("Assets/one.pointcloud");
        m_project.UpdateToTheEnd();
        Assert.That(Directory.GetDirectories("PointClouds").Select(Path.GetFileName), Is.EqualTo(new[] { "one.fastpoints" }));
    }

    [Test]
    public void Pull_CloudConvertedElsewhere_AsksIfItCanBeConvertedHere([Values] bool isHere)
    {
        m_project.Pull("one");
        if (!isHere)
            m_project.Scratch.Demo("one.las", 1000);
        EditorUtility.s_agrees = true;
        Look();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(isHere ? 1 : 0));
        m_project.UpdateToTheEnd();
        Look();
        m_project.Imports.Catalog.Refresh();
        Assert.That(m_project.Imports.Catalog.Clouds.Single().Manifest.Points, Is.EqualTo(isHere ? 3000 : 1000));
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(isHere ? 1 : 0));
    }

    [Test]
    public void Inspect_InPlayMode_WaitsForItsEnd()
    {
        Clone("one");
        EditorApplication.isPlaying = true;
        Assert.That(SpinWait.SpinUntil(() =>
        {
            m_project.Imports.Update(DateTime.UtcNow);
            return !m_project.Imports.MissingData.IsSearchPending;
        }, 500), Is.False);
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        EditorApplication.isPlaying = false;
        Look();
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1));
    }

    [Test]
    public void Inspect_Failing_IsReportedAndNotRetried()
    {
        Clone("one");
        string source = CloudHandle.FromJson(File.ReadAllText("Assets/one.pointcloud"), "").Sources[0];
        File.WriteAllText("Assets/one.pointcloud", File.ReadAllText("Assets/one.pointcloud").Replace(source, "a\\u0000b"));
        m_logged.Clear();
        Look();
        Assert.That(m_logged.Single(), Does.StartWith("Error: FastPoints: " + m_project.Paths.Clouds));
    }

    [Test]
    public void Inspect_ManyFiles_ReadsNoSizesAndCanBeCancelled()
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets");
        m_project.UpdateToTheEnd();
        CloudList Collect(bool isCancelled) => CloudList.Collect(m_project.Paths, m_project.Imports.Assets.All, new string[0],
            false, false, new CancellationToken(isCancelled));
        Assert.That((Collect(false).Rows.Single().State, Collect(false).Rows.Single().Bytes), Is.EqualTo(("converted", 0L)));
        Assert.That(() => Collect(true), Throws.InstanceOf<OperationCanceledException>());
    }

    [TestCase("the data")]
    [TestCase("the conversion")]
    public void Data_DeclinedByTheUser_AreNotAskedAboutAgain(string what)
    {
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("one.las", 1000), "Assets");
        if (what == "the conversion")
        {
            m_project.Imports.Cancel(m_project.Imports.RequestOf("Assets/one.pointcloud"));
        }
        else
        {
            m_project.UpdateToTheEnd();
            var inspector = UnityEditor.Editor.Of<CloudImporterEditor>(new HandleImporter { Path = "Assets/one.pointcloud" });
            (EditorUtility.s_agrees, GUILayout.Pressed) = (true, "Delete converted data");
            GUILayoutUtility.Send(new Event { type = EventType.Layout }, inspector.OnInspectorGUI);
            (GUILayout.Pressed, Event.current) = (null, null);
            UnityEngine.Object.DestroyImmediate(inspector);
        }
        EditorUtility.s_dialogs.Clear();
        SessionState.EraseString("FastPoints.MissingDataPrompt");
        Look();
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        Assert.That(Directory.Exists("PointClouds/one.fastpoints"), Is.False);
    }

    [Test]
    public void Clone_WithoutSources_IsReportedOnceAndNamed()
    {
        Clone("gone");
        File.Delete(m_project.Scratch["gone.las"]);
        m_logged.Clear();
        for (int i = 0; i < 2; i++)
        {
            SessionState.EraseString("FastPoints.MissingDataPrompt");
            Look();
        }
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        Assert.That(m_logged.Single(), Does.StartWith("Warning: FastPoints: 1 point clouds have").And.Contains("gone.las"));
    }

    [Test]
    public void Clone_AutoConvertOffOrBatchMode_AsksNothing([Values] bool isBatch)
    {
        Clone("one");
        (Application.isBatchMode, FastPointsSettings.instance.ConvertAtOnce) = (isBatch, isBatch);
        for (int i = 0; i < 3 || !isBatch && m_project.Imports.MissingData.IsSearchPending; i++)
            m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        if (isBatch)
            BatchConvert.All();
        Assert.That(EditorUtility.s_dialogs, Is.Empty);
        Assert.That(Directory.Exists("PointClouds/one.fastpoints"), Is.EqualTo(isBatch));
    }
}
