using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Editor;

public sealed class CloudDropTests : EditorFixture
{
    [TearDown]
    public void ClearScene() => SceneLoop.Clear();

    string[] Tiles(int count, int points = 1000)
    {
        string first = m_project.Scratch.Demo("tile 0000.las", points);
        return Enumerable.Range(0, count).Select(i =>
        {
            string tile = m_project.Scratch["tiles/tile " + i.ToString("0000") + ".las"];
            Directory.CreateDirectory(Path.GetDirectoryName(tile));
            File.Copy(first, tile);
            return tile;
        }).ToArray();
    }

    void Finish() => ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => !m_project.Imports.IsCreating);

    static void Drop(string[] paths, DropTarget target = null)
    {
        DragAndDrop.paths = paths;
        FastPointsSettings.instance.MaxCopiedMiB = 0;
        try
        {
            if (target == null)
                PointCloudDrops.OnProject("Assets", true);
            else
                PointCloudDrops.OnScene(target, true);
        }
        finally
        {
            FastPointsSettings.instance.MaxCopiedMiB = 64;
        }
    }

    [Test]
    public void Drop_SeveralFiles_AsksOnceAndRemembers()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        EditorUtility.s_answer = 2;
        Drop(Tiles(3));
        Assert.That(EditorUtility.s_asked, Is.Zero, "the mouse button is still down");
        Finish();
        Assert.That(AssetDatabase.FindAssets("t:PointCloudAsset"), Has.Length.EqualTo(3));
        Assert.That(m_project.Asset("Assets/tile 0001.pointcloud").Points, Is.EqualTo(1000), "its header was read");
        AssemblyReloadEvents.Reload();
        EditorUtility.s_answer = -1;
        Drop(Directory.GetFiles(m_project.Scratch["tiles"]));
        Finish();
        Assert.That(EditorUtility.s_asked, Is.EqualTo(1));
        Assert.That(m_project.Asset("Assets/tile 0001 2.pointcloud"), Is.Not.Null);
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void Drop_AsOneCloud_CreatesOneHandleNamedAfterTheFolder()
    {
        EditorUtility.s_answer = 0;
        Drop(Tiles(3).Reverse().ToArray(), new DropTarget());
        Finish();
        var cloud = SceneLoop.Find<PointCloud>().Single();
        Assert.That(AssetDatabase.GetAssetPath(cloud.Cloud), Is.EqualTo("Assets/tiles.pointcloud"));
        Assert.That(SceneLoop.Find<PointCloudOrigin>(), Is.Empty);
        m_project.UpdateToTheEnd();
        Assert.That(cloud.Cloud.Points, Is.EqualTo(3000));
        Assert.That(cloud.Cloud.ProjectSources.Select(Path.GetFileName), Is.Ordered);
    }

    [Test]
    public void Drop_Cancelled_CreatesNothingAndAsksAgain()
    {
        EditorUtility.s_answer = 1;
        Drop(Tiles(2));
        Finish();
        Assert.That(AssetDatabase.FindAssets("t:PointCloudAsset"), Is.Empty);
        Assert.That(FastPointsSettings.instance.SeveralFiles, Is.EqualTo(SeveralFiles.Ask));
    }

    /// <summary>Octrees are never merged: nobody needs to be asked.</summary>
    [Test]
    public void Drop_WithAnOctree_CreatesSeparateAssetsWithoutAsking()
    {
        Drop(Tiles(2).Append(m_project.Copc("tile.copc.laz")).ToArray());
        Finish();
        Assert.That(AssetDatabase.FindAssets("t:PointCloudAsset"), Has.Length.EqualTo(3));
    }

    /// <summary>An unreadable file still gets an asset, like a single file; showing it reports why.</summary>
    [Test]
    public void Drop_OneDamagedFile_CreatesAssetsForAll()
    {
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        FastPointsSettings.instance.ConvertAtOnce = false;
        var tiles = Tiles(3);
        File.WriteAllText(tiles[1], "LASF");
        Drop(tiles);
        Finish();
        Assert.That(m_project.Asset("Assets/tile 0001.pointcloud").Points, Is.EqualTo(-1));
        Assert.That(m_project.Asset("Assets/tile 0002.pointcloud").Points, Is.EqualTo(1000));
    }

    [Test]
    public void Reload_DuringADrop_EndsItsProgressAndReportsIt()
    {
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        Drop(Tiles(20));
        m_project.Imports.Update(DateTime.UtcNow);
        Assert.That(m_project.Imports.IsCreating, Is.True);
        AssemblyReloadEvents.Reload();
        Assert.That(Progress.Entries.All(e => e.HasEnded), Is.True);
        Assert.That(m_logged.Single(), Does.Contain("broke off the import of 20 point clouds"));
    }

    [TestCase(40)]
    [TestCase(1000, Category = "Large")]
    public void Drop_Many_TakesLinearTime(int count)
    {
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        m_project.Imports.CreateAsset(m_project.Scratch.Demo("first.las", 200_000), "Assets");
        var queue = m_project.Imports.Queue;
        ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow),
            () => queue.Session?.State == ConversionState.Building);
        // A paused request would let the others go first.
        queue.Session.Pause();
        var tiles = Tiles(count);
        int saves = queue.SaveCount;
        (AssetDatabase.s_loads, AssetDatabase.s_searches, AssetDatabase.s_batches) = (0, 0, 0);

        var (whole, slice) = (Stopwatch.StartNew(), new Stopwatch());
        var slices = new List<double>();
        Drop(tiles, new DropTarget());
        ImportProject.Updates(() =>
        {
            slice.Restart();
            m_project.Imports.Update(DateTime.UtcNow);
            slices.Add(slice.Elapsed.TotalMilliseconds);
        }, () => !m_project.Imports.IsCreating);
        TestContext.Out.WriteLine($"{count} files: {whole.Elapsed.TotalSeconds:0.00} s; longest updates " +
            string.Join(", ", slices.OrderByDescending(s => s).Take(4).Select(s => s.ToString("0.0"))) + " ms");

        Assert.That(queue.Requests, Has.Count.EqualTo(1 + count));
        Assert.That(queue.SaveCount - saves, Is.EqualTo(1), "the list");
        Assert.That(AssetDatabase.s_searches, Is.LessThanOrEqualTo(1));
        if (count < 100)
            ImportProject.Updates(() => m_project.Imports.Update(DateTime.UtcNow), () => !m_project.Imports.Thumbnails.IsDrawing);
        // Each is loaded when it is imported, shown, and its picture is shown.
        Assert.That(AssetDatabase.s_loads, Is.LessThanOrEqualTo(3 * count + 10));
        Assert.That(AssetDatabase.s_searches, Is.LessThanOrEqualTo(1));
        Assert.That(SceneLoop.Find<PointCloud>(), Has.Length.EqualTo(count));
        queue.Cancel(queue.CurrentRequest);
    }

    /// <summary>Pictures that come faster than Unity imports are shown together.</summary>
    [Test]
    public void Assets_CopiedIntoTheProject_AreQueuedTogether()
    {
        foreach (string tile in Tiles(10))
            File.Copy(tile, Path.Combine("Assets", Path.GetFileName(tile)));
        AssetDatabase.Refresh();
        Assert.That(m_project.Imports.Queue.Requests, Has.Count.EqualTo(10));
        Assert.That(AssetDatabase.s_batches, Is.EqualTo(2), "when they are found, and with the package's importer");
    }

    [Test]
    public void Assets_MovedAndDeleted_AreFoundByTheirCloud()
    {
        FastPointsSettings.instance.ConvertAtOnce = false;
        var asset = m_project.Imports.CreateAsset(Tiles(1)[0], "Assets");
        string cloud = m_project.Paths.Absolute(asset.ProjectPath);
        Assert.That(m_project.Imports.Assets.Of(cloud.ToUpperInvariant()), Is.EqualTo(new[] { "Assets/tile 0000.pointcloud" }));
        File.Copy("Assets/tile 0000.pointcloud", "Assets/copy.pointcloud");
        AssetDatabase.Refresh();
        Assert.That(m_project.Imports.Assets.Of(cloud), Has.Count.EqualTo(2));
        m_project.Imports.Assets.Update(new string[0], new string[0], new[] { "Assets/copy.pointcloud" }, new string[0]);
        File.Delete("Assets/tile 0000.pointcloud");
        AssetDatabase.Refresh();
        Assert.That(m_project.Imports.Assets.Of(cloud), Is.Empty);
        Assert.That(m_project.Imports.Assets.Clouds, Is.Empty);
    }

    static PointCloudAsset Known(string name, double3 at, string crs = "EPSG:25832")
    {
        var asset = ScriptableObject.CreateInstance<PointCloudAsset>();
        asset.name = name;
        (asset.BoundsMin, asset.BoundsMax, asset.MetresPerUnit, asset.Crs) = (at, at + 100, 1, crs);
        return asset;
    }

    [Test]
    public void OnScene_SeveralAssets_ShareAnOriginAndOneUndo()
    {
        DragAndDrop.objectReferences = new UnityEngine.Object[]
        {
            Known("a", new double3(690_000, 5_330_000, 500)), Known("b", new double3(690_100, 5_330_000, 500)),
        };
        PointCloudDrops.OnScene(new Vector3(4, 5, 6), null, true);
        var origin = SceneLoop.Find<PointCloudOrigin>().Single();
        Assert.That(origin.PositionGeo, Is.EqualTo(new double3(690_050, 5_330_050, 500)));
        Assert.That(SceneLoop.Find<PointCloud>().Select(c => c.Origin), Is.All.SameAs(origin));
        Assert.That(SceneLoop.Find<PointCloud>().Select(c => c.transform.position), Is.All.EqualTo(Vector3.zero));

        // The next ones lie beside them.
        DragAndDrop.objectReferences = new UnityEngine.Object[] { Known("c", new double3(690_200, 5_330_000, 500)) };
        PointCloudDrops.OnScene(new Vector3(4, 5, 6), null, true);
        Assert.That(SceneLoop.Find<PointCloud>().Select(c => c.Origin), Has.Exactly(3).SameAs(origin));
        Undo.PerformUndo();
        Undo.PerformUndo();
        Assert.That(SceneLoop.Objects, Is.Empty);
    }

    [Test]
    public void Drop_WhileTheUserWorks_IsItsOwnUndoStepAndSelectsOnce()
    {
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        FastPointsSettings.instance.ConvertAtOnce = false;
        var mine = new GameObject("mine");
        void Move(float x)
        {
            Undo.IncrementCurrentGroup();
            Undo.RecordObject(mine.transform, "Move");
            mine.transform.position = new Vector3(x, 0, 0);
            Selection.activeObject = mine;
        }
        Drop(Tiles(5), new DropTarget());
        Move(1);
        int moves = 1, selected = 0;
        ImportProject.Updates(() =>
        {
            m_project.Imports.Update(DateTime.UtcNow);
            selected += Selection.activeObject != mine ? 1 : 0;
            if (m_project.Imports.IsCreating)
                Move(++moves);
        }, () => !m_project.Imports.IsCreating);
        Assert.That(selected, Is.EqualTo(1));
        Assert.That(SceneLoop.Find<PointCloud>(), Has.Length.EqualTo(5));
        // Without an event between: still not part of what came with the drop.
        Undo.RecordObject(mine.transform, "Move");
        mine.transform.position = new Vector3(-1, 0, 0);

        Undo.PerformUndo();
        Assert.That((mine.transform.position.x, SceneLoop.Find<PointCloud>().Length), Is.EqualTo(((float)moves, 5)));
        Undo.PerformUndo();
        Assert.That((mine.transform.position.x, SceneLoop.Find<PointCloud>().Length), Is.EqualTo(((float)moves, 0)));
        Assert.That(SceneLoop.Find<PointCloudOrigin>(), Is.Empty);
        Undo.PerformUndo();
        Assert.That(mine.transform.position.x, Is.EqualTo((float)(moves - 1)), "a step of the user's alone");
    }

    [TestCase(true)]
    [TestCase(false)]
    public void Drop_TargetDestroyedMeanwhile_ShowsNothing(bool isScene)
    {
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        FastPointsSettings.instance.ConvertAtOnce = false;
        var scene = new Scene { Number = 7, Path = "one" };
        SceneManager.s_open.Add(scene);
        var target = new GameObject("target");
        Drop(Tiles(3), isScene ? new DropTarget { Scene = scene } : new DropTarget { Parent = target.transform });
        m_project.Imports.Update(DateTime.UtcNow);
        UnityEngine.Object.DestroyImmediate(target);
        SceneManager.s_open.Remove(scene);
        SceneManager.s_closed.Add(7);
        Finish();
        Assert.That(AssetDatabase.FindAssets("t:PointCloudAsset"), Has.Length.EqualTo(3));
        Assert.That(SceneLoop.Objects, Is.Empty);
        Assert.That(m_logged, Is.Empty);
    }

    [Test]
    public void OnScene_OriginWithoutAPosition_UndoClearsThePosition()
    {
        var origin = new GameObject("origin").AddComponent<PointCloudOrigin>();
        DragAndDrop.objectReferences = new UnityEngine.Object[] { Known("a", new double3(690_000, 5_330_000, 500)) };
        PointCloudDrops.OnScene(null, origin.transform, true);
        Assert.That(origin.HasPosition, Is.True);
        Undo.PerformUndo();
        Assert.That(origin.HasPosition, Is.False);
    }

    [Test]
    public void OnHierarchy_DropPosition_SetsParentSiblingAndScene()
    {
        System.Runtime.CompilerServices.RuntimeHelpers.RunClassConstructor(typeof(PointCloudDrops).TypeHandle);
        Scene first = new Scene { Number = 7, Path = "one" }, second = new Scene { Number = 9, Path = "two" };
        SceneManager.s_open.AddRange(new[] { first, second });
        SceneManager.s_active = first;
        var (above, on, child) = (new GameObject("above"), new GameObject("on"), new GameObject("child"));
        child.transform.SetParent(on.transform, false);
        SceneManager.MoveGameObjectToScene(above, second);
        SceneManager.MoveGameObjectToScene(on, second);
        (EditorUtility.s_objects[1], EditorUtility.s_objects[2]) = (on, child);
        DragAndDrop.objectReferences = new UnityEngine.Object[] { Known("a", 0) };
        GameObject Drop(int id, HierarchyDropFlags flags, Transform parent = null)
        {
            DragAndDrop.Drop<DragAndDrop.HierarchyDropHandler>(id, flags, parent, true);
            return (GameObject)Selection.activeObject;
        }

        var made = Drop(1, HierarchyDropFlags.DropUpon);
        Assert.That(made.transform.parent, Is.SameAs(on.transform));
        made = Drop(1, HierarchyDropFlags.DropBetween | HierarchyDropFlags.DropAbove);
        Assert.That((made.scene == second, made.transform.parent, made.transform.GetSiblingIndex()),
            Is.EqualTo((true, (Transform)null, 1)));
        made = Drop(2, HierarchyDropFlags.DropBetween | HierarchyDropFlags.DropAbove | HierarchyDropFlags.DropAfterParent);
        Assert.That((made.transform.parent, made.transform.GetSiblingIndex()), Is.EqualTo((on.transform, 0)));
        made = Drop(2, HierarchyDropFlags.DropBetween);
        Assert.That((made.transform.parent, made.transform.GetSiblingIndex()), Is.EqualTo((on.transform, 2)));
        made = Drop(9, HierarchyDropFlags.DropUpon);
        Assert.That((made.scene == second, made.transform.parent), Is.EqualTo((true, (Transform)null)));
        made = Drop(0, HierarchyDropFlags.None, on.transform);
        Assert.That(made.transform.parent, Is.SameAs(on.transform));
        made = Drop(0, HierarchyDropFlags.None);
        Assert.That(made.scene == first, Is.True);

        var standard = ObjectFactory.s_defaultParent = new GameObject("default parent").transform;
        standard.position = new Vector3(100, 0, 0);
        on.transform.position = new Vector3(0, 5, 0);
        Assert.That(Drop(1, HierarchyDropFlags.DropUpon).transform.position, Is.EqualTo(new Vector3(0, 5, 0)));
        made = Drop(7, HierarchyDropFlags.DropUpon);
        Assert.That((made.transform.parent, made.transform.position), Is.EqualTo(((Transform)null, new Vector3(0, 0, 0))));
        ObjectFactory.s_defaultParent = null;
    }
}
