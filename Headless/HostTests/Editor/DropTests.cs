namespace FastPoints.HostTests.Editor;

public sealed class DropTests
{
    EditorProject m_project;

    [SetUp]
    public void OpenProject() => m_project = new EditorProject();

    [TearDown]
    public void CloseProject() => m_project.Dispose();

    string Made(string name, int bytes = 10)
    {
        string path = m_project.Scratch[name];
        Directory.CreateDirectory(Path.GetDirectoryName(path));
        File.WriteAllBytes(path, new byte[bytes]);
        return path;
    }

    DropKind Of(params string[] paths) => CloudSources.DropKindOf(paths, m_project.Paths, 100);

    [Test]
    public void Of_DroppedFiles_DecidesByKindAndSize()
    {
        string small = Made("a.las"), large = Made("b.LAZ", 101), scan = Made("c.e57"), text = Made("d.txt");
        Assert.That(Of(small), Is.EqualTo(DropKind.Copy));
        Assert.That(Of(large), Is.EqualTo(DropKind.Handle));
        Assert.That(Of(small, large), Is.EqualTo(DropKind.Handle));
        Assert.That(Of(scan), Is.EqualTo(DropKind.Handle), "no importer takes it");
        Assert.That(Of(small, text), Is.EqualTo(DropKind.None));
        Assert.That(Of(), Is.EqualTo(DropKind.None));
        Assert.That(Of(Made("f.las", 60), Made("g.las", 60)), Is.EqualTo(DropKind.Handle), "together they are large");
        Assert.That(Of(Made("project/Assets/e.las")), Is.EqualTo(DropKind.None), "it is in the project");
    }

    [TestCase("mesh.ply", true)]
    [TestCase("MESH.PLY", true)]
    [TestCase("points.ply", false)]
    public void Of_DroppedMesh_IsIgnored(string name, bool isMesh)
    {
        File.WriteAllText(m_project.Scratch[name], "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\n" +
            "element face " + (isMesh ? 1 : 0) + "\r\nproperty list uchar int vertex_indices\r\nend_header\r\n");
        Assert.That(Of(m_project.Scratch[name]), Is.EqualTo(isMesh ? DropKind.None : DropKind.Handle));
        DragAndDrop.paths = new[] { m_project.Scratch[name] };
        Assert.That(PointCloudDrops.OnScene(null, null, false),
            Is.EqualTo(isMesh ? DragAndDropVisualMode.None : DragAndDropVisualMode.Copy));
    }

    [Test]
    public void Of_DroppedFileOfAnotherImporter_IsIgnored()
    {
        ImporterTable.Add(typeof(ClaimingImporter), new[] { "ply", "e57" }, null);
        Assert.That(Of(Made("a.ply")), Is.EqualTo(DropKind.None));
        Assert.That(Of(Made("b.e57")), Is.EqualTo(DropKind.None));
        Assert.That(Of(Made("c.las", 101)), Is.EqualTo(DropKind.Handle));
        DragAndDrop.paths = new[] { m_project.Scratch["b.e57"] };
        Assert.That(PointCloudDrops.OnProject("Assets", true), Is.EqualTo(DragAndDropVisualMode.None));
    }

    [Test]
    public void Drag_SameFiles_AreInspectedOnceAndAgainOnDrop()
    {
        string path = Made("a.e57");
        DragAndDrop.paths = new[] { path };
        Assert.That(PointCloudDrops.OnScene(null, null, false), Is.EqualTo(DragAndDropVisualMode.Copy));
        File.Delete(path);
        DragAndDrop.paths = new[] { path };
        Assert.That(PointCloudDrops.OnScene(null, null, false), Is.EqualTo(DragAndDropVisualMode.Copy));
        Assert.That(PointCloudDrops.OnProject("Assets", false), Is.EqualTo(DragAndDropVisualMode.Link));
        DragAndDrop.paths = new[] { Made("b.txt") };
        Assert.That(PointCloudDrops.OnScene(null, null, false), Is.EqualTo(DragAndDropVisualMode.None), "other files");
        DragAndDrop.paths = new[] { path };
        Assert.That(PointCloudDrops.OnScene(null, null, true), Is.EqualTo(DragAndDropVisualMode.None));
    }

