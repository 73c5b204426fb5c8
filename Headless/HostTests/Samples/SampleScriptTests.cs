using FastPoints.Samples.AskAScan;
using FastPoints.Samples.EditAndExport;
using FastPoints.Samples.RemoteCloud;
using FastPoints.Samples.StreamingFlight;

namespace FastPoints.HostTests.Samples;

public sealed class SampleScriptTests
{
    SampleWorld m_world;

    [SetUp]
    public void Play() => m_world = new SampleWorld();

    [TearDown]
    public void Stop()
    {
        UnityEngine.Debug.s_sink = null;
        (RemoteAccess.CacheFolder, RemoteAccess.CacheBytes) = (null, 4L << 30);
        _ = RangeCache.Current; // Closes the one before.
        m_world.Dispose();
    }

    [Test]
    public void LoadFromDisk_FileOnDisk_IsConvertedOnceAndShown()
    {
        string source = m_world.Scratch.Demo("scan.laz", 5000), target = m_world.Scratch["scan.fastpoints"];
        var load = m_world.Add<LoadFromDisk>(l => l.Source = source);

        m_world.Frames(() => load.IsDone);
        m_world.Settle();

        Assert.That(load.Status, Is.EqualTo(target));
        Assert.That(m_world.Group.Stats.DrawnPoints, Is.EqualTo(5000));
        Assert.That(CliCall.Of("verify", target, "--against", source, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        var made = Directory.GetFiles(target, "*", SearchOption.AllDirectories).Select(File.GetLastWriteTimeUtc).Max();
        load.enabled = false;
        load.enabled = true;
        m_world.Frames(() => load.IsDone);
        Assert.That(Directory.GetFiles(target, "*", SearchOption.AllDirectories).Select(File.GetLastWriteTimeUtc).Max(),
            Is.EqualTo(made));
    }

    [Test]
    public void LoadFromDisk_NoFileGiven_ShowsTheStreet()
    {
        var street = new TextAsset
        {
            Content = File.ReadAllBytes(Path.Combine(Checkout.Repository.Root, SampleScan.PackagedPath)),
        };
        var load = m_world.Add<LoadFromDisk>(l => l.Street = street);

        m_world.Frames(() => load.IsDone);

        using var folder = CloudFolder.Open(m_world.Scratch["street.fastpoints"]);
        Assert.That(folder.Manifest.Points, Is.EqualTo(200_000));
    }

    [Test]
    public void LoadFromDisk_MissingFile_ReportsIt()
    {
        var logged = "";
        UnityEngine.Debug.s_sink = (_, text) => logged += text;
        var load = m_world.Add<LoadFromDisk>(l => l.Source = m_world.Scratch["absent.las"]);

        m_world.Frames(() => load.Status.Contains("absent.las"));
        m_world.Frame();

        Assert.That(logged, Does.Contain("absent.las"));
        Assert.That(load.IsDone, Is.False);
    }

    [Test]
    public void LoadFromDisk_DisabledMidway_LeavesNoFileOpen()
    {
        var load = m_world.Add<LoadFromDisk>(l => l.Source = m_world.Scratch.Demo(points: 20_000));
        m_world.Frames(() => load.Status.Contains('%'));
        load.enabled = false;
        // Windows refuses to delete open files; here the writer's lock shows it.
        load.enabled = true;
        m_world.Frames(() => load.IsDone);
        Assert.That(m_world.Scratch["demo.fastpoints"], Does.Exist);
    }

    [Test]
    public void OpenAddress_TypedAfterOneThatIsNotThere_ShowsItsPointsAndKeepsThem()
    {
        string cloud = m_world.Scratch.Converted("served/scan.fastpoints", 20_000);
        using var server = new RangeServer(m_world.Scratch["served"]);
        HttpFile.Register();
        Camera.main = new GameObject("eye").AddComponent<Camera>();
        var open = m_world.Add<OpenAddress>(o => o.Address = server.Of("absent.fastpoints?token=secret"));
        m_world.Frames(() => open.Status.Contains("404"));
        Assert.That(open.Status, Does.Contain("absent.fastpoints").And.Not.Contain("secret"));

        open.Address = " " + server.Of("scan.fastpoints");
        GUILayout.Pressed = "Open";
        typeof(OpenAddress).GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(open, null);
        GUILayout.Pressed = null;
        m_world.Settle();

        Assert.That(open.Status, Is.EqualTo("20,000 of 20,000 points"));
        Assert.That(open.GetComponent<FastPoints.Entities.PointCloud>().TryGetWorldBounds(out var bounds), Is.True);
        Assert.That((Camera.main.transform.position - bounds.center).magnitude,
            Is.EqualTo(bounds.size.magnitude).Within(0.1));
        Assert.That(RangeCache.Current.Folder, Does.StartWith(m_world.Scratch.Root));
        Assert.That(() => RangeCache.Current.Bytes, Is.Positive.After(5000, 10));
    }

    /// <summary>From 100 m above the cloud's middle, straight down; the pointer is where the camera looks.</summary>
    [Test]
    public void AskScan_PointerAndClicks_SayWhatIsThere()
    {
        string path = m_world.Scratch.Converted(points: 20_000);
        m_world.Add<FastPoints.Entities.PointCloud>(c => c.Path = path);
        m_world.Settle();
        var target = new RenderTexture(200, 100, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.None);
        var ask = m_world.Add<AskScan>(a =>
        {
            var camera = a.GetComponent<Camera>();
            (camera.targetTexture, camera.projectionMatrix) = (target, Matrix4x4.Perspective(60, 2, 0.1f, 1000));
            a.transform.SetPositionAndRotation(new Vector3(0, 100, 0), Quaternion.LookRotation(new Vector3(0, -1, 0.001f)));
            (a.RadiusPx, a.SphereMetres) = (10, 5);
        });
        void Gui(EventType type, float x)
        {
            Event.current = new Event { type = type, mousePosition = new Vector2(x, 50) };
            typeof(AskScan).GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(ask, null);
            Event.current = null;
        }
        Gui(EventType.Layout, 100);
        Assert.That(ask.Text, Does.StartWith("No point"), "nothing is copied yet");
        m_world.Frames(() => m_world.Group.Queries.IsComplete);
        Gui(EventType.Layout, 100);
        Assert.That(ask.Text, Does.Match(@"^Height -?[0-9.]+ m(, [0-9.]+ m over .*)?\n[1-9]\d* points within 5.00 m"));
        Gui(EventType.MouseDown, 100);
        m_world.Frames(() => ask.Text.Contains("Intensity  "));
        Gui(EventType.MouseDown, 150);
        m_world.Frames(() => ask.Text.Contains("Distance from the one before: "));
        Assert.That(ask.Text, Does.Not.EndWith(": 0.00 m"));
    }

    [Test]
    public void EditScan_Buttons_DeleteUndoAndExport()
    {
        string path = m_world.Scratch.Converted(points: 20_000);
        var edit = m_world.Add<EditScan>(e => e.GetComponent<FastPoints.Entities.PointCloud>().Path = path);
        m_world.Settle();
        void Press(string button)
        {
            GUILayout.Pressed = button;
            typeof(EditScan).GetMethod("OnGUI", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(edit, null);
            GUILayout.Pressed = null;
            m_world.Frames(() => !edit.IsBusy);
        }
        Press("Delete the middle");
        Assert.That(edit.Status, Does.Match("^[1-9][0-9]* points deleted$"));
        long left = 20_000 - long.Parse(edit.Status.Split(' ')[0], CultureInfo.InvariantCulture);
        m_world.Frames(() => m_world.Group.Stats.DrawnPoints == left);
        Press("Export");
        Assert.That(edit.Status, Does.StartWith(left + " points in "));
        Assert.That(m_world.Scratch["edited.laz"], Does.Exist);
        Press("Undo");
        m_world.Frames(() => m_world.Group.Stats.DrawnPoints == 20_000);
    }

    [Test]
    public void EntitiesOnlyStart_Cloud_IsStreamedAndEachNodeTinted()
    {
        var asset = m_world.Asset(20_000);
        var start = m_world.Add<EntitiesOnlyStart>(s => s.Cloud = asset);

        m_world.Settle();
        m_world.Frame();

        Assert.That(m_world.Group.Stream.Settings.Selection.PointBudget, Is.EqualTo(1_000_000));
        Assert.That(m_world.Count<Tint>(), Is.EqualTo(m_world.Count<PointCloudNode>()).And.GreaterThan(0));
        start.enabled = false;
        m_world.Frames(() => m_world.Count<PointCloudNode>() == 0);
    }

    [Test]
    public void EntitiesOnlyStart_NodesNotRequested_MakesNoStructuralChanges()
    {
        var asset = m_world.Asset(20_000);
        m_world.Add<EntitiesOnlyStart>(s => s.Cloud = asset);
        var entities = m_world.World.EntityManager;
        using (var wish = entities.CreateEntityQuery(ComponentType.ReadOnly<PointCloudNodesWanted>()))
            entities.DestroyEntity(wish);
        using (var budget = entities.CreateEntityQuery(ComponentType.ReadOnly<PointCloudBudget>()))
            entities.DestroyEntity(budget);
        m_world.Settle();
        m_world.Frames(() => m_world.Count<PointCloudNode>() == 0);
        int before = entities.EntityOrderVersion, loaded = 0;
        for (int round = 0; round < 4; round++)
        {
            // Nodes are evicted with their memory, and loaded again.
            m_world.Group.Stream.Pool.LimitBytes = 0;
            m_world.Frame();
            m_world.Group.Stream.Pool.LimitBytes = 64 << 20;
            m_world.Frames(() => m_world.Group.Stats.IsSettled && m_world.Group.Stats.DrawnPoints > 0);
            loaded += m_world.Group.Stats.CachedNodes;
        }
        Assert.That(loaded, Is.GreaterThanOrEqualTo(4));
        Assert.That(entities.EntityOrderVersion, Is.EqualTo(before));
    }

    [Test]
    public void CloudGrid_NineClouds_ShareTheStreamAndAreRemovedWithTheGrid()
    {
        var asset = m_world.Asset(3000);
        var grid = m_world.Add<FastPoints.Samples.ManyClouds.CloudGrid>(g => (g.Cloud, g.Side) = (asset, 3));

        m_world.Frames(() => m_world.Count<StreamedPointCloud>() == 9);
        var before = m_world.Group.Stream.Clouds.Select(c => c.Placement.OriginWorld).ToArray();
        m_world.Frame();
        var after = m_world.Group.Stream.Clouds.Select(c => c.Placement.OriginWorld).ToArray();

        Assert.That(Enumerable.Range(0, 9).Count(i => !before[i].Equals(after[i])), Is.EqualTo(3), "every third turns");
        grid.enabled = false;
        m_world.Frames(() => m_world.Count<StreamedPointCloud>() == 0);
    }

    [Test]
    public void FlyThrough_OneRound_StaysInTheCloudAndReturns()
    {
        var asset = m_world.Asset(3000);
        var cloud = m_world.Add<FastPoints.Entities.PointCloud>(c => c.Cloud = asset);
        // The host's frames take a sixtieth of a second.
        var fly = m_world.Add<FlyThrough>(f => (f.Cloud, f.Seconds) = (cloud, 2));
        var size = asset.BoundsMax - asset.BoundsMin;
        var positions = Enumerable.Range(0, 121).Select(_ =>
        {
            SceneLoop.Update();
            return fly.transform.position;
        }).ToArray();

        Assert.That(positions.Max(p => p.x) - positions.Min(p => p.x), Is.EqualTo(0.3 * size.x).Within(0.1));
        Assert.That(positions.Max(p => p.z) - positions.Min(p => p.z), Is.EqualTo(0.3 * size.y).Within(0.1));
        Assert.That((positions[120] - positions[0]).magnitude, Is.LessThan(0.01f));
        var along = (Vector3)fly.transform.localToWorldMatrix.GetColumn(2);
        var level = new Vector3(along.x, 0, along.z).normalized;
        // 0.6 of a turn's 2 pi: in frames, 11.46.
        var limit = positions[11] + (positions[12] - positions[11]) * 0.459f - positions[120];
        Assert.That(Vector3.Dot(level, limit.normalized), Is.GreaterThan(0.9999f), "it looks where it will be");
        Assert.That(along.y, Is.LessThan(0), "and down");
    }

    [Test]
    public void FrameFigures_OfAFrame_NameWhatIsDrawn()
    {
        m_world.Add<FastPoints.Entities.PointCloud>(c => c.Cloud = m_world.Asset(3000));
        m_world.Settle();

        Assert.That(FrameFigures.TryGetFigures(out var stats), Is.True);
        Assert.That(FrameFigures.Describe(stats), Does.StartWith("3,000 points in "));
    }

    [Test]
    public void ColourSwitch_ClassHidden_IsNotDrawnUntilShownAgain()
    {
        var asset = m_world.Asset(3000);
        var colours = m_world.Add<ColourSwitch>();
        var cloud = colours.GetComponent<FastPoints.Entities.PointCloud>();
        cloud.Cloud = asset;

        colours.Show(2, false);
        colours.Show(6, false);
        colours.Show(6, true);

        Assert.That(cloud.HiddenClasses, Is.EqualTo(new[] { 2 }));
        m_world.Frames(() => m_world.Count<PointCloudLook>() == 1);
        Assert.That(m_world.World.EntityManager.GetComponentData<PointCloudLook>(cloud.Entity).Value.HiddenClasses.Has(2),
            Is.True);
        cloud.Color = ColorMode.Classification;
        Assert.That(cloud.HiddenClasses, Is.EqualTo(new[] { 2 }));
    }
}
