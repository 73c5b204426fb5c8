namespace FastPoints.HostTests.Gpu;

public sealed class TargetTests : PipelineFixture
{
    const int ScreenWidthPx = 400, ScreenHeightPx = 300;

    protected override bool HasRaster => true;

    [TestCase("discs")]
    [TestCase("squares")]
    [TestCase("pixels")]
    [TestCase("lit")]
    [TestCase("splats")]
    public void Render_OntoTheScreenOrAPartOfIt_IsThePictureInATexture(string style)
    {
        var camera = LookingCamera(style, out var texture);
        var wanted = Render(camera);
        Assert.That(wanted.Rgba.Count(b => b != 0), Is.GreaterThan(20_000));
        Assert.That(Rows(Drawn(camera), WidthPx, 0, 0, isScreen: false), Is.EqualTo(wanted.Rgba));

        var screen = new RenderTexture(ScreenWidthPx, ScreenHeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        camera.Part = new Rect(50, 20, WidthPx, HeightPx);
        camera.targetTexture = screen;
        Assert.That(Rows(Drawn(camera), ScreenWidthPx, 50, 20, isScreen: false), Is.EqualTo(wanted.Rgba), "a part of a texture");
        screen.IsScreen = true;
        camera.targetTexture = null;
        camera.Screen = screen;
        byte[] drawn = Drawn(camera);
        byte[] onScreen = Rows(drawn, ScreenWidthPx, 50, 100, isScreen: true);
        Assert.That(drawn.Count(b => b != 0), Is.EqualTo(onScreen.Count(b => b != 0)), "nothing beside it");
        Assert.That(Shifted(onScreen, wanted), Is.LessThanOrEqualTo(style == "squares" ? 0.012 : style == "discs" ? 0.001 : 0));
        // Triangles that are upside down have other edges where a pixel's middle lies on one: a picture that is upside down in a
        // texture has the same.
        camera.Part = null;
        camera.targetTexture = texture;
        var projection = camera.projectionMatrix;
        projection.SetRow(1, -projection.GetRow(1));
        camera.projectionMatrix = projection;
        if (style is "squares" or "discs")
            Assert.That(Rows(Drawn(camera), WidthPx, 0, 0, isScreen: true), Is.EqualTo(onScreen), "a part of the screen");
        screen.Release();
    }

    /// <summary>A camera of twice the size whose picture has half of its pixels.</summary>
    [TestCase(nameof(BuiltInHost), "lit")]
    [TestCase(nameof(BuiltInHost), "pixels")]
    [TestCase(nameof(BuiltInHost), "discs")]
    [TestCase(nameof(UrpHost), "splats")]
    [TestCase(nameof(UrpHost), "pixels")]
    [TestCase(nameof(UrpHost), "discs")]
    public void Render_DynamicResolution_IsThePictureOfThatSize(string pipeline, string style)
    {
        var camera = LookingCamera(style, out _, pipeline);
        var wanted = Render(camera);
        camera.Part = new Rect(0, 0, WidthPx * 2, HeightPx * 2);
        camera.DynamicScale = 0.5f;
        Assert.That(Rows(Drawn(camera), WidthPx, 0, 0, isScreen: false), Is.EqualTo(wanted.Rgba));
    }

    /// <summary>HDRP jitters its own matrix, and not the camera's.</summary>
    [Test]
    public void Render_HdrpWithJitter_IsThePictureOfACameraThatIsJittered()
    {
        var camera = LookingCamera("discs", out _, nameof(HdrpHost));
        Render(camera);
        var jitter = new Vector2(0.4f / WidthPx, -0.7f / HeightPx) * 2;
        ((HdrpHost)Pipeline).Jitter = jitter;
        byte[] drawn = Drawn(camera);
        ((HdrpHost)Pipeline).Jitter = default;
        byte[] still = Drawn(camera);
        var jittered = camera.projectionMatrix;
        jittered.m02 += jitter.x;
        jittered.m12 += jitter.y;
        camera.projectionMatrix = jittered;
        Assert.That(drawn, Is.EqualTo(Drawn(camera)).And.Not.EqualTo(still));
    }

    [TestCase("squares")]
    [TestCase("adaptive")]
    [TestCase("pixels")]
    [TestCase("lit")]
    [TestCase("splats")]
    public void Record_UploadsAndLayers_ComeBeforeTheTarget(string style)
    {
        var camera = LookingCamera(style, out var texture);
        Render(camera);
        using var commands = new CommandBuffer();
        Scene.Record(commands, camera, CameraTarget.Of(camera, texture, texture));
        var kinds = commands.Commands.Select(c => c.Kind).ToList();
        int set = kinds.LastIndexOf(CommandKind.SetTarget);
        Assert.That(commands.Commands.FindIndex(c =>
            c.Kind == CommandKind.SetTarget && commands.Targets[c.Data].Texture == texture), Is.EqualTo(set), "it is set once");
        var before = kinds.Take(set);
        Assert.That(before, Has.Member(CommandKind.Upload));
        Assert.That(before, style is "lit" or "splats" ? Has.Member(CommandKind.DrawIndirect)
            : style == "pixels" ? Has.Member(CommandKind.Dispatch) : Has.No.Member(CommandKind.DrawIndirect));
        Assert.That(kinds.Skip(set + 1).Where(k => k != CommandKind.ReleaseTemporary).Distinct(), Is.EqualTo(new[]
        {
            style is "squares" or "adaptive" ? CommandKind.DrawIndirect : CommandKind.Draw,
        }));
    }

    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_OneCameraAtTwoSizesInAFrame_StreamsForBothAndKeepsItsBuffer(string pipeline)
    {
        var camera = LookingCamera("pixels", out _, pipeline);
        var sceneMaskOf = CameraViews.SceneMaskOf;
        CameraViews.SceneMaskOf = c => c.overrideSceneCullingMask;
        Render(camera);
        var wanted = Scene.CollectNextViews().ToArray().Single();
        var buffer = PixelsOf(Scene);
        var small = new RenderTexture(WidthPx / 4, HeightPx / 4, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        small.Create();
        try
        {
            (camera.targetTexture, camera.overrideSceneCullingMask) = (small, 4);
            RenderOnce(camera);
            RenderOnce(camera);
            Assert.That(Scene.CollectNextViews().ToArray().Select(v => (v.ScalePx, v.Mask.Scenes)), Is.EquivalentTo(new[]
            {
                (wanted.ScalePx, 0ul), (wanted.ScalePx / 4, 4ul),
            }));
            for (int size = 1; size < 40; size++)
            {
                camera.Part = new Rect(0, 0, size, size);
                RenderOnce(camera);
            }
            Assert.That(Scene.CollectNextViews().Length, Is.LessThanOrEqualTo(4), "a window whose edge is dragged");
        }
        finally
        {
            CameraViews.SceneMaskOf = sceneMaskOf;
        }
        Assert.That(PixelsOf(Scene), Is.SameAs(buffer).And.Not.Null);
        small.Release();
    }

    /// <summary>The buffer of pixels of the first camera.</summary>
    static GraphicsBuffer PixelsOf(PointScene scene)
    {
        object Field(object of, string name) => of.GetType().GetField(name, System.Reflection.BindingFlags.Instance |
            System.Reflection.BindingFlags.Public | System.Reflection.BindingFlags.NonPublic).GetValue(of);
        var cameras = (System.Collections.IList)Field(scene, "m_cameras");
        return ((ComputeRaster)Field(Field(cameras[0], "Renderer"), "m_raster")).Pixels;
    }

    [Test]
    public void Renderer_WithoutKernelsForPixels_DrawsThemByPrimitives()
    {
        var shaders = new GpuShaders();
        using var pool = (GraphicsNodePool)shaders.CreatePool(1 << 20, 1 << 20);
        using var sizes = new SizeTree();
        bool HasRaster(ComputeShader raster)
        {
            using var renderer = new PointRenderer(new PointMaterials(shaders.Points, shaders.Compose, raster), pool, sizes);
            return typeof(PointRenderer).GetField("m_raster", System.Reflection.BindingFlags.Instance |
                System.Reflection.BindingFlags.NonPublic).GetValue(renderer) != null;
        }
        Assert.That(HasRaster(shaders.Raster), Is.True);
        Assert.That(HasRaster(shaders.CopyPages), Is.False, "kernels that the device has not");
        Assert.That(HasRaster(null), Is.False);
    }

    [TestCase(true, null, "compute shaders")]
    [TestCase(false, 1, "storage buffers")]
    [TestCase(false, 2, null)]
    public void Update_UnsupportedDevice_WarnsOnce(bool hasNoCompute, int? vertexBuffers, string what)
    {
        var logged = new List<string>();
        var sink = Debug.s_sink;
        Debug.s_sink = (type, text) => logged.Add(text);
        HeadlessGraphics.HasNoCompute = hasNoCompute;
        HeadlessGraphics.VertexBuffers = vertexBuffers;
        AddResources(new GpuShaders()).Raster = null;
        PointScene.Current = null;
        using var world = new World("without");
        try
        {
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, typeof(PointCloudSystemGroup));
            var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
            world.EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudFile>());
            for (int frame = 0; frame < 5; frame++)
                world.Update();
            Assert.That(group.Stream, what == null ? Is.Not.Null : Is.Null);
            Assert.That(logged.Where(l => l.StartsWith("Point clouds are not drawn")),
                what == null ? Is.Empty : Has.One.Contains(what));
            Assert.That(group.NeedsFrame, Is.EqualTo(what == null));
        }
        finally
        {
            HeadlessGraphics.HasNoCompute = false;
            HeadlessGraphics.VertexBuffers = null;
            Debug.s_sink = sink;
            Resources.Assets.Clear();
        }
    }

