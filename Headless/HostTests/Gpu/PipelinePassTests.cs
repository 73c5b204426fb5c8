namespace FastPoints.HostTests.Gpu;

public sealed class PipelinePassTests : PipelineFixture
{
    [TestCase(nameof(BuiltInHost), false)]
    [TestCase(nameof(BuiltInHost), true)]
    [TestCase(nameof(UrpHost), false)]
    [TestCase(nameof(HdrpHost), false)]
    [TestCase(nameof(BuiltInHost), false, 0.3f)]
    [TestCase(nameof(UrpHost), true, 0.3f)]
    [TestCase(nameof(HdrpHost), false, 0.3f)]
    public void Render_CameraOfTheEngine_IsThePictureOfTheSoftwareRasterizer(string pipeline,
        bool isOrthographic, float edlStrength = 0)
    {
        Scene.Style = new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3), EdlStrength = edlStrength };
        Begin(pipeline);
        var options = new PictureOptions
        {
            WidthPx = WidthPx,
            HeightPx = HeightPx,
            PointSizePx = 3,
            RoundPoints = true,
            EdlStrength = edlStrength,
            Color = ColorMode.Rgb,
        };
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        reference.Settings.Selection = Group.Stream.Settings.Selection;
        using var picture = new StreamedPicture(options);
        var plan = Add(reference, options, out _);
        picture.Add(new StreamedBlocks(reference, 0, plan), plan.Mode);
        var eye = new double3(-60, -45, 40);
        var at = isOrthographic ? PictureCamera.Orthographic(eye, new double3(0, 0, 0), new double3(0, 0, 1), 60)
            : PictureCamera.Perspective(eye, new double3(0, 0, 0), new double3(0, 0, 1), 60);
        var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        target.Create();
        float aspect = (float)WidthPx / HeightPx;
        var camera = CameraAt(at, isOrthographic ? Matrix4x4.Ortho(-30 * aspect, 30 * aspect, -30, 30, 0.1f, 1000)
            : Matrix4x4.Perspective(60, aspect, 0.1f, 10_000), target);
        camera.backgroundColor = new Color(24 / 255f, 26 / 255f, 30 / 255f, 1);
        var drawn = Render(camera);
        Assert.That(Scene.RecordedPictures, Is.GreaterThan(0));

        using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
        var view = views;
        view[0] = CameraViews.StreamViewOf(camera);
        while (!FrameStep.Run(reference, views).IsSettled)
            Thread.Yield();
        Assert.That(Group.Stats.DrawnPoints, Is.EqualTo(ReferencePoints(reference)).And.GreaterThan(10_000));
        var wanted = picture.Draw(at);
        int differ = 0, covered = 0;
        for (int y = 0; y < HeightPx; y++)
            for (int x = 0; x < WidthPx; x++)
            {
                covered += wanted[x, y] != options.Background ? 1 : 0;
                differ += wanted[x, y] != drawn[x, y] ? 1 : 0;
            }
        string output = Path.Combine(TestContext.CurrentContext.WorkDirectory,
            pipeline + (isOrthographic ? "-flat" : "") + (edlStrength > 0 ? "-edl" : "") + ".png");
        File.WriteAllBytes(output, Png.Encode(drawn));
        Assert.That(covered, Is.GreaterThan(2000));
        Assert.That(differ / (double)covered, Is.LessThan(0.003), output);
    }

    /// <summary>By a light from behind the camera the cloud is brighter than by one from behind the cloud, and redder by a red
    /// one; with no share of it lit, it is as without light, whatever the light.</summary>
    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_LitCloud_ShowsThePipelinesLight(string pipeline)
    {
        Begin(pipeline);
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        var plan = Add(reference, new PictureOptions { Color = ColorMode.Rgb }, out _);
        var look = CloudLooks.Of(plan.Colors, reference.Clouds[0].Source);
        var camera = LookingCamera();
        var sun = new GameObject("sun").AddComponent<Light>();
        var ambient = new SphericalHarmonicsL2();
        for (int channel = 0; channel < 3; channel++)
            ambient[channel, 0] = 0.1f;
        (RenderSettings.sun, RenderSettings.ambientProbe) = (sun, ambient);
        (double Red, double Green) Mean(float share, Vector3 forward, Color color)
        {
            var matrix = Matrix4x4.identity;
            var side = Vector3.Cross(forward, new Vector3(0.3f, 1, 0)).normalized;
            matrix.SetColumn(0, side);
            matrix.SetColumn(1, Vector3.Cross(forward, side));
            matrix.SetColumn(2, forward);
            SceneLoop.Place(sun.transform, matrix);
            sun.color = color;
            if (Pipeline is UrpHost urp)
                urp.MainLight = new VisibleLight { finalColor = color, localToWorldMatrix = matrix };
            look.Light = share;
            Scene.SetLook(0, look);
            var picture = Render(camera);
            double red = 0, green = 0;
            for (int i = 0; i < WidthPx * HeightPx; i++)
            {
                uint pixel = picture[i % WidthPx, i / WidthPx];
                (red, green) = (red + (pixel & 0xFF), green + (pixel >> 8 & 0xFF));
            }
            return (red, green);
        }
        var away = new Vector3(60, 45, -40).normalized;
        var lit = Mean(1, away, Color.white);
        Assert.That(lit.Green, Is.GreaterThan(1.3 * Mean(1, -away, Color.white).Green));
        var red = Mean(1, away, Color.red);
        Assert.That(red.Red / red.Green, Is.GreaterThan(1.3 * lit.Red / lit.Green));
        Assert.That(Mean(0, -away, Color.red), Is.EqualTo(Mean(0, away, Color.white)));
        if (Pipeline is UrpHost host)
        {
            // Above the middle of the cloud.
            var above = Matrix4x4.identity;
            above.SetColumn(3, new Vector4(0, 0, 30, 1));
            host.Additional = new VisibleLight
            {
                finalColor = new Color(0, 1000, 0),
                lightType = LightType.Point,
                range = 100,
                localToWorldMatrix = above,
            };
            var green = Mean(1, away, Color.red);
            Assert.That(green.Green, Is.GreaterThan(1.3 * red.Green));
            Assert.That(green.Red, Is.EqualTo(red.Red));
            host.HasAdditional = false;
            Assert.That(Mean(1, away, Color.red), Is.EqualTo(red));
        }
        (RenderSettings.sun, RenderSettings.ambientProbe) = (null, default);
        UnityEngine.Object.DestroyImmediate(sun.gameObject);
    }

    Camera LookingCamera()
    {
        var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        target.Create();
        return CameraAt(PictureCamera.Perspective(new double3(-60, -45, 40), new double3(0, 0, 0), new double3(0, 0, 1), 60),
            Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 10_000), target);
    }

    /// <summary>As a floating origin moves it, with the clouds, in the frame that selects for it.</summary>
    [TestCase(false)]
    [TestCase(true)]
    public void CollectNextViews_CameraMovedSinceItsPicture_UsesItsCurrentPosition(bool isMirror)
    {
        Begin(nameof(BuiltInHost));
        var camera = LookingCamera();
        if (isMirror)
            camera.worldToCameraMatrix *= Matrix4x4.Translate(new Vector3(0, 0, 20));
        RenderOnce(camera);
        var before = Scene.CollectNextViews()[0].EyeWorld;
        camera.transform.position += new Vector3(-1000, 5, 0);
        Assert.That(Scene.CollectNextViews()[0].EyeWorld, Is.EqualTo(before + (isMirror ? default : new double3(-1000, 5, 0))));
    }

    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_AgainAndAgainWithoutAnUpdate_KeepsTheLastViewOfEachCamera(string pipeline)
    {
        Begin(pipeline);
        var first = LookingCamera();
        var second = LookingCamera();
        for (int frame = 0; frame < 50; frame++)
        {
            second.projectionMatrix = Matrix4x4.Perspective(20 + frame, 16 / 9f, 0.1f, 10_000);
            RenderOnce(first);
            RenderOnce(second);
        }
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(2));
        Assert.That(Scene.CollectNextViews()[0].ScalePx, Is.EqualTo(CameraViews.StreamViewOf(first).ScalePx));
        Assert.That(Scene.CollectNextViews()[1].ScalePx, Is.EqualTo(CameraViews.StreamViewOf(second).ScalePx));
    }

    /// <summary>Adds a cloud, and draws until it is there.</summary>
    void Stream(PipelineHost host, Camera camera)
    {
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb }, out _);
        for (int frame = 0; frame < MaxFrames && (frame < 3 || !Group.Stats.IsSettled); frame++)
        {
            host.Render(camera);
            UpdateWorld();
            Thread.Yield();
        }
        host.Render(camera);
    }

    [Test]
    public void Render_UrpCameraThatSeesNoCloud_HasNoPass()
    {
        using var host = new UrpHost();
        var camera = LookingCamera();
        host.Render(camera);
        Assert.That(host.PassCount, Is.Zero, "nothing is loaded");
        Stream(host, camera);
        Assert.That(host.PassCount, Is.EqualTo(1));
        camera.worldToCameraMatrix = Matrix4x4.Translate(new Vector3(0, 0, 10_000));
        host.Render(camera);
        Assert.That(host.PassCount, Is.Zero, "it looks elsewhere");
    }

    [Test]
    public void Render_AfterAUrpCameraThatCouldNotBeCulled_RecordsOnePass()
    {
        using var host = new UrpHost();
        var camera = LookingCamera();
        var unculled = LookingCamera();
        RenderPipelineManager.Begin(unculled);
        RenderPipelineManager.Begin(unculled);
        Stream(host, camera);
        Assert.That(host.PassCount, Is.EqualTo(1));
        host.Render(unculled);
        Assert.That(host.PassCount, Is.EqualTo(1));
    }

    [Test]
    public void Render_UrpWithoutDepth_DrawsNoCloudsAndThrowsNothing()
    {
        using var host = new UrpHost { IsWithoutDepth = true };
        var camera = LookingCamera();
        Assert.That(() => host.Render(camera), Throws.Nothing);
        Assert.That(host.PassCount, Is.Zero);
    }

    [Test]
    public void Render_UrpIntoDepthAlone_DrawsNoCloudsAndThrowsNothing()
    {
        using var host = new UrpHost();
        var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.None, GraphicsFormat.D32_SFloat);
        var camera = LookingCamera();
        camera.targetTexture = target;
        Assert.That(() => host.Render(camera), Throws.Nothing);
        Assert.That(host.PassCount, Is.Zero);
        Assert.That(Scene.CollectNextViews().Length, Is.Zero, "nor is it selected for");
        target.Release();
    }

    [Test]
    public void Render_UrpScriptDrawsAnotherCamera_DrawsFromTheNextPicture()
    {
        using var host = new UrpHost();
        var camera = LookingCamera();
        var mirror = LookingCamera();
        void DrawMirror(ScriptableRenderContext context, Camera drawn) => host.RenderSingle(mirror);
        // After the package has, at which the mirror takes its pass.
        RenderPipelineManager.beginCameraRendering += DrawMirror;
        try
        {
            Stream(host, camera);
            for (int picture = 0; picture < 3; picture++)
            {
                host.Render(camera);
                Assert.That(host.PassCount, Is.EqualTo(1));
            }
        }
        finally
        {
            RenderPipelineManager.beginCameraRendering -= DrawMirror;
        }
    }

    /// <summary>The matrix is rounded: a place that it does not contradict is exact.</summary>
    [Test]
    public void StreamViewOf_CameraWithACustomMatrix_UsesItsPosition()
    {
        var camera = LookingCamera();
        Assert.That(CameraViews.StreamViewOf(camera).EyeWorld, Is.EqualTo(new double3(-60, -45, 40)));
        var mirrored = Matrix4x4.identity;
        mirrored.m22 = -1;
        camera.worldToCameraMatrix *= mirrored;
        Assert.That(math.distance(CameraViews.StreamViewOf(camera).EyeWorld, new double3(-60, -45, -40)), Is.LessThan(1e-4));
    }

    /// <summary>What HDRP draws over all that its depth pyramid does not know.</summary>
    [TestCase("fog")]
    [TestCase("water")]
    public void Render_Hdrp_DrawsNoBackgroundOverPoints(string cover)
    {
        Begin(nameof(HdrpHost));
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb }, out _);
        var camera = LookingCamera();
        var wanted = Render(camera);
        Assert.That(wanted.Rgba.Count(b => b != 0), Is.GreaterThan(20_000));
        ((HdrpHost)Pipeline).Cover = (cover == "fog" ? CustomPassInjectionPoint.BeforePreRefraction
            : CustomPassInjectionPoint.BeforeTransparent, camera.backgroundColor);
        Assert.That(Render(camera).Rgba, Is.EqualTo(wanted.Rgba));
    }

    [Test]
    public void Render_CameraOfEverySecondFrame_SelectsInEachFrame()
    {
        Begin(nameof(BuiltInHost));
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb }, out _);
        var map = LookingCamera();
        Render(map);
        int nodes = Group.Stats.SelectedNodes;
        var away = CameraAt(PictureCamera.Perspective(new double3(-60, -45, 40), new double3(-120, -90, 80),
            new double3(0, 0, 1), 60), map.projectionMatrix, map.targetTexture);
        for (int frame = 0; frame < 10; frame++)
        {
            RenderOnce(away);
            if (frame % 2 == 0)
                RenderOnce(map);
            UpdateWorld();
            Assert.That(Group.Stats.SelectedNodes, Is.EqualTo(nodes), "frame " + frame);
        }
        for (int frame = 0; frame < PointScene.FramesToKeep + 1; frame++)
        {
            RenderOnce(away);
            UpdateWorld();
        }
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1), "it draws no more");
    }

    [Test]
    public void Enqueue_UrpInCompatibilityMode_WarnsOnceAndHasNoPass()
    {
        var logged = new List<string>();
        Debug.s_sink = (type, text) => logged.Add(text);
        var settings = new UnityEngine.Rendering.Universal.RenderGraphSettings { enableRenderCompatibilityMode = true };
        GraphicsSettings.Settings[settings.GetType()] = settings;
        try
        {
            using var host = new UrpHost();
            var camera = LookingCamera();
            for (int i = 0; i < 3; i++)
                host.Render(camera);
            Assert.That(host.PassCount, Is.Zero);
            Assert.That(logged, Has.Count.EqualTo(1).And.All.Contains("Compatibility Mode"));
            settings.enableRenderCompatibilityMode = false;
            Stream(host, camera);
            Assert.That(host.PassCount, Is.EqualTo(1));
        }
        finally
        {
            GraphicsSettings.Settings.Clear();
            Debug.s_sink = null;
        }
    }

    [Test]
    public void Draw_BuiltInAfterAReloadOfScripts_HasOneBufferInEachCamera()
    {
        Begin(nameof(BuiltInHost));
        var camera = LookingCamera();
        // What scripts from before the reload left; their own lists are gone.
        using var left = new CommandBuffer { name = "FastPoints" };
        using var other = new CommandBuffer { name = "other" };
        camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, left);
        camera.AddCommandBuffer(CameraEvent.AfterForwardOpaque, other);
        RenderOnce(camera);
        var buffers = camera.GetCommandBuffers(CameraEvent.AfterForwardOpaque);
        Assert.That(buffers, Has.Length.EqualTo(2).And.Contains(other).And.Not.Contains(left));
    }

    [Test]
    public void Begin_HdrpBegunTwice_DrawsEachCameraOnce()
    {
        // A host begins twice.
        using (new HdrpHost())
            Assert.That(CustomPassVolume.Global, Has.Count.EqualTo(1));
        Assert.That(CustomPassVolume.Global, Is.Empty);
    }

    static long ReferencePoints(StreamContext stream)
    {
        long points = 0;
        unsafe
        {
            foreach (var drawn in stream.Drawn)
                points += stream.Clouds[drawn.Cloud].Pages[drawn.Page].Nodes[drawn.Node].PointCount;
        }
        return points;
    }

    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_CloudMaskedForACamera_IsNeitherDrawnNorSelected(string pipeline)
    {
        Begin(pipeline);
        var options = new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, EdlStrength = 0, Color = ColorMode.Rgb };
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, options, out _);
        var camera = LookingCamera();
        void Shows(bool isShown, string reason)
        {
            var drawn = Render(camera);
            bool isEmpty = Enumerable.Range(0, WidthPx * HeightPx).All(i => drawn[i % WidthPx, i / WidthPx] == drawn[0, 0]);
            Assert.That(isEmpty, Is.Not.EqualTo(isShown), reason);
            Assert.That(Group.Stats.SelectedNodes > 0, Is.EqualTo(isShown), reason);
        }
        camera.cullingMask = ~(1 << 7);
        Shows(true, "it has no layer");
        Entities.AddComponentData(Cloud, new PointCloudLayer { Value = 7 });
        Shows(false, "its layer is hidden");
        camera.cullingMask = 1 << 7;
        Shows(true, "its layer alone is shown");
        Entities.AddComponent<Disabled>(Cloud);
        Shows(false, "its entity is disabled");
        Entities.RemoveComponent<Disabled>(Cloud);
        Shows(true, "its entity is enabled again");
        camera.gameObject.AddComponent<PointCloudCamera>().DrawsClouds = false;
        var none = Render(camera);
        Assert.That(Enumerable.Range(0, WidthPx * HeightPx).All(i => none[i % WidthPx, i / WidthPx] == none[0, 0]), Is.True,
            "the camera draws no clouds any more");
    }

    [TestCase(CameraType.Game)]
    [TestCase(CameraType.SceneView)]
    public void Render_CameraOfUrpWithoutData_IsDrawnAndGetsNone(CameraType kind)
    {
        using var host = new UrpHost();
        var camera = LookingCamera();
        camera.cameraType = kind;
        Stream(host, camera);
        Assert.That(host.PassCount, Is.EqualTo(1));
        Assert.That(camera.gameObject.GetComponent<UnityEngine.Rendering.Universal.UniversalAdditionalCameraData>() == null);
    }

    [Test]
    public void Render_UrpOverlayCamera_DrawsIfEnabled()
    {
        Begin(nameof(UrpHost));
        var camera = LookingCamera();
        Stream(Pipeline, camera);
        bool IsSeen()
        {
            long before = Scene.RecordedPictures;
            RenderOnce(camera);
            return Scene.RecordedPictures > before;
        }
        var data = camera.gameObject.AddComponent<UnityEngine.Rendering.Universal.UniversalAdditionalCameraData>();
        Assert.That(IsSeen(), Is.True);
        data.renderType = UnityEngine.Rendering.Universal.CameraRenderType.Overlay;
        Assert.That(IsSeen(), Is.False, "overlay");
        var choice = camera.gameObject.AddComponent<PointCloudCamera>();
        Assert.That(IsSeen(), Is.True, "it asks");
        choice.enabled = false;
        Assert.That(IsSeen(), Is.False, "what asks is disabled");
        data.renderType = UnityEngine.Rendering.Universal.CameraRenderType.Base;
        choice.enabled = true;
        choice.DrawsClouds = false;
        Assert.That(IsSeen(), Is.False, "it asks for none");
    }

    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_PreviewCamera_DrawsAndSelectsNothing(string pipeline)
    {
        Begin(pipeline);
        var options = new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, EdlStrength = 0, Color = ColorMode.Rgb };
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, options, out _);
        var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        target.Create();
        var camera =
            CameraAt(PictureCamera.Perspective(new double3(-60, -45, 40), new double3(0, 0, 0), new double3(0, 0, 1), 60),
            Matrix4x4.Perspective(60, 16 / 9f, 0.1f, 10_000), target);
        camera.cameraType = CameraType.Preview;
        camera.scene = new UnityEngine.SceneManagement.Scene { Mask = 16 };
        RenderOnce(camera);
        Assert.That(Scene.CollectNextViews().Length, Is.Zero);
        camera.scene = default;
        RenderOnce(camera);
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1), "what a virtual camera sees, in the Scene view");
        Scene.BeginFrame();
        camera.cameraType = CameraType.SceneView;
        RenderOnce(camera);
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1));
    }
}
