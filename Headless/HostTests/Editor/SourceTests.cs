namespace FastPoints.HostTests.Editor;

public sealed class SourceTests : EditorFixture
{
    [TearDown]
    public void Restore()
    {
        (EditorUtility.s_file, EditorUtility.s_folder, EditorUtility.s_agrees) = ("", "", false);
        (GUILayout.Pressed, Event.current) = (null, null);
        EditorUtility.s_dialogs.Clear();
        FastPointsUserSettings.instance.SourceRoot = "";
        PointCloudPaths.SourceRoot = "";
    }

    [Test]
    public void Paths_AreRelativeWhereTheyCanBe()
    {
        var paths = new ProjectPaths("/team/game/unity", sourceRoot: "/scans");
        foreach (var (full, stored) in new[]
        {
            ("/team/game/unity/Assets/a.las", "Assets/a.las"), ("/team/game/raw/a.las", "../raw/a.las"),
            ("/scans/city/a.las", "${FASTPOINTS_SOURCES}/city/a.las"), ("/other/a.las", "/other/a.las"),
            ("/scans2/a.las", "/scans2/a.las"),
        })
        {
            Assert.That(paths.Stored(full), Is.EqualTo(stored));
            Assert.That(paths.Absolute(stored), Is.EqualTo(full));
        }
        Assert.That(paths.StoredShared("/scans/clouds"), Is.EqualTo("/scans/clouds"), "everybody's");
        Assert.That(new ProjectPaths("/game").Stored("/raw/a.las"), Is.EqualTo("/raw/a.las"), "all files are below the root");
        Assert.That(new ProjectPaths("/team/game/unity").Absolute("${FASTPOINTS_SOURCES}/a.las"),
            Does.Contain("FASTPOINTS_SOURCES"), "says what is missing");
    }

