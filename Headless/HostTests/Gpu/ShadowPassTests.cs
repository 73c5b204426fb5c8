using FastPoints.Rendering;

namespace FastPoints.HostTests.Gpu;

public sealed class ShadowPassTests : PipelineFixture
{
    protected override bool HasRaster => true;

    /// <summary>By a light from the side parts of the cloud get darker and none brighter; the light is one view more, and
    /// neither is left when shadows end.</summary>
    [TestCase(nameof(BuiltInHost))]
    [TestCase(nameof(UrpHost))]
    [TestCase(nameof(HdrpHost))]
    public void Render_Shadows_DarkensWhatTheLightDoesNotSee(string pipeline)
    {
        Begin(pipeline);
        using var reference = new StreamContext(new MemoryNodePool(64 << 20, 8 << 20));
        var plan = Add(reference, new PictureOptions { Color = ColorMode.Rgb }, out _);
        var look = CloudLooks.Of(plan.Colors, reference.Clouds[0].Source);
        look.Light = 1;
        Scene.SetLook(0, look);
        var at = PictureCamera.Perspective(new double3(-60, -45, 40), new double3(0, 0, 0), new double3(0, 0, 1), 60);
        var target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        target.Create();
        var camera = CameraAt(at, Matrix4x4.Perspective(60, (float)WidthPx / HeightPx, 0.1f, 10_000), target);
        var toWorld = Matrix4x4.identity;
        toWorld.SetColumn(0, new Vector4(0, 1, 0, 0));
        toWorld.SetColumn(1, new Vector4(-0.3f, 0, -0.95f, 0));
        toWorld.SetColumn(2, new Vector4(0.95f, 0, -0.3f, 0));
        var sun = new GameObject("sun").AddComponent<Light>();
        SceneLoop.Place(sun.transform, toWorld);
        RenderSettings.sun = sun;
        if (Pipeline is UrpHost urp)
            urp.MainLight = new VisibleLight { finalColor = Color.white, localToWorldMatrix = toWorld };
        var without = Render(camera);
        Assert.That(Scene.NextViews.Length, Is.EqualTo(1));
        var style = Scene.Style;
        style.Shadows = true;
        Scene.Style = style;
        var with = Render(camera);
        Assert.That(Scene.NextViews.Length, Is.EqualTo(2));
        Assert.That(Render(camera).Rgba, Is.EqualTo(with.Rgba));
        int darker = 0, brighter = 0;
        for (int i = 0; i < without.Rgba.Length; i++)
        {
            darker += with.Rgba[i] < without.Rgba[i] ? 1 : 0;
            brighter += with.Rgba[i] > without.Rgba[i] ? 1 : 0;
        }
        Assert.That(darker, Is.GreaterThan(1000));
        Assert.That(brighter, Is.Zero);
        style.Shadows = false;
        Scene.Style = style;
        Assert.That(Render(camera).Rgba, Is.EqualTo(without.Rgba));
        Assert.That(Scene.NextViews.Length, Is.EqualTo(1));
        RenderSettings.sun = null;
        UnityEngine.Object.DestroyImmediate(sun.gameObject);
        UnityEngine.Object.DestroyImmediate(camera.gameObject);
        target.Release();
    }
}
