namespace FastPoints.HostTests.Gpu;

/// <summary>One converted cloud for all tests of a fixture.</summary>
public abstract class GpuCloudFixture(int points) : GraphicsFixture
{
    private protected ScratchFolder Scratch { get; private set; }
    private protected string CloudPath { get; private set; }

    [OneTimeSetUp]
    public void MakeCloud()
    {
        Scratch = new ScratchFolder();
        CloudPath = Scratch.Converted(points: points);
    }

    [OneTimeTearDown]
    public void DeleteCloud() => Scratch?.Dispose();
}

public abstract class PipelineFixture() : GpuCloudFixture(30_000)
{
    protected const int WidthPx = 320, HeightPx = 180;
    protected const int MaxFrames = 200_000;

    static readonly List<(Camera Camera, RenderTexture Target)> s_cameras = new();

    World m_world;

    protected PointCloudSystemGroup Group { get; private set; }
    internal PointScene Scene { get; private set; }
    protected Entity Cloud { get; private set; }
    protected EntityManager Entities => m_world.EntityManager;

    private protected PipelineHost Pipeline { get; private set; }

    /// <summary>Whether a compute shader draws points of one pixel.</summary>
    protected virtual bool HasRaster => false;

    protected void Begin(string pipeline) => Pipeline = PipelineHost.Make(pipeline);

    [SetUp]
    public void MakeWorld()
    {
        m_world = new World("game");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(PointCloudSystemGroup),
            typeof(CollectViewsSystem), typeof(AddCloudsSystem), typeof(ReceiveNodesSystem), typeof(ControlNodesSystem),
            typeof(SelectNodesSystem), typeof(UploadNodesSystem), typeof(RequestNodesSystem), typeof(ListNodesSystem),
            typeof(TrackNodesSystem));
        Group = m_world.GetExistingSystemManaged<PointCloudSystemGroup>();
        var shaders = new GpuShaders();
        Group.Begin(shaders.CreatePool(64 << 20, 8 << 20));
        Group.Stream.Settings.Selection.MinNodePx = 0;
        Group.Stream.Settings.Selection.MinScreenErrorPx = 0;
        PointScene.Current = Scene = new PointScene(shaders.Points, shaders.Compose, Group.Stream,
            HasRaster ? shaders.Raster : null, shaders.Progressive)
        {
            Style = new PointStyle { Shape = PointShape.Disc, Size = PointSize.Pixels(3) },
        };
    }

    // As a project has them, without those for progressive pictures and for nodes' buffers.
    internal static PointCloudResources AddResources(GpuShaders shaders)
    {
        var resources = ScriptableObject.CreateInstance<PointCloudResources>();
        (resources.Points, resources.Compose) = (shaders.Points, shaders.Compose);
        (resources.Raster, resources.CopyPages) = (shaders.Raster, shaders.CopyPages);
        Resources.Assets[PointCloudResources.Path] = resources;
        return resources;
    }

    [TearDown]
    public void EndWorld()
    {
        foreach (var (camera, target) in s_cameras)
        {
            if (camera != null)
                UnityEngine.Object.DestroyImmediate(camera.gameObject);
            target.Release();
        }
        s_cameras.Clear();
        Pipeline?.Dispose();
        HeadlessGraphics.WaitForIdle();
        Scene.Dispose();
        m_world.Dispose();
    }

    internal PicturePlan Add(StreamContext reference, PictureOptions options, out CloudPlacement placement)
    {
        var (plan, ranges, number) = FlightCloud.Add(CloudPath, reference, options, default);
        placement = reference.Clouds[number].Placement;
        placement.OriginWorld -= math.round(ranges.Robust.Center);
        reference.Clouds[number].Placement = placement;
        var source = new FolderSource(Store.CloudFolder.Open(CloudPath), Store.StoreLayout.ColorName);
        Cloud = Entities.CreateEntity(ComponentType.ReadWrite<PointCloudPlacement>());
        Entities.SetComponentData(Cloud, new PointCloudPlacement { Value = placement });
        Group.SetSource(Cloud, source);
        Scene.SetLook(0, CloudLooks.Of(plan.Colors, source));
        return plan;
    }

    /// <summary>A camera that the end of the test destroys, and releases its target.</summary>
    protected static Camera CameraAt(PictureCamera at, Matrix4x4 projection, RenderTexture target)
    {
        var camera = new GameObject("camera").AddComponent<Camera>();
        var matrix = Matrix4x4.identity;
        matrix.SetColumn(3, new Vector4((float)at.EyeGeo.x, (float)at.EyeGeo.y, (float)at.EyeGeo.z, 1));
        SceneLoop.Place(camera.transform, matrix);
        camera.worldToCameraMatrix = ViewOf(at);
        camera.projectionMatrix = projection;
        camera.targetTexture = target;
        s_cameras.Add((camera, target));
        return camera;
    }

    protected static Matrix4x4 ViewOf(PictureCamera at)
    {
        var view = Matrix4x4.identity;
        view.SetRow(0, Row(at.Right, at.EyeGeo));
        view.SetRow(1, Row(at.Up, at.EyeGeo));
        view.SetRow(2, Row(-at.Forward, at.EyeGeo));
        return view;
    }

    static Vector4 Row(double3 axis, double3 eye) =>
        new Vector4((float)axis.x, (float)axis.y, (float)axis.z, (float)-math.dot(axis, eye));

    protected void RenderOnce(Camera camera) => Pipeline.Render(camera);

    protected void UpdateWorld()
    {
        m_world.Update();
        HeadlessGraphics.EndFrame();
    }

    protected RgbaImage Render(Camera camera, int slice = 0)
    {
        for (int frame = 0; frame < MaxFrames; frame++)
        {
            Pipeline.Render(camera);
            UpdateWorld();
            if (frame > 2 && Group.Stats.IsSettled)
                break;
            Thread.Yield();
        }
        Assert.That(Group.Stats.IsSettled, Is.True, "streaming did not come to rest");
        Pipeline.Render(camera);
        return Picture(camera.targetTexture, slice);
    }

    protected static RgbaImage Picture(RenderTexture target, int slice = 0)
    {
        var request = AsyncGPUReadback.Request(target);
        request.WaitForCompletion();
        // Into a texture the engine draws with the lowest row first.
        var pixels = request.GetData<byte>(slice).ToArray();
        var image = new RgbaImage(WidthPx, HeightPx);
        for (int row = 0; row < HeightPx; row++)
            Array.Copy(pixels, (HeightPx - 1 - row) * WidthPx * 4, image.Rgba, row * WidthPx * 4, WidthPx * 4);
        return image;
    }
}
