namespace FastPoints.HostTests.Gpu;

public sealed class ShadowPassTests : PipelineFixture
{
    Light m_sun;

    protected override bool HasRaster => true;

    // A lit cloud, and light from the side.
    StreamContext Show(string pipeline)
    {
        Begin(pipeline);
        var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        var plan = Add(reference, new PictureOptions { Color = ColorMode.Rgb }, out _);
        var look = CloudLooks.Of(plan.Colors, reference.Clouds[0].Source);
        look.Light = 1;
        Scene.SetLook(0, look);
        var toWorld = Matrix4x4.identity;
        toWorld.SetColumn(0, new Vector4(0, 1, 0, 0));
        toWorld.SetColumn(1, new Vector4(-0.3f, 0, -0.95f, 0));
        toWorld.SetColumn(2, new Vector4(0.95f, 0, -0.3f, 0));
        m_sun = new GameObject("sun").AddComponent<Light>();
        SceneLoop.Place(m_sun.transform, toWorld);
        RenderSettings.sun = m_sun;
        if (Pipeline is UrpHost urp)
            urp.MainLight = new VisibleLight { finalColor = Color.white, localToWorldMatrix = toWorld };
        return reference;
    }

    [TearDown]
    public void EndSun()
    {
        (RenderSettings.sun, XRSettings.eyeTextureDesc) = (null, default);
        UnityEngine.Object.DestroyImmediate(m_sun.gameObject);
    }

    RgbaImage Render(Camera camera, bool hasShadows, int slice = 0)
    {
        var style = Scene.Style;
        style.Shadows = hasShadows;
        Scene.Style = style;
        return Render(camera, slice);
    }

    static void AssertDarker(RgbaImage with, RgbaImage without)
    {
        Assert.That(Enumerable.Range(0, with.Rgba.Length).Count(i => with.Rgba[i] < without.Rgba[i]), Is.GreaterThan(1000));
        Assert.That(Enumerable.Range(0, with.Rgba.Length).Count(i => with.Rgba[i] > without.Rgba[i]), Is.Zero);
    }

    /// <summary>Parts of the cloud get darker and none brighter; the light is one view more, and neither is left when shadows
    /// end.</summary>
    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_Shadows_DarkensWhatTheLightDoesNotSee(string pipeline)
    {
        using var reference = Show(pipeline);
        var target = StereoPassTests.Target(1);
        var camera = CameraAt(StereoPassTests.At(0), StereoPassTests.ProjectionOf(0), target);
        var without = Render(camera, false);
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1));
        var with = Render(camera, true);
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(2));
        AssertDarker(with, without);
        Assert.That(Render(camera, true).Rgba, Is.EqualTo(with.Rgba));
        Assert.That(Render(camera, false).Rgba, Is.EqualTo(without.Rgba));
        Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(1));
    }

    /// <summary>Both eyes look up the same map, from their own places.</summary>
    [Test]
    public void Render_ShadowsInAHeadset_AreThoseOfACameraAtEachEye()
    {
        using var reference = Show(nameof(UrpHost));
        var both = StereoPassTests.Target(2);
        var headset = StereoPassTests.Headset(both, StereoPassTests.At);
        XRSettings.eyeTextureDesc = both.descriptor;
        var single = StereoPassTests.Target(1);
        for (int eye = 0; eye < 2; eye++)
        {
            var seen = Render(headset, true, eye);
            Assert.That(Scene.CollectNextViews().Length, Is.EqualTo(3));
            AssertDarker(seen, Render(headset, false, eye));
            var camera = CameraAt(StereoPassTests.At(eye), StereoPassTests.ProjectionOf(eye), single);
            var wanted = Render(camera, true);
            int differ = Enumerable.Range(0, WidthPx * HeightPx)
                .Count(i => wanted[i % WidthPx, i / WidthPx] != seen[i % WidthPx, i / WidthPx]);
            TestContext.Out.WriteLine($"eye {eye}: {differ} differ");
            Assert.That(differ, Is.LessThan(0.003 * WidthPx * HeightPx));
            UnityEngine.Object.DestroyImmediate(camera.gameObject);
        }
    }
}
