namespace FastPoints.HostTests.Gpu;

/// <summary>A cloud in the GPU's memory, drawn whole and progressively.</summary>
sealed class ProgressiveStream : IDisposable
{
    const int MaxFrames = 200_000;

    readonly GpuFlightRenderer m_whole;
    readonly GpuFlightRenderer m_progressive;

    public ProgressiveStream(string cloud, PictureOptions options, long budget, bool canCompute = true)
    {
        var shaders = new GpuShaders();
        Options = options;
        Stream = new StreamContext(shaders.CreatePool(256 << 20, 1 << 20));
        Stream.Settings.Selection.PointBudget = budget;
        m_whole = new GpuFlightRenderer(shaders, Stream, options, canCompute);
        m_progressive = new GpuFlightRenderer(shaders, Stream, options, canCompute);
        Add(cloud);
    }

    public StreamContext Stream { get; }
    public PictureOptions Options { get; }
    public DisplayRanges Ranges { get; private set; }
    public PictureCamera Overview { get; private set; }
    public long Drawn { get; private set; }

    public int PointsPerFrame
    {
        get => m_progressive.PointsPerFrame;
        set => m_progressive.PointsPerFrame = value;
    }

    /// <summary>How many points the last progressive frame began with.</summary>
    public long Carried
    {
        get
        {
            object Field(object of, string name) => of.GetType().GetField(name, System.Reflection.BindingFlags.Instance |
                System.Reflection.BindingFlags.NonPublic).GetValue(of);
            var renderer = (PointRenderer)Field(m_progressive, "m_renderer");
            var points = ((ProgressivePictures)Field(renderer, "m_progressive")).PointsOf(TargetEye.Whole);
            var chosen = new uint[4 + 8 * renderer.List.Draws.Length];
            ((GrowingBuffer)Field(points, "m_chosen")).Buffer.GetData(chosen, 0, 0, chosen.Length);
            return Enumerable.Range(0, renderer.List.Draws.Length).Sum(bank => (long)chosen[4 + 8 * bank + 2]);
        }
    }

    public void Add(string cloud)
    {
        var (plan, ranges, number) = FlightCloud.Add(cloud, Stream, Options, default);
        m_whole.Add(number, plan);
        m_progressive.Add(number, plan);
        (Ranges, Overview) = (ranges, plan.Camera);
    }

    /// <summary>All nodes that the camera wants are there.</summary>
    public void Settle(PictureCamera camera)
    {
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
        var view = views;
        view[0] = camera.ToStreamView(Options.WidthPx, Options.HeightPx);
        for (int frame = 0; frame < MaxFrames; frame++)
        {
            var stats = FrameStep.Run(Stream, views);
            m_whole.EndFrame();
            Drawn = stats.DrawnPoints;
            if (stats.IsSettled)
                return;
            Thread.Yield();
        }
        Assert.Fail("streaming did not come to rest");
    }

    public RgbaImage Whole(PictureCamera camera) => m_whole.Draw(camera);

    public RgbaImage Frame(PictureCamera camera) => m_progressive.Draw(camera);

    public double Differs(RgbaImage picture, RgbaImage whole) =>
        ImageError.ShareThatDiffers(picture, whole, Options.Background, out _);

    public double DiffersAtRest(PictureCamera camera, int frames = 40)
    {
        for (int frame = 0; frame < frames; frame++)
            Frame(camera);
        return Differs(Frame(camera), Whole(camera));
    }

    public double Covers(RgbaImage picture, RgbaImage whole) =>
        1 - ImageError.Compare(picture, whole, Options.Background).Uncovered;

    public void Dispose()
    {
        m_whole.Dispose();
        m_progressive.Dispose();
        Stream.Dispose();
    }
}
