namespace FastPoints.HostTests.Gpu;

public sealed class StereoPassTests : PipelineFixture
{
    static readonly double3 s_eye = new(-60, -45, 40), s_target = new(0, 0, 0), s_up = new(0, 0, 1);

    internal static PictureCamera At(int eye)
    {
        var middle = PictureCamera.Perspective(s_eye, s_target, s_up, 60);
        return PictureCamera.Perspective(s_eye + middle.Right * (eye == 0 ? -3.5 : 3.5), s_target, s_up, 60);
    }

    internal static Matrix4x4 ProjectionOf(int eye)
    {
        var projection = Matrix4x4.Perspective(60, (float)WidthPx / HeightPx, 0.1f, 10_000);
        projection.m02 = eye == 0 ? -0.2f : 0.2f;
        return projection;
    }

    internal static RenderTexture Target(int slices)
    {
        var description = new RenderTextureDescriptor(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat)
        {
            dimension = slices > 1 ? TextureDimension.Tex2DArray : TextureDimension.Tex2D,
            volumeDepth = slices,
        };
        var target = new RenderTexture(description);
        target.Create();
        return target;
    }

    static PictureCamera AlongAxes(int eye)
    {
        var position = new double3(eye == 0 ? -3.5 : 3.5, -75, 8);
        return PictureCamera.Perspective(position, position + new double3(0, 64, 0), s_up, 60);
    }

    internal static Camera Headset(RenderTexture target, Func<int, PictureCamera> at)
    {
        var camera = CameraAt(PictureCamera.Perspective(s_eye, s_target, s_up, 60), ProjectionOf(0), target);
        camera.stereoEnabled = true;
        camera.Eyes = new[] { (ViewOf(at(0)), ProjectionOf(0)), (ViewOf(at(1)), ProjectionOf(1)) };
        return camera;
    }

    internal static PointStyle StyleOf(string name) => name switch
    {
        "pixels" => new PointStyle { Shape = PointShape.Pixel, Size = PointSize.Pixels(1) },
        "discs" => new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3) },
        "squares" => new PointStyle { Shape = PointShape.Square, Size = PointSize.Pixels(3) },
        "adaptive" => new PointStyle { Shape = PointShape.Square, Size = PointSize.Adaptive() },
        "splats" => new PointStyle { Shape = PointShape.Splat, Size = PointSize.Pixels(5) },
        "paraboloids" => new PointStyle { Shape = PointShape.Paraboloid, Size = PointSize.World(0.5f) },
        _ => new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3), EdlStrength = 0.3f },
    };

    StreamContext Show(string pipeline, string style)
    {
        Scene.Style = StyleOf(style);
        Begin(pipeline);
        var options = new PictureOptions { WidthPx = WidthPx, HeightPx = HeightPx, Color = ColorMode.Rgb };
        var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        Add(reference, options, out _);
        return reference;
    }

    [TestCase(nameof(UrpHost), "discs")]
    [TestCase(nameof(UrpHost), "adaptive")]
    [TestCase(nameof(UrpHost), "pixels")]
    [TestCase(nameof(HdrpHost), "paraboloids")]
    [TestCase(nameof(HdrpHost), "lit")]
    [TestCase(nameof(UrpHost), "splats")]
    [TestCase(nameof(BuiltInHost), "discs")]
    [TestCase(nameof(BuiltInHost), "lit")]
    public void Render_Headset_IsThePictureOfACameraAtEachEye(string pipeline, string style)
    {
        using var reference = Show(pipeline, style);
        var both = Target(2);
        var headset = Headset(both, At);
        XRSettings.eyeTextureDesc = both.descriptor;
        var single = Target(1);
        for (int eye = 0; eye < 2; eye++)
        {
            var seen = Render(headset, eye);
            Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(2), "an announcement for each eye");
            var camera = CameraAt(At(eye), ProjectionOf(eye), single);
            var wanted = Render(camera);
            int differ = 0, covered = 0;
            for (int y = 0; y < HeightPx; y++)
                for (int x = 0; x < WidthPx; x++)
                {
                    covered += (wanted[x, y] & 0xFFFFFF) != 0 ? 1 : 0;
                    differ += wanted[x, y] != seen[x, y] ? 1 : 0;
                }
            string output = Path.Combine(TestContext.CurrentContext.WorkDirectory, "stereo-" + style + "-" + eye + ".png");
            File.WriteAllBytes(output, Png.Encode(seen));
            TestContext.Out.WriteLine($"{style}, eye {eye}: {covered} pixels covered, {differ} differ");
            Assert.That(covered, Is.GreaterThan(2000), output);
            Assert.That(differ / (double)covered, Is.LessThan(0.002), output);
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }

    [TearDown]
    public void TakeHeadsetOff() => XRSettings.eyeTextureDesc = default;

    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    public void Render_OneEyeAtATime_MatchesACameraThereAndSelectsOnce(string pipeline)
    {
        using var reference = Show(pipeline, "discs");
        var single = Target(1);
        var right = Target(1);
        var headset = Headset(single, AlongAxes);
        for (int eye = 0; eye < 2; eye++)
        {
            // Under URP the pipeline's own data says it, and the camera does not.
            if (Pipeline is UrpHost urp)
                urp.Eye = eye;
            else
                headset.RightEye = right;
            var seen = Render(headset);
            if (eye == 1 && headset.RightEye != null)
                seen = Picture(headset.RightEye);
            RenderOnce(headset);
            Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(2));
            var camera = CameraAt(AlongAxes(eye), ProjectionOf(eye), single);
            var wanted = Render(camera);
            Assert.That(wanted.Rgba.Count(b => b != 0), Is.GreaterThan(20_000));
            Assert.That(seen.Rgba, Is.EqualTo(wanted.Rgba), "eye " + eye);
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
        right.Release();
    }

    /// <summary>A spectator's on a desktop, beside the headset.</summary>
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_CameraNotShownByTheHeadset_HasItsOwnPictureAndSelection(string pipeline)
    {
        using var reference = Show(pipeline, "discs");
        // HDRP's targets have a slice for each eye, whatever is drawn.
        var target = Target(pipeline == nameof(HdrpHost) ? 2 : 1);
        var camera = CameraAt(AlongAxes(0), ProjectionOf(0), target);
        var wanted = Render(camera);
        camera.stereoEnabled = true;
        camera.stereoActiveEye = Camera.MonoOrStereoscopicEye.Left;
        camera.Eyes = new[] { (ViewOf(At(0)), ProjectionOf(0)), (ViewOf(At(1)), ProjectionOf(1)) };
        if (pipeline == nameof(UrpHost))
            camera.gameObject.AddComponent<UniversalAdditionalCameraData>().allowXRRendering = false;
        else
            camera.gameObject.AddComponent<HDAdditionalCameraData>().xrRendering = false;
        var seen = Render(camera);
        Assert.That(wanted.Rgba.Count(b => b != 0), Is.GreaterThan(20_000));
        Assert.That(seen.Rgba, Is.EqualTo(wanted.Rgba));
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1));
    }
}
