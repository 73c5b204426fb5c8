using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Samples;

/// <summary>Steps 1 to 13 of <c>try-in-unity.md</c> in one project, one after the other, and what each of them should show:
/// what step 14 runs is compiled and looked at by other tests. The editor's and the player's loop go as Unity's do: in edit
/// mode frames come only when somebody asks for them.</summary>
[NonParallelizable]
public sealed class WalkTests : GraphicsFixture
{
    const int WidthPx = 240, HeightPx = 135;

    readonly List<string> m_logged = new List<string>();
    EditorProject m_project;
    World m_world;
    RenderTexture m_target;

    [SetUp]
    public void OpenProject()
    {
        SceneLoop.Clear(); // Of what other tests left, which frames would open.
        m_logged.Clear();
        // Burst warns once of delegates in Unity's own packages, where these are Unity's own.
        Debug.s_sink = (type, text) => m_logged.AddRange(text.Contains("UnmanagedFunctionPointer") ? [] : [type + ": " + text]);
        m_project = new EditorProject();
        m_target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        m_target.Create();
        Gpu.PipelineFixture.AddResources(new GpuShaders());
        Application.PlayerFiles = m_project.Scratch["player"];
        Directory.CreateDirectory(Application.PlayerFiles);
        MakeWorld();
        EditModeFrames.Update(); // The edits of other tests are no news.
    }

    [TearDown]
    public void CloseProject()
    {
        EditorApplication.isPlaying = false;
        SceneLoop.Clear();
        BuiltInPass.End();
        HeadlessGraphics.WaitForIdle();
        m_world.Dispose();
        World.DefaultGameObjectInjectionWorld = null;
        m_target.Release();
        Resources.Assets.Clear();
        (Application.PlayerFiles, Camera.main) = (null, null);
        FastPointsSettings.instance.MaxCopiedMiB = 64;
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Ask;
        Debug.s_sink = null;
        m_project.Dispose();
    }

    [Test]
    public void Walk_Steps1To13_ShowTheExpected()
    {
        // 1. Open the project.
        foreach (var type in typeof(PointCloudImports).Assembly.GetTypes().Where(t =>
            t.IsDefined(typeof(InitializeOnLoadAttribute), false)))
            RuntimeHelpers.RunClassConstructor(type.TypeHandle);
        // Unity has all assemblies loaded: this loads one.
        BuiltInPass.End();
        EditModePasses.Begin();
        for (int i = 0; i < 10; i++)
            Tick();
        Assert.That(m_logged, Is.Empty, "step 1");

        FirstCloud();
        Settings();
        DropScans();
        Interrupt();
        PauseAndCancel();
        Fly();
        Colours();
        NodesAsEntities();
        ManyClouds();
        LoadAtRunTime();
        BuildAPlayer();
    }

    /// <summary>Steps 2 and 3.</summary>
    void FirstCloud()
    {
        Directory.CreateDirectory(m_project.Paths.Absolute("PointClouds"));
        m_project.Scratch.Demo("project/PointClouds/street.laz", 60_000);
        MakeScene("First cloud");
        // The conversion waits, so what is drawn is the preview.
        Until(() => Imports.Queue.Session?.State == ConversionState.Building &&
            Progress.Entries.Any(e => e.Name == "Convert street.pointcloud"));
        int converting = Progress.Entries.FindIndex(e => e.Name == "Convert street.pointcloud");
        Assert.That(Progress.Pause(converting), Is.True);
        Until(() => Group.Stats.DrawnPoints > 1000);
        int before = Covered(Picture());
        Assert.That(before, Is.GreaterThan(1000), "step 2: at once");
        Progress.Resume(converting);
        Until(() => Imports.Queue.Requests.Count == 0);
        Settle();
        var whole = Picture();
        Assert.That(Covered(whole), Is.GreaterThan(0.95 * before), "step 2: nothing thins out");
        Assert.That(Progress.Entries[converting].Status, Is.EqualTo(Progress.Status.Succeeded));

        var cloud = SceneLoop.Find<PointCloud>().Single().transform;
        Undo.RecordObject(cloud, "Move");
        cloud.SetPositionAndRotation(new Vector3(5, 0, 0), Quaternion.Euler(0, 20, 0));
        cloud.localScale = new Vector3(1, 2, 1);
        Frame();
        Assert.That(Changed(Picture(), whole), Is.GreaterThan(0.1), "step 3: in the next frame");
        Undo.PerformUndo();
        Settle();
        Assert.That(Changed(Picture(), whole), Is.LessThan(0.01), "step 3: undone");
    }

