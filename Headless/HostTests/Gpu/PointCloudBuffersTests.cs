namespace FastPoints.HostTests.Gpu;

/// <summary>What effects get of a cloud, point by point against what the CPU unpacks of the same banks.</summary>
public sealed class PointCloudBuffersTests() : GpuCloudFixture(Points)
{
    const int Points = 60_000, MaxFrames = 200_000, HiddenClass = 2;

    const string LoadAll = """
        #pragma kernel LoadAll
        #include "Packages/com.fastpoints.dots/Shaders/PointCloudBuffers.hlsl"
        RWStructuredBuffer<float4> _Loaded;
        [numthreads(64, 1, 1)]
        void LoadAll(uint3 thread : SV_DispatchThreadID)
        {
            float3 position;
            float4 color;
            FastPoints_Load_float(float(thread.x), position, color);
            _Loaded[thread.x * 2u] = float4(position, 0.0);
            _Loaded[thread.x * 2u + 1u] = color;
        }
        """;

    readonly record struct Gathered(float3 Position, uint Color);

    string m_cloud;
    StreamContext m_stream;
    PointScene m_scene;

    [SetUp]
    public void MakeScene()
    {
        m_cloud = CloudPath;
        var shaders = new GpuShaders();
        m_stream = new StreamContext(shaders.CreatePool(16 << 20, 1 << 19));
        m_stream.Settings.Selection.MinScreenErrorPx = 0;
        m_stream.Settings.Selection.MinNodePx = 0;
        var resources = ScriptableObject.CreateInstance<PointCloudResources>();
        resources.Gather = shaders.Gather;
        Resources.Assets[PointCloudResources.Path] = resources;
        PointScene.Current = m_scene = new PointScene(shaders.Points, shaders.Compose, m_stream);
    }

    [TearDown]
    public void EndScene()
    {
        HeadlessGraphics.WaitForIdle();
        m_scene?.Dispose();
        m_stream?.Dispose();
        Resources.Assets.Clear();
        QualitySettings.activeColorSpace = ColorSpace.Gamma;
    }

