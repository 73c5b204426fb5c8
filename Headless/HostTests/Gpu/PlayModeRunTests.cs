namespace FastPoints.HostTests.Gpu;

[NonParallelizable]
public sealed class PlayModeRunTests : GraphicsFixture
{
    EditorProject m_project;
    World m_world;

    [SetUp]
    public void OpenProject()
    {
        m_project = new EditorProject();
        Application.isBatchMode = true;
        m_world = World.DefaultGameObjectInjectionWorld = new World("default");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup).Assembly.GetTypes()
            .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray());
        PipelineFixture.AddResources(new GpuShaders());
    }

    [TearDown]
    public void CloseProject()
    {
        (EditorApplication.isPlaying, Application.isBatchMode) = (false, false);
        SceneLoop.Clear();
        BuiltInPass.End();
        HeadlessGraphics.WaitForIdle();
        m_world.Dispose();
        (World.DefaultGameObjectInjectionWorld, Camera.main) = (null, null);
        Resources.Assets.Clear();
        m_project.Dispose();
    }

    [Test]
    public void PlayModeTests_InBatchMode_SeeTheCloud()
    {
        const string test = nameof(PlayModeTests.PlayMode_CloudInTheScene_IsStreamedForTheCamera);
        Assert.That(() => new EditModeRun(typeof(PlayModeTests), test) { Frame = Frame }.Run(), Throws.Nothing);
    }

    void Frame()
    {
        // Loaded scripts do this too: adding twice adds once.
        BuiltInPass.Begin();
        if (Camera.main != null)
        {
            // Ten metres before the scene's origin, one above it.
            Camera.main.projectionMatrix = Matrix4x4.Perspective(60, 16 / 9f, 0.3f, 1000);
            var view = Matrix4x4.identity;
            view.SetRow(1, new Vector4(0, 1, 0, -1));
            view.SetRow(2, new Vector4(0, 0, -1, -10));
            Camera.main.worldToCameraMatrix = view;
        }
        SceneLoop.Update();
        m_world.Update();
        HeadlessGraphics.EndFrame();
        Thread.Yield();
    }
}