    /// <summary>Step 4.</summary>
    void Settings()
    {
        var settings = SceneLoop.Find<PointCloudSettings>().Single();
        var before = Picture();
        void Change(string name, Action change)
        {
            change();
            Settle();
            var after = Picture();
            Assert.That(Changed(after, before), Is.GreaterThan(0.01), "step 4: " + name);
            before = after;
        }

        Change(nameof(settings.Shape), () => settings.Shape = PointShape.Square);
        Change(nameof(settings.SizeMode), () => (settings.SizeMode, settings.Size) = (PointSizeMode.Pixels, 2));
        Change(nameof(settings.EyeDomeLighting), () => settings.EyeDomeLighting = 2);
        Change(nameof(settings.FillHoles), () => settings.FillHoles = true);
        Change(nameof(PointCloud.Light), () => SceneLoop.Find<PointCloud>().Single().Light = 1);
        Change(nameof(settings.MillionPoints), () => settings.MillionPoints = 0.004f);
        Assert.That(Group.Stats.DrawnPoints, Is.LessThanOrEqualTo(4000), "step 4");
    }

    /// <summary>Step 5.</summary>
    void DropScans()
    {
        FastPointsSettings.instance.MaxCopiedMiB = 0;
        DragAndDrop.paths = new[] { m_project.Scratch.Demo("to scene.las", 20_000) };
        DragAndDrop.objectReferences = Array.Empty<Object>();
        DragAndDrop.Drop<DragAndDrop.SceneDropHandler>(null, Vector3.zero, default(Vector2), null, true);
        Until(() => SceneLoop.Find<PointCloud>().Length == 2);
        DragAndDrop.paths = new[] { m_project.Scratch.Demo("to project.las", 20_000) };
        DragAndDrop.Drop<DragAndDrop.ProjectBrowserDropHandler>(0, "Assets", true);
        Until(() => m_project.Asset("Assets/to project.pointcloud") != null);
        FastPointsSettings.instance.SeveralFiles = SeveralFiles.Separate;
        DragAndDrop.paths = new[] { "tile 1", "tile 2", "tile 3" }
            .Select((name, i) => m_project.Scratch.Demo(name + ".las", 3000 + i)).ToArray();
        DragAndDrop.Drop<DragAndDrop.SceneDropHandler>(null, Vector3.zero, default(Vector2), null, true);
        Until(() => SceneLoop.Find<PointCloud>().Length == 5 && Imports.Queue.Requests.Count == 0);

        Assert.That(SceneLoop.Find<PointCloudOrigin>(), Has.Length.EqualTo(1), "step 5: side by side");
        var grown = new DirectoryInfo(Application.dataPath).GetFiles("*", SearchOption.AllDirectories);
        Assert.That(grown.Max(f => f.Length), Is.LessThan(2048), "step 5");
        Settle();
        Assert.That(m_logged, Is.Empty, "step 5");
    }

    /// <summary>Step 6.</summary>
    void Interrupt()
    {
        m_project.Scratch.Demo("long.las", 60_000);
        var asset = Imports.CreateAsset(m_project.Scratch["long.las"], "Assets");
        Until(() => Imports.Queue.Session?.State == ConversionState.Building);
        AssemblyReloadEvents.Reload();
        Until(() => Imports.Queue.Session?.State == ConversionState.Building);
        Play();
        Stop();
        Until(() => Imports.Queue.Session?.State == ConversionState.Building);
        EditorApplication.Quit();
        Until(() => asset.Points == 60_000);
        Assert.That(CliCall.Of("verify", m_project.Paths.Absolute("PointClouds/long.fastpoints"), "--against",
            m_project.Scratch["long.las"], "--quiet").Status, Is.EqualTo(ExitStatus.Done), "step 6");
    }