    // Returns its number. A turned cloud stands far away, enlarged, unevenly.
    int Show(ColorMode mode, bool isTurned = false)
    {
        var source = FolderSource.OpenWhole(m_cloud);
        var placement = CloudPlacement.Geo(source.Grid, source.Root);
        if (isTurned)
            placement = new CloudPlacement(new double3x3(new double3(0, 2, 0), new double3(-1, 0, 0.5), new double3(0, 0.25, 3)),
                new double3(4e6, -2e6, 1e5));
        int cloud = m_stream.Add(source, placement);
        var look = new CloudLook
        {
            Source = mode == ColorMode.Rgb ? ColorSource.Channels
                : mode == ColorMode.Elevation ? ColorSource.Position : ColorSource.Wrapped,
            Plane = mode == ColorMode.Elevation ? 0
                : PlaneOf(source, mode == ColorMode.Rgb ? StoreLayout.ColorName : AttributeNames.Classification),
            ClassPlane = math.max(0, PlaneOf(source, AttributeNames.Classification)),
            HiddenClasses = mode == ColorMode.Elevation ? default : ClassMask.Of(HiddenClass),
            Scale = mode == ColorMode.Rgb ? 1 / 256.0 : 1,
            Palette = Palettes.IndexOf(ColorMode.Classification),
        };
        m_scene.SetLook(cloud, look);
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(1e9) };
        for (int frame = 0; !FrameStep.Run(m_stream, views).IsSettled; frame++, Thread.Yield())
        {
            Assert.That(frame, Is.LessThan(MaxFrames), "streaming did not come to rest");
            HeadlessGraphics.EndFrame();
        }
        Assert.That(m_stream.Drawn.AsArray().ToArray().Select(d => d.Range.Bank).Distinct().Count(),
            Is.GreaterThan(m_cloud == CloudPath ? 1 : 0));
        return cloud;
    }

    static int PlaneOf(NodeSource source, string name) =>
        Array.IndexOf(source.Planes.ToArray(), source.Layout.PlaneOf(name));

    // In the order of the list; an alpha of 0 for what is hidden or clipped, whose colour does not count.
    unsafe List<Gathered> Unpack(int cloud, double3 origin, ColorMode mode)
    {
        var streamed = m_stream.Clouds[cloud];
        var source = streamed.Source;
        using var palettes = Palettes.CreateAll(Allocator.Persistent);
        int palette = Palettes.IndexOf(ColorMode.Classification) * Palettes.Length;
        var banks = new Dictionary<int, byte[]>();
        var all = new List<Gathered>();
        foreach (var drawn in m_stream.Drawn)
        {
            if (!banks.TryGetValue(drawn.Range.Bank, out byte[] bank))
                ((GraphicsNodePool)m_stream.Pool).BufferOf(drawn.Range.Bank).GetData(
                    banks[drawn.Range.Bank] = bank = new byte[m_stream.Pool.BankBytes]);
            var address = streamed.Pages[drawn.Page].Addresses[drawn.Node];
            int blocks = streamed.Pages[drawn.Page].Nodes[drawn.Node].BlockCount;
            fixed (byte* begin = &bank[drawn.Range.FirstPage * NodePool.PageBytes])
            {
                byte* at = begin;
                PlaneView View(int plane)
                {
                    long offset = 0;
                    for (int p = 0; p < plane; p++)
                        offset += streamed.RangeOf(drawn.Page, drawn.Node, p).LengthBytes;
                    var shape = plane == 0 ? PlaneShape.OfPositions(address.IsWide)
                        : source.Layout.Planes[source.Planes[plane]].Shape;
                    return new PlaneView(at + offset, shape, blocks);
                }
                var positions = View(0);
                bool isPlain = mode == ColorMode.Elevation; // Of one colour, which all have.
                var colors = isPlain ? default : View(PlaneOf(source, StoreLayout.ColorName));
                var classes = isPlain ? default : View(PlaneOf(source, AttributeNames.Classification));
                for (int block = 0; block < blocks; block++)
                    for (int i = 0; i < positions.PointsOf(block); i++)
                    {
                        var steps = new double3(address.Corner.X + (double)positions.ValueAt(block, 0, i),
                            address.Corner.Y + (double)positions.ValueAt(block, 1, i),
                            address.Corner.Z + (double)positions.ValueAt(block, 2, i));
                        var world = streamed.Placement.OriginWorld + math.mul(streamed.Placement.Linear,
                            steps * source.Grid.Step);
                        uint number = isPlain ? 0 : (uint)classes.ValueAt(block, 0, i);
                        uint color = isPlain ? palettes[palette] & 0xFFFFFF
                            : mode == ColorMode.Rgb ? (uint)(colors.ValueAt(block, 0, i) >> 8 |
                            colors.ValueAt(block, 1, i) >> 8 << 8 | colors.ValueAt(block, 2, i) >> 8 << 16)
                            : palettes[palette + (int)(number & 0xFF)] & 0xFFFFFF;
                        bool isClipped = m_stream.ClipBoxes.Length > 0 &&
                            math.any(math.abs(math.mul(math.inverse(m_stream.ClipBoxes[0].EdgesWorld),
                                world - m_stream.ClipBoxes[0].CenterWorld)) > 0.5);
                        bool isThere = number != HiddenClass && !isClipped;
                        all.Add(new Gathered((float3)(world - origin), color | (isThere ? 0xFF000000u : 0)));
                    }
            }
        }
        return all;
    }

    static Gathered[] Read(PointCloudBuffers buffers)
    {
        var words = new uint[buffers.Points.count * PointCloudBuffers.BytesPerPoint / sizeof(uint)];
        buffers.Points.GetData(words);
        return Enumerable.Range(0, buffers.Count).Select(i => new Gathered(
            new float3(math.asfloat(words[4 * i]), math.asfloat(words[4 * i + 1]), math.asfloat(words[4 * i + 2])),
            words[4 * i + 3])).ToArray();
    }

    // A few 2^-24 of the distance from the origin: the shader adds up three products.
    static void Check(Gathered[] got, IReadOnlyList<Gathered> wanted)
    {
        Assert.That(got, Has.Length.EqualTo(wanted.Count));
        bool IsSame(int i) => got[i].Color == wanted[i].Color &&
            math.length(got[i].Position - wanted[i].Position) <= math.length(wanted[i].Position) * 6e-7f;
        Assert.That(Enumerable.Range(0, got.Length).Where(i => !IsSame(i)).Select(i => (i, got[i], wanted[i])), Is.Empty);
    }

    double3 Middle(int cloud)
    {
        var source = m_stream.Clouds[cloud].Source;
        using var folder = CloudFolder.Open(m_cloud);
        var middle = (source.Grid.ToGeo(folder.Manifest.BoundsMin) + source.Grid.ToGeo(folder.Manifest.BoundsMax)) / 2;
        var placement = m_stream.Clouds[cloud].Placement;
        return placement.OriginWorld + math.mul(placement.Linear, middle - source.Grid.ToGeo(source.Root.Corner));
    }

    [TestCase(ColorMode.Rgb)]
    [TestCase(ColorMode.Rgb, true)]
    [TestCase(ColorMode.Rgb, false, true)]
    [TestCase(ColorMode.Classification)]
    public void Update_RoomForAll_HasEachPointAsTheCpuUnpacksIt(ColorMode mode, bool isTurned = false, bool isClipped = false)
    {
        int cloud = Show(mode, isTurned);
        var origin = Middle(cloud);
        using var buffers = new PointCloudBuffers(2 * Points);
        if (isClipped)
            m_stream.SetClipBoxes([new ClipBox(origin - 1000, origin + new double3(1.23456, 1000, 1000))]);
        Assert.That(buffers.Update(cloud, origin), Is.True);
        Assert.That((buffers.Count, buffers.Fraction, buffers.OriginWorld), Is.EqualTo((Points, 1.0, origin)));
        var wanted = Unpack(cloud, origin, mode);
        Assert.That(wanted.Count(p => p.Color >> 24 == 0), Is.InRange(1, Points - 1));
        Assert.That(isClipped, Is.EqualTo(wanted.Count(p => p.Color >> 24 != 0 && p.Position.x > 1.3) == 0));
        Check(Read(buffers), wanted);
    }

    /// <summary>A root cube of more than 2^32 steps: 64-bit columns, and an origin at one of its points.</summary>
    [Test]
    public unsafe void Update_WideCloud_HasEachPointAsTheCpuUnpacksIt()
    {
        var random = new Unity.Mathematics.Random(5);
        File.WriteAllLines(Scratch["wide.xyz"], Enumerable.Range(0, 3000).Select(i =>
            string.Join(" ", Enumerable.Range(0, 3).Select(_ => NumberText.Of(Math.Round(
                random.NextDouble(-2e6, 2e6) + i % 3 * 1e9, 3))))));
        m_cloud = Scratch["wide.fastpoints"];
        Assert.That(CliCall.Of("convert", Scratch["wide.xyz"], "-o", m_cloud, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        int cloud = Show(ColorMode.Elevation);
        var streamed = m_stream.Clouds[cloud];
        Assert.That(m_stream.Drawn.AsArray().ToArray().Any(d => streamed.Pages[d.Page].Addresses[d.Node].IsWide));
        var first = Unpack(cloud, 0, ColorMode.Elevation)[0].Position;
        using var buffers = new PointCloudBuffers(3000);
        Assert.That(buffers.Update(cloud, first), Is.True);
        Check(Read(buffers), Unpack(cloud, first, ColorMode.Elevation));
    }

    /// <summary>Also of shares that no float has: the shader counts in 64 bits.</summary>
    [TestCase(1), TestCase(777), TestCase(6667), TestCase(Points - 1)]
    public void Update_MorePointsThanRoom_KeepsAnEvenShare(int maxPoints)
    {
        int cloud = Show(ColorMode.Rgb);
        var origin = Middle(cloud);
        using var buffers = new PointCloudBuffers(maxPoints);
        Assert.That(buffers.Update(cloud, origin), Is.True);
        ulong share = ((ulong)maxPoints << 32) / Points;
        var all = Unpack(cloud, origin, ColorMode.Rgb);
        var wanted = all.Where((_, i) => (ulong)(i + 1) * share >> 32 != (ulong)i * share >> 32).ToList();
        Assert.That(buffers.Count, Is.EqualTo(wanted.Count).And.InRange(maxPoints - 1, maxPoints));
        Assert.That(buffers.Fraction, Is.EqualTo((double)buffers.Count / Points));
        m_scene.ClearLooks();
        Assert.That(buffers.Update(cloud, 0), Is.False, "a cloud that goes leaves its points to the effect");
        Check(Read(buffers), wanted);
    }

    [Test]
    public void Load_InAKernel_GivesWorldPositionsAndTheProjectsColours()
    {
        int cloud = Show(ColorMode.Rgb);
        var origin = Middle(cloud);
        using var buffers = new PointCloudBuffers(Points);
        buffers.Update(cloud, origin);
        File.WriteAllText(Scratch["load.compute"], LoadAll);
        var shader = HeadlessShaders.LoadCompute(Scratch["load.compute"]);
        using var loaded = Structured(2 * (Points + 64), 16);
        var got = new Vector4[loaded.count];
        foreach (var space in new[] { ColorSpace.Gamma, ColorSpace.Linear })
        {
            QualitySettings.activeColorSpace = space;
            buffers.Bind(shader, 0);
            shader.SetBuffer(0, Id("_Loaded"), loaded);
            shader.Dispatch(0, (Points + 32) / 64 + 1, 1, 1);
            loaded.GetData(got);
            var points = Read(buffers);
            bool IsSame(int i)
            {
                var position = (float3)origin + points[i].Position;
                var srgb = new float3(points[i].Color & 0xFF, points[i].Color >> 8 & 0xFF, points[i].Color >> 16 & 0xFF) / 255;
                var color = space == ColorSpace.Linear ? PointLighting.LinearOf(srgb) : srgb;
                var shown = new float3(got[2 * i + 1].x, got[2 * i + 1].y, got[2 * i + 1].z);
                return (got[2 * i].x, got[2 * i].y, got[2 * i].z) == (position.x, position.y, position.z) &&
                    math.cmax(math.abs(shown - color)) < 1e-5f && got[2 * i + 1].w == (points[i].Color >> 24 == 255 ? 1 : 0);
            }
            Assert.That(Enumerable.Range(0, Points).Where(i => !IsSame(i)), Is.Empty);
            Assert.That(Enumerable.Range(Points, 32).Sum(i => got[2 * i + 1].w), Is.Zero, "beyond the last");
        }
    }

    [Test]
    public void Update_NothingShown_AllocatesNothing()
    {
        using var buffers = new PointCloudBuffers(PointCloudBuffers.MaxPointsLimit);
        foreach (int cloud in new[] { -1, 0, 7 })
            Assert.That(buffers.Update(cloud, 0), Is.False);
        Assert.That((buffers.Points, buffers.Count), Is.EqualTo(((GraphicsBuffer)null, 0)));
        Assert.That(() => buffers.Bind(new MaterialPropertyBlock()), Throws.InvalidOperationException);
        foreach (int room in new[] { 0, PointCloudBuffers.MaxPointsLimit + 1 })
            Assert.That(() => new PointCloudBuffers(room), Throws.InstanceOf<ArgumentException>());
    }

    /// <summary>Beside what the safety checks of a test build remember of the list's job.</summary>
    [Test]
    public void Update_AgainAndAgain_MakesNoGarbage()
    {
        int cloud = Show(ColorMode.Rgb);
        using var buffers = new PointCloudBuffers(1000);
        using var sizes = new SizeTree();
        using var list = new DrawList(sizes);
        m_scene.TryGetLook(cloud, out var look);
        list.SetLook(cloud, look);
        long all = 1;
        for (int round = 0; round < 20 && all > 0; round++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            buffers.Update(cloud, 0);
            long between = GC.GetAllocatedBytesForCurrentThread();
            list.Build(m_stream, StreamView.Everything(1));
            all = 2 * between - before - GC.GetAllocatedBytesForCurrentThread();
        }
        Assert.That(all, Is.LessThanOrEqualTo(0));
    }
}