    [Test]
    public void Root_OfAnotherUser_FindsTheSameAssetsSources()
    {
        Directory.CreateDirectory(m_project.Scratch["ann/city"]);
        m_project.Scratch.Demo("ann/city/scan.las", 2000);
        PointCloudImports.SwitchSourceRoot(m_project.Scratch["ann"]);
        var asset = m_project.Imports.CreateAsset(m_project.Scratch["ann/city/scan.las"], "Assets");
        Assert.That(asset.ProjectSources, Is.EqualTo(new[] { "${FASTPOINTS_SOURCES}/city/scan.las" }));
        Assert.That(File.ReadAllText("Assets/scan.pointcloud"), Does.Not.Contain("ann"));
        Assert.That(File.ReadAllText("UserSettings/FastPoints.asset"), Does.Contain("ann"));

        m_project.Imports.Update(DateTime.UtcNow);
        Directory.Move(m_project.Scratch["ann"], m_project.Scratch["ben"]);
        PointCloudImports.SwitchSourceRoot(m_project.Scratch["ben"]);

        Assert.That(asset.Paths.FullSources(), Is.EqualTo(new[] { m_project.Scratch["ben/city/scan.las"] }));
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => asset.Points == 2000);
    }

    CloudImporterEditor InspectorOf(string asset)
    {
        var inspector = UnityEditor.Editor.Of<CloudImporterEditor>(new HandleImporter { Path = asset });
        return inspector;
    }

    void Press(CloudImporterEditor inspector, string button)
    {
        GUILayoutUtility.Send(new Event { type = EventType.Layout }, inspector.OnInspectorGUI);
        GUILayout.Pressed = button;
        GUILayoutUtility.Send(new Event { type = EventType.MouseUp }, inspector.OnInspectorGUI);
        GUILayout.Pressed = null;
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Locate_OneOfAFolder_OffersToLocateTheOthers(bool agrees)
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        foreach (string name in new[] { "old/scans/a.las", "old/scans/b.las", "old/c.las", "stays.las" })
        {
            Directory.CreateDirectory(Path.GetDirectoryName(m_project.Scratch[name]));
            m_project.Scratch.Demo(name, 500);
            m_project.Imports.CreateAsset(m_project.Scratch[name], "Assets");
        }
        var a = m_project.Asset("Assets/a.pointcloud");
        string guid = AssetDatabase.AssetPathToGUID("Assets/a.pointcloud");
        Directory.Move(m_project.Scratch["old"], m_project.Scratch["new"]);
        File.Delete(m_project.Scratch["new/c.las"]);
        (EditorUtility.s_file, EditorUtility.s_agrees) = (m_project.Scratch["new/scans/a.las"], agrees);

        var inspector = InspectorOf("Assets/a.pointcloud");
        Press(inspector, "Locate source...");

        Assert.That(a.Paths.FullSources(), Is.EqualTo(new[] { m_project.Scratch["new/scans/a.las"] }));
        Assert.That(AssetDatabase.AssetPathToGUID("Assets/a.pointcloud"), Is.EqualTo(guid));
        Assert.That(m_project.Asset("Assets/a.pointcloud"), Is.SameAs(a), "references stay");
        string Of(string asset) => m_project.Paths.Absolute(HandleFile.Read("Assets/" + asset + ".pointcloud").Sources[0]);
        Assert.That(EditorUtility.s_dialogs.Single(), Does.Contain("of 1 other assets"));
        Assert.That(Of("b"), Is.EqualTo(m_project.Scratch[(agrees ? "new" : "old") + "/scans/b.las"]));
        Assert.That(Of("c"), Is.EqualTo(m_project.Scratch["old/c.las"]), "it is not there either");
        Assert.That(Of("stays"), Is.EqualTo(m_project.Scratch["stays.las"]));
        EditorUtility.s_file = "";
        Press(inspector, "Locate source...");
        Assert.That(EditorUtility.s_dialogs, Has.Count.EqualTo(1), "there is no such button any more");
        UnityEngine.Object.DestroyImmediate(inspector);
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void Inspector_OfSeveral_ConvertsAll()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        foreach (string name in new[] { "a", "b" })
            m_project.Imports.CreateAsset(m_project.Scratch.Demo(name + ".las", 500), "Assets");
        var inspector = InspectorOf("Assets/a.pointcloud");
        inspector.Targets = new[] { inspector.target, new HandleImporter { Path = "Assets/b.pointcloud" } };
        GUILayoutUtility.Repaint(inspector.OnInspectorGUI);
        Assert.That(m_project.Imports.Queue.Requests, Is.Empty);
        Press(inspector, "Convert all 2");
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(2));
        UnityEngine.Object.DestroyImmediate(inspector);
        Assert.That(typeof(CloudImporterEditor).IsDefined(typeof(CanEditMultipleObjects), false));
    }

    [Test]
    public void Locate_OtherFileThanConverted_IsReported()
    {
        string source = m_project.Scratch.Demo("scan.las", 500);
        m_project.Imports.CreateAsset(source, "Assets");
        m_project.UpdateToTheEnd();
        File.Delete(source);
        EditorUtility.s_file = m_project.Scratch.Demo("other.las", 700);
        CloudRelocation.Prompt(m_project.Imports, "Assets/scan.pointcloud", source);
        Assert.That(m_project.Paths.Absolute(m_project.Imports.HandleOf("Assets/scan.pointcloud").Sources[0]),
            Is.EqualTo(EditorUtility.s_file));
        Assert.That(m_logged.Single(), Does.Contain("another file"));
    }

    [Test]
    public void Locate_FolderWithADotInItsName_AsksForAFolder()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        Directory.CreateDirectory(m_project.Scratch["scan.v2"]);
        m_project.Scratch.Demo("scan.v2/a.las", 500);
        m_project.Imports.CreateAsset(m_project.Scratch["scan.v2"], "Assets");
        string asset = AssetDatabase.GUIDToAssetPath(AssetDatabase.FindAssets("t:PointCloudAsset").Single());
        Directory.Move(m_project.Scratch["scan.v2"], m_project.Scratch["scan.v3"]);
        EditorUtility.s_folder = m_project.Scratch["scan.v3"];
        CloudRelocation.Prompt(m_project.Imports, asset, m_project.Scratch["scan.v2"]);
        Assert.That(m_project.Paths.Absolute(m_project.Imports.HandleOf(asset).Sources.Single()),
            Is.EqualTo(m_project.Scratch["scan.v3"]));
    }
}