    /// <summary>Step 7.</summary>
    void PauseAndCancel()
    {
        m_project.Scratch.Demo("other.las", 60_000);
        var asset = Imports.CreateAsset(m_project.Scratch["other.las"], "Assets");
        Until(() => Imports.Queue.Session?.State == ConversionState.Building &&
            Progress.Entries.Any(e => e.Name == "Convert other.pointcloud"));
        int shown = Progress.Entries.FindLastIndex(e => e.Name == "Convert other.pointcloud");
        Assert.That(Progress.Pause(shown), Is.True, "step 7");
        Assert.That(Imports.Queue.Session.State, Is.EqualTo(ConversionState.Paused), "step 7");
        Assert.That(Progress.Resume(shown), Is.True, "step 7");
        Assert.That(Progress.Cancel(shown), Is.True, "step 7");
        Until(() => Imports.Queue.Requests.Count == 0);
        Assert.That(Directory.Exists(m_project.Paths.Absolute("PointClouds/other.fastpoints")), Is.False, "step 7");
        Imports.Convert("Assets/other.pointcloud");
        Until(() => asset.Points == 60_000 && Imports.Queue.Requests.Count == 0);
    }

    /// <summary>Step 8.</summary>
    void Fly()
    {
        MakeScene("Streaming flight");
        var settings = SceneLoop.Find<PointCloudSettings>().Single();
        (settings.MillionPoints, settings.MemoryMebibytes) = (0.02f, 64);
        Play();
        Settle(rests: false);
        for (int frame = 0; frame < 120; frame++)
        {
            Frame();
            Assert.That(Group.Stats.DrawnPoints, Is.InRange(1, 20_000), "step 8");
            Assert.That(Group.Stats.PoolBytes, Is.LessThanOrEqualTo(64 << 20), "step 8");
        }
        Assert.That(Covered(Picture()), Is.GreaterThan(500), "step 8");
        Stop();
    }

    /// <summary>Step 9.</summary>
    void Colours()
    {
        MakeScene("Attribute colours");
        var colours = SceneLoop.Find<ColourSwitch>().Single();
        var cloud = colours.GetComponent<PointCloud>();
        Play();
        byte[] Settled()
        {
            Settle();
            return Picture();
        }

        var classes = Settled();
        var pictures = new List<byte[]>();
        foreach (var mode in Enum.GetValues<ColorMode>().Where(m => m != ColorMode.Auto))
        {
            cloud.Color = mode;
            pictures.Add(Settled());
            foreach (var other in pictures.SkipLast(1))
                Assert.That(Changed(pictures[^1], other), Is.GreaterThan(0.1), "step 9: " + mode);
        }
        cloud.Color = ColorMode.Classification;
        colours.Show(2, false);
        Assert.That(Covered(Settled()), Is.LessThan(0.97 * Covered(classes)), "step 9: no ground");
        colours.Show(2, true);
        Assert.That(Changed(Settled(), classes), Is.LessThan(0.01), "step 9");
        SceneLoop.Find<PointCloudClipBox>().Single().transform.position += new Vector3(0, 500, 0);
        Assert.That(Changed(Settled(), classes), Is.GreaterThan(0.1), "step 9: the box");
        Stop();
    }

    /// <summary>Step 10.</summary>
    void NodesAsEntities()
    {
        MakeScene("Entities only");
        Play();
        Settle();
        Until(() => Count<Tint>() > 0 && Count<Tint>() == Count<PointCloudNode>());
        Stop();
        Assert.That(Count<PointCloudNode>(), Is.Zero, "step 10");
    }

    /// <summary>Step 11.</summary>
    void ManyClouds()
    {
        MakeScene("Many clouds");
        Play();
        Until(() => Count<StreamedPointCloud>() == 64);
        var before = Group.Stream.Clouds.Select(c => c.Placement.OriginWorld).ToArray();
        Frame();
        var after = Group.Stream.Clouds.Select(c => c.Placement.OriginWorld).ToArray();
        Assert.That(before.Zip(after).Count(p => !p.First.Equals(p.Second)), Is.EqualTo(22), "step 11: every third turns");
        Stop();
    }

    /// <summary>Step 12.</summary>
    void LoadAtRunTime()
    {
        MakeScene("Run-time loading");
        SceneLoop.Find<LoadFromDisk>().Single().Source = m_project.Scratch["other.las"];
        var said = new HashSet<string>();
        for (int time = 0; time < 2; time++)
        {
            said.Clear();
            Play();
            var load = SceneLoop.Find<LoadFromDisk>().Single();
            Until(() =>
            {
                said.Add(load.Status);
                return load.IsDone;
            });
            Assert.That(said.Any(s => s.EndsWith('%')), Is.EqualTo(time == 0), "step 12: a percentage at first");
            Settle();
            Stop();
        }
    }

