namespace FastPoints.HostTests.Gpu;

/// <summary>One cloud twice: in ordinary memory and on the GPU, the same nodes of it, so that pictures of both
/// can be compared.</summary>
sealed class TwinStreams : IDisposable
{
    const int MaxFrames = 200_000;

    readonly StreamContext m_cpu;
    readonly StreamContext m_gpu;
    readonly FlightRenderer m_cpuPicture;
    readonly FlightRenderer m_gpuPicture;
    readonly PictureOptions m_options;
    readonly List<PicturePlan> m_plans = [];
    bool m_isFading;

    public TwinStreams(string cloud, PictureOptions options, long budget, Func<CloudPlacement, CloudPlacement> place = null,
        bool canCompute = true)
    {
        m_options = options;
        var shaders = new GpuShaders();
        m_cpu = new StreamContext(new MemoryNodePool(256 << 20, 8 << 20));
        m_gpu = new StreamContext(shaders.CreatePool(256 << 20, 8 << 20));
        m_cpuPicture = new CpuFlightRenderer(m_cpu, options);
        m_gpuPicture = new GpuFlightRenderer(shaders, m_gpu, options, canCompute);
        foreach (var stream in new[] { m_cpu, m_gpu })
        {
            stream.Settings.Selection.MinScreenErrorPx = 0;
            stream.Settings.Selection.MinNodePx = 0;
        }
        SetBudget(budget);
        Add(cloud, options, place);
    }

    public void Add(string cloud, PictureOptions options, Func<CloudPlacement, CloudPlacement> place = null)
    {
        foreach (var (stream, picture) in new[] { (m_cpu, m_cpuPicture), (m_gpu, m_gpuPicture) })
        {
            var (plan, ranges, number) = FlightCloud.Add(cloud, stream, options, default);
            if (place != null)
                stream.Clouds[number].Placement = place(stream.Clouds[number].Placement);
            picture.Add(number, plan);
            Plan = plan;
            m_plans.Add(plan);
            Ranges = ranges;
        }
    }

    /// <summary>Share of covered pixels that may differ. A GPU rounds the corners of squares, and points, to
    /// 1/256 pixel (subPixelPrecisionBits of 8): one of about 500 falls into the pixel beside by that, which changes two,
    /// and more where the edges of large squares do. Discs are cut out pixel by pixel, without that. With eye-dome lighting a
    /// pixel that differs changes the shade of those around it.</summary>
    public double MaxDifferent =>
        !m_options.RoundPoints && !m_options.ParaboloidPoints ? 0.015 : m_options.EdlStrength > 0 ? 0.003 : 0.001;

    public PicturePlan Plan { get; private set; }
    public DisplayRanges Ranges { get; private set; }

    public ShadowMapProjection ShadowMapProjection(PictureCamera camera) => Plan.ShadowFrameFor(m_gpu, camera);

    public void Light(PointLighting light) => m_plans.ForEach(plan => plan.Light = light);

    public void Clip()
    {
        m_cpu.SetClipBoxes(m_options.ClipBoxes);
        m_gpu.SetClipBoxes(m_options.ClipBoxes);
    }

    /// <summary>From now on, of what lies beyond a smaller budget a share of the points is drawn, and more with each
    /// picture.</summary>
    public void BeginFade(PictureCamera camera, long budget, float share)
    {
        Draw(camera);
        SetBudget(budget);
        Draw(camera);
        m_isFading = true;
        foreach (var stream in new[] { m_cpu, m_gpu })
            (stream.Settings.FadeSeconds, stream.FrameSeconds) = (1, share);
        SetBudget(long.MaxValue);
        Draw(camera);
        Assert.That(m_cpu.IsFading && m_gpu.IsFading);
    }

    void SetBudget(long budget)
    {
        foreach (var stream in new[] { m_cpu, m_gpu })
            stream.Settings.Selection.PointBudget = budget;
    }

    /// <summary>The least that the GPU's picture takes, of several.</summary>
    public double LeastMilliseconds(PictureCamera camera, int pictures = 5)
    {
        Settle(m_gpu, m_gpuPicture, camera);
        return Enumerable.Range(0, pictures).Min(_ =>
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            m_gpuPicture.Draw(camera);
            return watch.Elapsed.TotalMilliseconds;
        });
    }

    public (RgbaImage Cpu, RgbaImage Gpu) Draw(PictureCamera camera)
    {
        Settle(m_cpu, m_cpuPicture, camera);
        Settle(m_gpu, m_gpuPicture, camera);
        (int, int, int)[] Drawn(StreamContext stream) =>
            stream.Drawn.AsArray().ToArray().Select(d => (d.Cloud, d.Page, d.Node)).ToArray();
        Assert.That(Drawn(m_gpu), Is.EquivalentTo(Drawn(m_cpu)));
        Assert.That(m_cpu.Drawn.Length, Is.GreaterThan(0));
        return (m_cpuPicture.Draw(camera), m_gpuPicture.Draw(camera));
    }

    /// <summary>Share of the pixels covered in either picture that differ.</summary>
    /// <param name="maxPerChannel">Colours that differ by no more are the same.</param>
    public double ShareThatDiffers((RgbaImage Cpu, RgbaImage Gpu) pictures, out int covered, int maxPerChannel = 0) =>
        ImageError.ShareThatDiffers(pictures.Cpu, pictures.Gpu, m_options.Background, out covered, maxPerChannel);

    public void Dispose()
    {
        m_cpuPicture.Dispose();
        m_gpuPicture.Dispose();
        m_cpu.Dispose();
        m_gpu.Dispose();
    }

    void Settle(StreamContext stream, FlightRenderer picture, PictureCamera camera)
    {
        using var views = new NativeArray<StreamView>(2, Allocator.Persistent);
        for (int frame = 0; frame < MaxFrames; frame++)
        {
            var stats = FrameStep.Run(stream, picture.Plan.ViewsFor(stream, camera, views));
            picture.EndFrame();
            if (stats.IsSettled || m_isFading)
                return;
            Thread.Yield();
        }
        Assert.Fail("streaming did not come to rest");
    }
}
