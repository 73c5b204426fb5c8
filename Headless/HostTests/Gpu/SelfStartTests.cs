namespace FastPoints.HostTests.Gpu;

public sealed class SelfStartTests : GraphicsFixture
{
    ScratchFolder m_scratch;
    World m_world;

    [SetUp]
    public void MakeWorld()
    {
        m_scratch = new ScratchFolder();
        m_world = World.DefaultGameObjectInjectionWorld = new World("default");
        var systems = typeof(PointCloudSystemGroup).Assembly.GetTypes()
            .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray();
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, systems);
        var shaders = new GpuShaders();
        PipelineFixture.AddResources(shaders).Progressive = shaders.Progressive;
        BuiltInPass.Begin();
    }

    [TearDown]
    public void EndWorld()
    {
        SceneLoop.IsPlaying = false;
        BuiltInPass.End();
        HeadlessGraphics.WaitForIdle();
        m_world.Dispose();
        Resources.Assets.Clear();
        m_scratch.Dispose();
    }

    [Test]
    public void PointCloud_WithoutGraphics_NeitherStreamsNorRequestsFrames()
    {
        SystemInfo.IsServer = true;
        try
        {
            var scene = new GameObject("scan");
            scene.AddComponent<FastPoints.Entities.PointCloud>().Path = m_scratch.Converted(points: 1000);
            var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
            SceneLoop.Update();
            Assert.That(() => m_world.Update(), Throws.Nothing);
            Assert.That((group.Stream, group.NeedsFrame), Is.EqualTo(((StreamContext)null, false)));
            var gone = scene.GetComponent<FastPoints.Entities.PointCloud>().Entity;
            Assert.That(group.Live.Find(gone), Is.Not.Null);
            UnityEngine.Object.DestroyImmediate(scene);
            m_world.Update();
            Assert.That(group.Live.Find(gone), Is.Null, "a server may make and end any number");
        }
        finally
        {
            SystemInfo.IsServer = false;
        }
    }

    // 60 m above the cloud's middle.
    static Camera MakeCamera(out RenderTexture target)
    {
        target = new RenderTexture(160, 90, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        target.Create();
        var camera = new GameObject("camera").AddComponent<Camera>();
        camera.targetTexture = target;
        camera.projectionMatrix = Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 1000);
        LookDown(camera, 60);
        return camera;
    }

    static void LookDown(Camera camera, float height)
    {
        var above = Matrix4x4.identity;
        above.SetColumn(3, new Vector4(0, height, 0, 1));
        SceneLoop.Place(camera.transform, above);
        // Unity's -Z is the camera's forward in a view matrix.
        var view = Matrix4x4.zero;
        view.SetRow(0, new Vector4(1, 0, 0, 0));
        view.SetRow(1, new Vector4(0, 0, 1, 0));
        view.SetRow(2, new Vector4(0, 1, 0, -height));
        view.SetRow(3, new Vector4(0, 0, 0, 1));
        camera.worldToCameraMatrix = view;
    }

    static uint[] Pixels(RenderTexture target)
    {
        var request = AsyncGPUReadback.Request(target);
        request.WaitForCompletion();
        return request.GetData<uint>().ToArray();
    }

    // In paused play mode nobody draws what nobody asks for.
    [Test]
    public void NeedsFrame_CameraOfAProgressivePictureMoved_IsTrueUntilAllPointsWereTried()
    {
        SceneLoop.IsPlaying = true;
        var camera = MakeCamera(out var target);
        var settings = new GameObject("settings").AddComponent<PointCloudSettings>();
        settings.Shape = PointShape.Pixel;
        settings.FadeSeconds = 0;
        var cloud = new GameObject("scan").AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_scratch.Converted(points: 20_000);
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        int frames = 0;
        void Frame()
        {
            frames++;
            SceneLoop.Update();
            camera.Render();
            m_world.Update();
            HeadlessGraphics.EndFrame();
        }
        uint[] Rest(float height)
        {
            LookDown(camera, height);
            frames = 0;
            ImportProject.Updates(Frame, () => group.Stats.DrawnPoints > 0 && !group.NeedsFrame);
            camera.Render();
            return Pixels(target);
        }
        var whole = Rest(50);
        Rest(60);
        settings.MillionPointsPerFrame = 0.0002f;
        Rest(61);
        camera.Render();
        LookDown(camera, 50);
        Frame();
        Frame();
        Assert.That(Pixels(target).Count(p => (p & 0xFFFFFF) != 0), Is.LessThan(whole.Count(p => (p & 0xFFFFFF) != 0)));
        Assert.That(group.NeedsFrame, Is.True);
        Assert.That(Rest(50), Is.EqualTo(whole));
        Assert.That(frames, Is.GreaterThan(100));
        Object.DestroyImmediate(cloud.gameObject);
        Object.DestroyImmediate(settings.gameObject);
        Object.DestroyImmediate(camera.gameObject);
        target.Release();
    }

    [Test]
    public void PointCloud_InFrontOfACamera_IsDrawn()
    {
        string path = m_scratch.Converted(points: 20_000);
        var camera = MakeCamera(out var target);
        var settings = new GameObject("settings").AddComponent<PointCloudSettings>();
        settings.MillionPoints = 0.005f;
        settings.MemoryMebibytes = 64;
        settings.Shape = PointShape.Disc;
        settings.Size = 5;
        var cloud = new GameObject("scan").AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = path;
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        ImportProject.Updates(() =>
        {
            SceneLoop.Update();
            camera.Render();
            m_world.Update();
            HeadlessGraphics.EndFrame();
        }, () => group.Stats.IsSettled && group.Stats.DrawnPoints > 0);
        Assert.That(group.Stream.Settings.Selection.PointBudget, Is.EqualTo(5000));
        Assert.That(group.Stream.Pool.LimitBytes, Is.EqualTo(64 << 20));
        Assert.That((group.Scene.Style.Shape, group.Scene.Style.Size.Value), Is.EqualTo((PointShape.Disc, 5f)));
        camera.Render();
        var pixels = Pixels(target);
        Assert.That(pixels.Count(p => (p & 0xFFFFFF) != 0), Is.GreaterThan(1000));
        Assert.That(pixels.Distinct().Count(), Is.GreaterThan(100), "the scan's own colours");

        Object.DestroyImmediate(settings.gameObject);
        m_world.Update();
        Assert.That(group.Stream.Settings.Selection.PointBudget, Is.EqualTo(LodSettings.Default.PointBudget));
        Assert.That(group.Scene.Style.Shape, Is.EqualTo(PointStyle.Default.Shape), "nobody says otherwise any more");
        Object.DestroyImmediate(cloud.gameObject);
        Object.DestroyImmediate(camera.gameObject);
        target.Release();
    }

    [Test]
    public void Camera_DrawnRepeatedlyWithoutUpdates_IsRegisteredOnceWithItsLatestView()
    {
        var target = new RenderTexture(160, 90, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        var camera = new GameObject("camera").AddComponent<Camera>();
        camera.targetTexture = target;
        camera.projectionMatrix = Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 1000);
        var cloud = new GameObject("scan").AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = m_scratch["none.fastpoints"];
        m_world.Update();
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();

        for (int frame = 0; frame < 5; frame++)
            camera.Render();
        var before = group.Scene.CollectNextViews()[0];
        var narrow = Matrix4x4.Perspective(30, 16 / 9f, 0.1f, 1000);
        camera.projectionMatrix = narrow;
        camera.Render();

        Assert.That(group.Scene.CollectNextViews().Length, Is.EqualTo(1));
        Assert.That(group.Scene.CollectNextViews()[0].ScalePx, Is.GreaterThan(before.ScalePx));
        camera.Eyes = new[] { (Matrix4x4.identity, narrow), (Matrix4x4.identity, narrow) };
        foreach (bool hasHeadset in new[] { true, false, true })
        {
            camera.stereoEnabled = hasHeadset;
            camera.Render();
            Assert.That(group.Scene.CollectNextViews().Length, Is.EqualTo(hasHeadset ? 2 : 1),
                "a headset that is put on and off");
        }
        for (int frame = 0; frame < PointScene.FramesToKeep + 1; frame++)
            m_world.Update();
        Assert.That(group.Scene.CollectNextViews().Length, Is.Zero);
        Object.DestroyImmediate(cloud.gameObject);
        Object.DestroyImmediate(camera.gameObject);
        target.Release();
    }

    [Test]
    public void GraphicsMemory_OfTheProject_IsTheDefaultOfScenesAndNewSettings()
    {
        string path = m_scratch.Converted();
        var project = FastPointsSettings.instance;
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        var cloud = new GameObject("scan").AddComponent<FastPoints.Entities.PointCloud>();
        cloud.Path = path;
        long Limit()
        {
            SceneLoop.Update();
            m_world.Update();
            return group.Stream.Pool.LimitBytes;
        }
        try
        {
            project.GpuMiB = 96;
            project.Apply();
            Assert.That(Limit(), Is.EqualTo(96 << 20));
            project.GpuMiB = 128;
            project.Apply();
            Assert.That(Limit(), Is.EqualTo(128 << 20), "from the next frame on");
            var settings = new GameObject("settings").AddComponent<PointCloudSettings>();
            Assert.That(settings.MemoryMebibytes, Is.EqualTo(128));
            settings.MemoryMebibytes = 64;
            Assert.That(Limit(), Is.EqualTo(64 << 20));
            Object.DestroyImmediate(settings.gameObject);
            Assert.That(Limit(), Is.EqualTo(128 << 20), "nobody says otherwise any more");
        }
        finally
        {
            project.GpuMiB = 512;
            project.Apply();
            Object.DestroyImmediate(cloud.gameObject);
        }
    }

    [Test]
    public void World_WithoutClouds_AllocatesNoGraphicsMemory()
    {
        HeadlessGraphics.WaitForIdle();
        long before = HeadlessGraphics.UsedBytes;
        m_world.Update();
        Assert.That(m_world.GetExistingSystemManaged<PointCloudSystemGroup>().Stream, Is.Null);
        Assert.That(HeadlessGraphics.UsedBytes, Is.EqualTo(before));
    }
}
