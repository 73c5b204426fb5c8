using FastPoints.Samples.Dissolve;
using PointCloud = FastPoints.Entities.PointCloud;

namespace FastPoints.HostTests.Samples;

/// <summary>The sample with its own shader, in the Built-in pipeline.</summary>
public sealed class DissolveTests : GraphicsFixture
{
    const int WidthPx = 160, HeightPx = 90, Points = 20_000;

    ScratchFolder m_scratch;
    World m_world;
    Camera m_camera;
    RenderTexture m_target;

    [SetUp]
    public void Play()
    {
        m_scratch = new ScratchFolder();
        m_world = World.DefaultGameObjectInjectionWorld = new World("game");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup).Assembly.GetTypes()
            .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray());
        var shaders = new GpuShaders();
        Gpu.PipelineFixture.AddResources(shaders).Gather = shaders.Gather;
        BuiltInPass.Begin();
        SceneLoop.IsPlaying = true;
        m_target = new RenderTexture(WidthPx, HeightPx, GraphicsFormat.R8G8B8A8_UNorm, GraphicsFormat.D32_SFloat);
        m_target.Create();
        m_camera = new GameObject("camera").AddComponent<Camera>();
        m_camera.targetTexture = m_target;
        m_camera.projectionMatrix = Matrix4x4.Perspective(60, WidthPx / (float)HeightPx, 0.1f, 1000);
        m_camera.transform.SetPositionAndRotation(new Vector3(0, 30, -70), Quaternion.LookRotation(new Vector3(0, -0.4f, 1)));
    }

    [TearDown]
    public void Stop()
    {
        SceneLoop.Clear();
        SceneLoop.Update();
        SceneLoop.IsPlaying = false;
        BuiltInPass.End();
        HeadlessGraphics.WaitForIdle();
        m_world.Dispose();
        World.DefaultGameObjectInjectionWorld = null;
        m_target.Release();
        Resources.Assets.Clear();
        m_scratch.Dispose();
    }

    // As large as the cloud's own points, until they fly.
    DissolveCloud Show()
    {
        var settings = new GameObject("settings").AddComponent<PointCloudSettings>();
        (settings.Shape, settings.SizeMode, settings.Size) = (PointShape.Disc, PointSizeMode.World, 1);
        (settings.MaxSizePx, settings.FadeSeconds) = (1000, 0);
        var cloud = new GameObject("scan").AddComponent<PointCloud>();
        cloud.Path = m_scratch.Converted(points: Points);
        var dissolve = cloud.gameObject.AddComponent<DissolveCloud>();
        (dissolve.Radius, dissolve.Seconds) = (settings.Size / 2, 60);
        string shader = Path.Combine(Checkout.Repository.PackageRoot, "Samples~/Dissolve/Dissolve.shader");
        dissolve.Shader = HeadlessShaders.Load(shader);
        Assert.That(dissolve.Begin(), Is.False, "nothing is shown yet");
        AwaitPoints();
        return dissolve;
    }

    void AwaitPoints()
    {
        var group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        ImportProject.Updates(Frame, () => group.Stats.IsSettled && group.Stats.DrawnPoints > 0);
    }

    void Frame()
    {
        SceneLoop.Update();
        m_camera.Render();
        m_world.Update();
        HeadlessGraphics.EndFrame();
    }

    uint[] Picture()
    {
        m_camera.Render();
        return Read<uint>(m_target);
    }

    static int Covered(uint[] picture) => picture.Count(p => (p & 0xFFFFFF) != 0);

    [Test]
    public void Begin_ShownCloud_BecomesParticlesThatGo()
    {
        var dissolve = Show();
        var asCloud = Picture();
        Assert.That(Covered(asCloud), Is.GreaterThan(1000));
        Assert.That(dissolve.Begin(), Is.True);
        Frame();
        var first = Picture();
        Assert.That(dissolve.GetComponent<PointCloud>().Number, Is.EqualTo(-1), "the cloud is hidden");
        int differ = Enumerable.Range(0, first.Length).Count(i => first[i] != asCloud[i]);
        Assert.That(differ, Is.LessThan(Covered(asCloud) / 100), "nothing has moved yet");
        dissolve.Seconds = 0.5f;
        ImportProject.Updates(Frame, () => dissolve.Progress == 1);
        Assert.That(Covered(Picture()), Is.Zero, "all have gone");
        dissolve.End();
        AwaitPoints();
        Assert.That(Picture(), Is.EqualTo(asCloud));
        Assert.That(dissolve.Begin(), Is.True);
        HeadlessGraphics.WaitForIdle();
        long used = HeadlessGraphics.UsedBytes;
        dissolve.enabled = false;
        HeadlessGraphics.WaitForIdle();
        Assert.That(HeadlessGraphics.UsedBytes, Is.LessThanOrEqualTo(used - dissolve.MaxParticles * 16L));
    }
}