    static double Shifted(byte[] drawn, RgbaImage wanted)
    {
        var pixels = Enumerable.Range(0, WidthPx * HeightPx)
            .Select(i => (Is: BitConverter.ToUInt32(drawn, i * 4), Wanted: BitConverter.ToUInt32(wanted.Rgba, i * 4))).ToList();
        return pixels.Count(p => p.Is != p.Wanted) / (double)pixels.Count(p => (p.Wanted & 0xFFFFFF) != 0);
    }

    [Test]
    public void Update_SecondWorldThatDraws_WaitsUntilTheFirstEnds()
    {
        AddResources(new GpuShaders()).Raster = null;
        PointScene.Current = null;
        var worlds = new[] { "server", "client", "second client" }.Select(n => new World(n)).ToArray();
        World.DefaultGameObjectInjectionWorld = worlds[0];
        try
        {
            var groups = new List<PointCloudSystemGroup>();
            foreach (var world in worlds.Skip(1))
            {
                DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, typeof(PointCloudSystemGroup));
                groups.Add(world.GetExistingSystemManaged<PointCloudSystemGroup>());
            }
            worlds[2].EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudFile>());
            worlds[2].Update();
            Assert.That(PointCloudSystemGroup.ObjectGroup, Is.SameAs(groups[1]), "GameObjects' clouds join the one that draws");
            worlds[1].EntityManager.CreateEntity(ComponentType.ReadWrite<PointCloudFile>());
            foreach (var world in worlds)
                world.Update();
            Assert.That((groups[0].Stream, groups[0].NeedsFrame), Is.EqualTo(((StreamContext)null, false)));
            worlds[2].Dispose();
            worlds[1].Update();
            Assert.That(groups[0].Stream, Is.Not.Null);
        }
        finally
        {
            foreach (var world in worlds.Where(w => w.IsCreated))
                world.Dispose();
            World.DefaultGameObjectInjectionWorld = null;
            Resources.Assets.Clear();
        }
    }

    Camera LookingCamera(string style, out RenderTexture texture, string pipeline = nameof(BuiltInHost))
    {
        Scene.Style = StereoPassTests.StyleOf(style);
        Begin(pipeline);
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb }, out _);
        texture = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        return CameraAt(PictureCamera.Perspective(new double3(-60, -45, 40), new double3(0, 0, 0), new double3(0, 0, 1), 60),
            Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 10_000), texture);
    }

    byte[] Drawn(Camera camera)
    {
        RenderOnce(camera);
        var request = AsyncGPUReadback.Request(camera.targetTexture != null ? camera.targetTexture : camera.Screen);
        request.WaitForCompletion();
        return request.GetData<byte>().ToArray();
    }

    // A picture's rows, the topmost first, of what lies in memory with it or the other way round.
    static byte[] Rows(byte[] all, int widthPx, int x, int y, bool isScreen) =>
        Enumerable.Range(0, HeightPx).SelectMany(row =>
            all.Skip(((y + (isScreen ? row : HeightPx - 1 - row)) * widthPx + x) * 4).Take(WidthPx * 4)).ToArray();
}