    /// <summary>Step 13.</summary>
    void BuildAPlayer()
    {
        const string scene = "Assets/first.unity";
        m_logged.Clear();
        AssetDatabase.Dependencies[scene] = new[] { SampleScan.AssetPath };
        var context = new BuildPlayerContext(new BuildPlayerOptions { scenes = new[] { scene } });
        new PlayerCloudProcessor().PrepareForBuild(context);
        Assert.That(context.FolderOfPlayerPath.Keys, Is.EqualTo(new[] { "PointClouds/street.fastpoints" }), "step 13");
        Assert.That(m_logged.Single(), Does.StartWith("Log: 1 point clouds in the player").And.Contains("60,000 points"));
    }

    static EditorImports Imports => PointCloudImports.Current;

    PointCloudSystemGroup Group => m_world.GetExistingSystemManaged<PointCloudSystemGroup>();

    void MakeWorld()
    {
        m_world = World.DefaultGameObjectInjectionWorld = new World("default");
        var assemblies = new[] { typeof(PointCloudSystemGroup).Assembly, typeof(EntitiesOnlyStart).Assembly };
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, assemblies.SelectMany(a => a.GetTypes())
            .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray());
    }

    void MakeScene(string sample)
    {
        Camera.main = null;
        SampleSceneTests.Command("FastPoints/Samples/" + sample).Invoke(null, null);
        Until(() => Camera.main != null);
        Camera.main.targetTexture = m_target;
        Camera.main.projectionMatrix = Matrix4x4.Perspective(60, (float)WidthPx / HeightPx, 0.1f, 1000);
    }

    void Play() => Switch(true);

    void Stop() => Switch(false);

    void Switch(bool isPlaying)
    {
        AssemblyReloadEvents.Reload();
        var roots = SceneLoop.Objects.Where(o => o.activeSelf && o.transform.parent is null).ToArray();
        foreach (var root in roots)
            root.SetActive(false);
        SceneLoop.Update();
        HeadlessGraphics.WaitForIdle();
        m_world.Dispose();
        // As the loaded scripts do.
        EditModePasses.Begin();
        MakeWorld();
        EditorApplication.isPlaying = isPlaying;
        foreach (var root in roots)
            root.SetActive(true);
    }

    void Tick()
    {
        int asked = EditorApplication.s_queuedUpdates;
        EditorApplication.update?.Invoke();
        Imports.Update(DateTime.UtcNow);
        if (EditorApplication.isPlaying || EditorApplication.s_queuedUpdates != asked)
            Frame();
        else
            Thread.Yield();
    }

    void Frame()
    {
        SceneLoop.Update();
        m_world.Update();
        if (Camera.main != null && Camera.main.targetTexture != null)
            Camera.main.Render();
        HeadlessGraphics.EndFrame();
    }

    void Until(Func<bool> isDone) => ImportProject.Updates(Tick, isDone);

    /// <summary>Systems see what cameras saw a frame before. A camera that moves never rests.</summary>
    void Settle(bool rests = true)
    {
        Frame();
        Frame();
        Until(() => Group.Stats.IsSettled && Group.Stats.DrawnPoints > 0 && !(rests && Group.NeedsFrame));
    }

    byte[] Picture()
    {
        Frame();
        return Read<byte>(m_target);
    }

    /// <summary>The share of covered pixels that differ to be seen: of points at one depth, the order decides.</summary>
    static double Changed(byte[] picture, byte[] before)
    {
        int changed = 0;
        for (int i = 0; i < picture.Length; i += 4)
            if (Enumerable.Range(i, 3).Any(k => Math.Abs(picture[k] - before[k]) > 8))
                changed++;
        return (double)changed / Math.Max(Covered(picture), Covered(before));
    }

    static int Covered(byte[] picture)
    {
        int covered = 0;
        for (int i = 0; i < picture.Length; i += 4)
            if ((picture[i] | picture[i + 1] | picture[i + 2]) != 0)
                covered++;
        return covered;
    }

    int Count<T>() where T : unmanaged, IComponentData
    {
        using var query = new EntityQueryBuilder(Allocator.Temp).WithAll<T>().Build(m_world.EntityManager);
        return query.CalculateEntityCount();
    }
}