    [Test]
    public void Of_DroppedFolders_AcceptsOctreesOnly()
    {
        Made("potree/metadata.json");
        Assert.That(Of(m_project.Scratch["potree"]), Is.EqualTo(DropKind.None), "any folder may have one");
        Made("potree/octree.bin");
        Made("ept/ept.json");
        Made("models/mesh.fbx");
        Made("done.fastpoints/cloud.json");
        Assert.That(Of(m_project.Scratch["potree"], m_project.Scratch["ept"], m_project.Scratch["done.fastpoints"]),
            Is.EqualTo(DropKind.Handle));
        Assert.That(Of(m_project.Scratch["models"]), Is.EqualTo(DropKind.None));
    }

    [Test]
    public void Handlers_OfAllThreeWindows_Exist()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(PointCloudDrops).TypeHandle);
        Assert.That(DragAndDrop.Handlers.Select(h => h.GetType().Name), Is.EquivalentTo(new[]
        {
            "ProjectBrowserDropHandler", "HierarchyDropHandler", "SceneDropHandler",
        }));
        Assert.That(() => DragAndDrop.AddDropHandler((DragAndDrop.SceneDropHandler)DragAndDrop.Handlers
            .Single(h => h is DragAndDrop.SceneDropHandler)), Throws.Exception, "a handler is there once");
    }

    [Test]
    public void Drop_AnotherPackagesHandler_HasPrecedenceIfItHandlesTheDrop()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(PointCloudDrops).TypeHandle);
        DragAndDrop.paths = new[] { Made("scan.e57") };
        var theirs = DragAndDropVisualMode.None;
        DragAndDrop.ProjectBrowserDropHandler another = (_, _, _) => theirs;
        DragAndDrop.AddDropHandler(another);
        try
        {
            DragAndDropVisualMode Drop() => DragAndDrop.Drop<DragAndDrop.ProjectBrowserDropHandler>(0, "Assets", false);
            Assert.That(Drop(), Is.EqualTo(DragAndDropVisualMode.Link));
            theirs = DragAndDropVisualMode.Move;
            Assert.That(Drop(), Is.EqualTo(DragAndDropVisualMode.Move));
            theirs = DragAndDropVisualMode.None;
            DragAndDrop.paths = new[] { Made("picture.png") };
            Assert.That(Drop(), Is.EqualTo(DragAndDropVisualMode.None), "Unity's own is asked");
        }
        finally
        {
            DragAndDrop.Handlers.Remove(another);
        }
    }

    [Test]
    public void OnProject_FolderOfAPackageThatIsNotInTheProject_IsLeftToUnity()
    {
        DragAndDrop.paths = new[] { Made("scan.e57") };
        Assert.That(PointCloudDrops.OnProject("Packages/com.unity.entities", true), Is.EqualTo(DragAndDropVisualMode.None));
        Assert.That(PointCloudDrops.OnProject("Assets", false), Is.EqualTo(DragAndDropVisualMode.Link));
    }

    [Test]
    public void OnScene_Drop_IsUndone()
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.name = "scan";
        DragAndDrop.objectReferences = new UnityEngine.Object[] { asset };
        PointCloudDrops.OnScene(null, null, true);
        var scene = (GameObject)Selection.activeObject;
        Undo.PerformUndo();
        Assert.That(scene == null, Is.True);
    }

    [Test]
    public void OnScene_AssetOfTheProject_BecomesAGameObject()
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.name = "scan";
        DragAndDrop.objectReferences = new UnityEngine.Object[] { asset };
        Assert.That(PointCloudDrops.OnScene(null, null, false), Is.EqualTo(DragAndDropVisualMode.Copy));
        Selection.activeObject = null;

        PointCloudDrops.OnScene(new Vector3(4, 5, 6), null, true);

        var scene = (GameObject)Selection.activeObject;
        Assert.That(scene.name, Is.EqualTo("scan"));
        Assert.That(scene.transform.position.y, Is.EqualTo(5));
        Assert.That(scene.GetComponent<FastPoints.Entities.PointCloud>().Cloud, Is.SameAs(asset));
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void OnScene_InASubscene_CreatesAnAuthoringComponent()
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        DragAndDrop.objectReferences = new UnityEngine.Object[] { asset };
        var target = new DropTarget { Scene = new UnityEngine.SceneManagement.Scene { Number = 7, isSubScene = true } };
        PointCloudDrops.OnScene(target, true);
        var scene = (GameObject)Selection.activeObject;
        Assert.That(scene.GetComponent<PointCloudAuthoring>().Cloud, Is.SameAs(asset));
        Assert.That(scene.GetComponent<FastPoints.Entities.PointCloud>() == null, Is.True);
        UnityEngine.Object.DestroyImmediate(scene);
    }

    [Test]
    public void OnScene_SomethingElse_IsLeftToOthers()
    {
        DragAndDrop.paths = new[] { Made("picture.png") };
        Assert.That(PointCloudDrops.OnScene(null, null, false), Is.EqualTo(DragAndDropVisualMode.None));
    }

    [Test]
    public void Postprocessor_UnclaimedFile_GetsTheImporter()
    {
        ImporterTable.Add(typeof(ClaimingImporter), new[] { "ply" }, null);
        foreach (string name in new[] { "a.las", "b.LAZ", "theirs.ply", "c.txt" })
            Made("project/Assets/" + name);
        AssetDatabase.Refresh();
        Assert.That(AssetDatabase.Overrides.Keys, Is.EquivalentTo(new[] { "Assets/a.las", "Assets/b.LAZ" }));
        Assert.That(AssetDatabase.Overrides.Values, Is.All.EqualTo(typeof(PointFileImporter)));
        Assert.That(m_project.Asset("Assets/a.las"), Is.Not.Null, "it is imported with it at once");
    }

    [Test]
    public void PointFile_InAssets_IsIdentifiedByItsGuid()
    {
        File.Copy(m_project.Scratch.Demo("scan.las", 1000), "Assets/scan.las");
        AssetDatabase.Refresh();
        var asset = m_project.Asset("Assets/scan.las");
        Assert.That(asset.ProjectSources,
            Is.EqualTo(new[] { PointCloudPaths.AssetPrefix + AssetDatabase.AssetPathToGUID("Assets/scan.las") }));
        Assert.That(asset.Paths.FullSources(), Is.EqualTo(new[] { Path.GetFullPath("Assets/scan.las") }));
    }

    [Test]
    public void PointFileImporter_ExtensionClaimedByAnother_IsLeftToIt()
    {
        ImporterTable.Add(typeof(ClaimingImporter), new[] { "ply", "las", "laz" }, null);
        foreach (string extension in CloudSources.ImportedExtensions)
            Assert.That(AssetDatabase.GetDefaultImporter("Assets/a." + extension), Is.EqualTo(typeof(ClaimingImporter)));
    }

    /// <summary>Claimed for nobody, so that another package's importer for the same extension goes on working.</summary>
    [Test]
    public void PointFileImporter_Extensions_AreOfferedAndNotClaimed()
    {
        var attribute = typeof(PointFileImporter).GetCustomAttribute<ScriptedImporterAttribute>();
        Assert.That(attribute.fileExtensions, Is.Null);
        Assert.That(attribute.overrideFileExtensions, Is.EqualTo(CloudSources.ImportedExtensions));
        Assert.That(attribute.AllowCaching, Is.True);
    }

    sealed class ClaimingImporter : ScriptedImporter
    {
        public override void OnImportAsset(AssetImportContext ctx)
        {
            var made = ScriptableObject.CreateInstance<ScriptableObject>();
            ctx.AddObjectToAsset("theirs", made);
            ctx.SetMainObject(made);
        }
    }
}
