namespace FastPoints.HostTests.Gpu;

/// <summary>Progressive pictures of the pipelines: of cameras, and of a headset's eyes.</summary>
public sealed class ProgressivePassTests : PipelineFixture
{
    const int Frames = 30, PointsPerFrame = 8_000;

    protected override bool HasRaster => true;

    [SetUp]
    public void Play() => SceneLoop.IsPlaying = true;

    StreamContext Show(string pipeline, string style)
    {
        Scene.Style = StereoPassTests.StyleOf(style);
        Begin(pipeline);
        var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb }, out _);
        return reference;
    }

    void SetPointsPerFrame(int points)
    {
        var style = Scene.Style;
        style.PointsPerFrame = points;
        Scene.Style = style;
    }

    static double Differ(RgbaImage a, RgbaImage b)
    {
        int differ = 0, covered = 0;
        for (int i = 0; i < WidthPx * HeightPx; i++)
        {
            covered += (b[i % WidthPx, i / WidthPx] & 0xFFFFFF) != 0 ? 1 : 0;
            differ += a[i % WidthPx, i / WidthPx] != b[i % WidthPx, i / WidthPx] ? 1 : 0;
        }
        Assert.That(covered, Is.GreaterThan(2000));
        return differ / (double)covered;
    }

    [TestCase(nameof(BuiltInHost), "pixels")]
    [TestCase(nameof(BuiltInHost), "discs")]
    [TestCase(nameof(UrpHost), "pixels")]
    [TestCase(nameof(UrpHost), "discs")]
    [TestCase(nameof(HdrpHost), "pixels")]
    [TestCase(nameof(HdrpHost), "paraboloids")]
    public void Render_TwoCameras_EachReachesItsWholePicture(string pipeline, string style)
    {
        using var reference = Show(pipeline, style);
        int slices = pipeline == nameof(HdrpHost) ? 2 : 1;
        var targets = new[] { StereoPassTests.Target(slices), StereoPassTests.Target(slices) };
        var cameras = targets.Select((target, i) =>
            CameraAt(StereoPassTests.At(i), StereoPassTests.ProjectionOf(i), target)).ToArray();
        var whole = cameras.Select(camera => Render(camera)).ToArray();
        whole[0] = Render(cameras[0]);
        SetPointsPerFrame(PointsPerFrame);
        var first = new double[2];
        for (int frame = 0; frame < Frames; frame++)
            for (int i = 0; i < 2; i++)
            {
                RenderOnce(cameras[i]);
                first[i] = frame == 0 ? Differ(Picture(targets[i]), whole[i]) : first[i];
            }
        for (int i = 0; i < 2; i++)
        {
            Assert.That(first[i], Is.GreaterThan(0.1), "drawn whole at once");
            Assert.That(Differ(Picture(targets[i]), whole[i]), Is.LessThanOrEqualTo(style == "pixels" ? 0 : 0.001));
        }
    }

    [TestCase(nameof(UrpHost), "pixels")]
    [TestCase(nameof(UrpHost), "discs")]
    [TestCase(nameof(HdrpHost), "pixels")]
    [TestCase(nameof(BuiltInHost), "discs")]
    public void Render_Headset_EachEyeReachesItsWholePicture(string pipeline, string style)
    {
        using var reference = Show(pipeline, style);
        var both = StereoPassTests.Target(2);
        var headset = StereoPassTests.Headset(both, StereoPassTests.At);
        XRSettings.eyeTextureDesc = both.descriptor;
        Render(headset);
        var whole = new[] { Picture(both), Picture(both, 1) };
        SetPointsPerFrame(PointsPerFrame);
        RenderOnce(headset);
        for (int eye = 0; eye < 2; eye++)
            Assert.That(Differ(Picture(both, eye), whole[eye]), Is.GreaterThan(0.1), "drawn whole at once");
        for (int frame = 0; frame < Frames; frame++)
            RenderOnce(headset);
        for (int eye = 0; eye < 2; eye++)
            Assert.That(Differ(Picture(both, eye), whole[eye]), Is.LessThanOrEqualTo(style == "pixels" ? 0 : 0.001));
    }

    /// <summary>Multi-pass: one camera is drawn twice.</summary>
    [TestCase("pixels")]
    [TestCase("discs")]
    public void Render_OneEyeAtATime_EachReachesItsWholePicture(string style)
    {
        using var reference = Show(nameof(UrpHost), style);
        var single = StereoPassTests.Target(1);
        var headset = StereoPassTests.Headset(single, StereoPassTests.At);
        var urp = (UrpHost)Pipeline;
        var whole = new RgbaImage[2];
        for (int frame = 0; frame < Frames; frame++)
        {
            for (int eye = 0; eye < 2; eye++)
            {
                urp.Eye = eye;
                if (frame == 0)
                    whole[eye] = Render(headset);
                else
                    RenderOnce(headset);
                if (frame == Frames - 1)
                    Assert.That(Differ(Picture(single), whole[eye]), Is.LessThanOrEqualTo(style == "pixels" ? 0 : 0.001));
            }
            SetPointsPerFrame(PointsPerFrame);
        }
    }

    /// <summary>Where the GPU has time for more, a frame draws more, up to all.</summary>
    [TestCase(1, true)]
    [TestCase(0, false)]
    public void Render_GpuFrameMsSet_DrawsThePointsThatFit(double gpuMs, bool isWhole)
    {
        using var reference = Show(nameof(UrpHost), "pixels");
        var target = StereoPassTests.Target(1);
        var camera = CameraAt(StereoPassTests.At(0), StereoPassTests.ProjectionOf(0), target);
        var whole = Render(camera);
        SetPointsPerFrame(PointsPerFrame);
        var style = Scene.Style;
        style.GpuFrameMs = 10;
        Scene.Style = style;
        for (int frame = 0; frame < 100; frame++)
        {
            RenderOnce(camera);
            FrameTimingManager.EndFrame(gpuMs);
            UpdateWorld();
        }
        // Nothing is carried over to a camera that was not there.
        UnityEngine.Object.DestroyImmediate(camera.gameObject);
        camera = CameraAt(StereoPassTests.At(0), StereoPassTests.ProjectionOf(0), target);
        RenderOnce(camera);
        Assert.That(Differ(Picture(target), whole), isWhole ? Is.Zero : (IResolveConstraint)Is.GreaterThan(0.1));
    }

    /// <summary>Its views are not drawn again before something changes.</summary>
    [Test]
    public void Render_InEditMode_IsWholeAtOnce()
    {
        using var reference = Show(nameof(UrpHost), "discs");
        var target = StereoPassTests.Target(1);
        var camera = CameraAt(StereoPassTests.At(0), StereoPassTests.ProjectionOf(0), target);
        var whole = Render(camera);
        SetPointsPerFrame(PointsPerFrame);
        SceneLoop.IsPlaying = false;
        RenderOnce(camera);
        Assert.That(Picture(target).Rgba, Is.EqualTo(whole.Rgba));
    }

    [TearDown]
    public void Stop()
    {
        SceneLoop.IsPlaying = false;
        FrameTimingManager.EndFrame(null);
        XRSettings.eyeTextureDesc = default;
    }
}
