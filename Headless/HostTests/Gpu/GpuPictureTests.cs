namespace FastPoints.HostTests.Gpu;

public sealed class GpuPictureTests : GraphicsFixture
{
    const int Points = 40_000;

    ScratchFolder m_scratch;
    string m_demo;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_scratch = new ScratchFolder();
        m_demo = Convert(m_scratch.Demo(points: Points), "demo");
    }

    [OneTimeTearDown]
    public void DeleteCloud() => m_scratch?.Dispose();

    string Convert(string file, string name, params string[] options)
    {
        string folder = m_scratch[name + ".fastpoints"];
        if (Directory.Exists(folder))
            return folder;
        var call = CliCall.Of(["convert", file, "-o", folder, "--sampler", "random", "--quiet", .. options]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        return folder;
    }

    static PictureOptions Options(float sizePx = 1, bool isRound = false, ColorMode color = ColorMode.Rgb) => new()
    {
        WidthPx = 320,
        HeightPx = 180,
        PointSizePx = sizePx,
        RoundPoints = isRound,
        Color = color,
        EdlStrength = 0,
    };

    /// <param name="maxPerChannel">Colours that differ by no more are the same.</param>
    /// <param name="tiedPixels">Of a disc that is as deep as another but for rounding: either may be in front.</param>
    static void Compare(TwinStreams streams, PictureCamera camera, string name, int maxPerChannel = 0, float tiedPixels = 0)
    {
        var pictures = streams.Draw(camera);
        double share = streams.ShareThatDiffers(pictures, out int covered, maxPerChannel);
        string output = Path.Combine(TestContext.CurrentContext.WorkDirectory, "gpu-" + name);
        File.WriteAllBytes(output + "-cpu.png", Png.Encode(pictures.Cpu));
        File.WriteAllBytes(output + "-gpu.png", Png.Encode(pictures.Gpu));
        TestContext.Out.WriteLine(name + ": " + covered + " pixels covered, " + share.ToString("P3") + " differ");
        Assert.That(covered, Is.GreaterThan(500), output);
        Assert.That(share, Is.LessThan(streams.MaxDifferent + tiedPixels / covered), output);
    }

    /// <summary>Points of one pixel are drawn by a compute shader, or as point primitives.</summary>
    [TestCase(1, false)]
    [TestCase(1, false, false)]
    [TestCase(3, false)]
    [TestCase(5, true)]
    public void Draw_Shapes_MatchesTheSoftwareRasterizer(float sizePx, bool isRound, bool canCompute = true)
    {
        using var streams = new TwinStreams(m_demo, Options(sizePx, isRound), Points, canCompute: canCompute);
        Compare(streams, streams.Plan.Camera, "shape-" + sizePx + (canCompute ? "" : "-primitives"));
    }

    [TestCase(ColorMode.Rgb)]
    [TestCase(ColorMode.Elevation)]
    [TestCase(ColorMode.Intensity)]
    [TestCase(ColorMode.Classification)]
    [TestCase(ColorMode.ReturnNumber)]
    [TestCase(ColorMode.PointSource)]
    public void Draw_ColorModes_MatchesTheSoftwareRasterizer(ColorMode mode)
    {
        using var streams = new TwinStreams(m_demo, Options(4, true, mode), Points);
        Assert.That(streams.Plan.Mode, Is.EqualTo(mode));
        Compare(streams, streams.Plan.Camera, "color-" + mode);
    }

    [Test]
    public void Draw_TwoCloudsOfDifferentColours_MatchesTheSoftwareRasterizer()
    {
        var options = Options(4, true, ColorMode.Classification);
        using var streams = new TwinStreams(m_demo, options, 2 * Points);
        var camera = streams.Plan.Camera;
        var alone = streams.Draw(camera).Gpu;
        var other = Options(4, true, ColorMode.Elevation);
        other.ColorRamp = ColorRamp.Turbo;
        var size = streams.Ranges.Robust.Size;
        streams.Add(m_demo, other, placement =>
        {
            placement.OriginWorld += new double3(0, 0, size.z);
            return placement;
        });
        Compare(streams, camera, "two-colours");

        var both = streams.Draw(camera).Gpu;
        using var palettes = Palettes.CreateAll(Unity.Collections.Allocator.Persistent);
        uint[] Of(int palette) => palettes.GetSubArray(palette * Palettes.Length, Palettes.Length).ToArray();
        var classes = Of(Palettes.IndexOf(ColorMode.Classification));
        var turbo = Of(Palettes.IndexOf(ColorMode.Elevation, ColorRamp.Turbo));
        int Count(RgbaImage image, uint[] colors) =>
            Enumerable.Range(0, 320 * 180).Count(i => colors.Contains(image[i % 320, i / 320]));
        Assert.That(Count(alone, turbo), Is.LessThan(Count(both, turbo) / 10));
        Assert.That(Count(both, classes), Is.GreaterThan(500));
    }

    /// <summary>Sizes that differ from point to point: by distance, and by what is drawn at their place.</summary>
    [TestCase("3u", true)]
    [TestCase("3u", false)]
    [TestCase("adaptive", true)]
    [TestCase("adaptive", false)]
    public void Draw_SizesInTheWorld_MatchesTheSoftwareRasterizer(string size, bool isRound)
    {
        var options = Options(0, isRound);
        Assert.That(options.SetStyle("size", size), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points / 2);
        var camera = streams.Plan.Camera;
        var center = streams.Ranges.Robust.Center;
        Compare(streams, camera, "size-" + size + (isRound ? "-round" : ""));
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            2 * streams.Ranges.Robust.Size.y), "size-" + size + (isRound ? "-round" : "") + "-flat");
    }

    [TestCase("1", false)]
    [TestCase("1", false, false)]
    [TestCase("5", true)]
    [TestCase("adaptive", true)]
    public void Draw_EyeDomeLighting_MatchesTheSoftwareRasterizer(string size, bool isRound, bool canCompute = true)
    {
        var options = Options(0, isRound, ColorMode.Elevation);
        options.EdlStrength = 0.4f;
        Assert.That(options.SetStyle("size", size), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points / 2, canCompute: canCompute);
        Compare(streams, streams.Plan.Camera, "edl-" + size);
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            2 * streams.Ranges.Robust.Size.y), "edl-" + size + "-flat");
    }

    /// <summary>A card's last bits of a depth are its own: light by the normal of such depths differs by one 255th. A primitive
    /// that falls into the pixel beside changes the light of four more.</summary>
    [TestCase("1", "round", 0)]
    [TestCase("1", "round", 0, false)]
    [TestCase("5", "round", 0)]
    [TestCase("5", "round", 0.3f)]
    [TestCase("adaptive", "round", 0)]
    [TestCase("adaptive", "paraboloid", 0)]
    [TestCase("5", "splat", 0)]
    public void Draw_Lit_MatchesTheSoftwareRasterizer(string size, string points, float edlStrength, bool canCompute = true)
    {
        var options = Options(0, true, ColorMode.Elevation);
        foreach (var (key, value) in new[] { ("size", size), ("points", points), ("light", "200,40,0.9"), ("holes", "fill") })
            Assert.That(options.SetStyle(key, value), Is.Null);
        options.EdlStrength = edlStrength;
        using var streams = new TwinStreams(m_demo, options, Points, canCompute: canCompute);
        string name = "lit-" + size + points + edlStrength + canCompute;
        Compare(streams, streams.Plan.Camera, name, 1, canCompute ? 0 : 200);
        Assert.That(streams.Draw(streams.Plan.Camera).Gpu.Rgba, Is.EqualTo(streams.Draw(streams.Plan.Camera).Gpu.Rgba));
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            2 * streams.Ranges.Robust.Size.y), name + "-flat", 1, canCompute ? 0 : 200);
    }

    /// <summary>A primitive's point may fall into the pixel beside.</summary>
    [TestCase("1", "round")]
    [TestCase("1", "round", false)]
    [TestCase("5", "round")]
    [TestCase("adaptive", "paraboloid")]
    [TestCase("5", "splat")]
    public void Draw_LitByStoredNormals_MatchesTheSoftwareRasterizer(string size, string points, bool canCompute = true)
    {
        string cloud = Convert(m_scratch.Demo(points: Points), "normals", "--normals");
        var options = Options(0, true, ColorMode.Elevation);
        foreach (var (key, value) in new[] { ("size", size), ("points", points), ("light", "200,40,0.9") })
            Assert.That(options.SetStyle(key, value), Is.Null);
        using var streams = new TwinStreams(cloud, options, Points, canCompute: canCompute);
        string name = "normals-" + size + points + canCompute;
        Compare(streams, streams.Plan.Camera, name, 1, canCompute ? 0 : 50);
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            2 * streams.Ranges.Robust.Size.y), name + "-flat", 1, canCompute ? 0 : 50);
        using var byDepth = new TwinStreams(m_demo, options, Points, canCompute: canCompute);
        Assert.That(streams.Draw(streams.Plan.Camera).Cpu.Rgba, Is.Not.EqualTo(byDepth.Draw(streams.Plan.Camera).Cpu.Rgba));
    }

    /// <summary>From the side, so that the cloud shades itself.</summary>
    [TestCase("1", "round")]
    [TestCase("5", "round")]
    [TestCase("adaptive", "paraboloid")]
    [TestCase("5", "splat")]
    public void Draw_Shadows_MatchesTheSoftwareRasterizer(string size, string points)
    {
        var options = Options(0, true, ColorMode.Elevation);
        foreach (var (key, value) in new[] { ("size", size), ("points", points), ("light", "200,20,1") })
            Assert.That(options.SetStyle(key, value), Is.Null);
        using var lit = new TwinStreams(m_demo, options, Points);
        var camera = lit.Plan.Camera;
        var without = lit.Draw(camera).Cpu;
        options.Shadows = true;
        using var streams = new TwinStreams(m_demo, options, Points);
        string name = "shadows-" + size + points;
        Compare(streams, camera, name, 1);
        Assert.That(streams.Draw(camera).Gpu.Rgba, Is.EqualTo(streams.Draw(camera).Gpu.Rgba));
        var with = streams.Draw(camera).Cpu;
        int darker = Enumerable.Range(0, 320 * 180).Count(i => (with[i % 320, i / 320] >> 8 & 255) + 8 <
            (without[i % 320, i / 320] >> 8 & 255));
        Assert.That(darker, Is.GreaterThan(300));
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            2 * streams.Ranges.Robust.Size.y), name + "-flat", 1);
    }

    /// <summary>A point light, a cone and a second sun, beside the main one.</summary>
    [TestCase(false)]
    [TestCase(true)]
    public void Draw_AdditionalLights_MatchesTheSoftwareRasterizer(bool hasNormals)
    {
        var options = Options(5, true);
        options.LitFraction = 1;
        string cloud = hasNormals ? Convert(m_scratch.Demo(points: Points), "normals", "--normals") : m_demo;
        using var streams = new TwinStreams(cloud, options, Points);
        var camera = streams.Plan.Camera;
        var center = streams.Ranges.Robust.Center;
        var size = (float3)streams.Ranges.Robust.Size;
        float3 middle = (float3)center, eye = (float3)camera.EyeGeo;
        float sizeSq = math.lengthsq(size);
        var light = streams.Plan.Light;
        light.Color = 0.3f;
        streams.Light(light);
        var unlit = streams.Draw(camera).Gpu;
        light.Add(new AdditionalLight
        {
            PositionOrDirection = middle + size / 4,
            Color = new float3(sizeSq / 8, 0, 0),
            OneOverRangeSq = 4 / sizeSq,
            ConeOffset = 1,
        }, eye);
        light.Add(new AdditionalLight
        {
            PositionOrDirection = middle + new float3(0, 0, size.x / 2),
            Color = new float3(0, sizeSq / 8, 0),
            OneOverRangeSq = 1 / sizeSq,
            AxisToLight = new float3(0, 0, 1),
            ConeScale = 3,
            ConeOffset = -2,
        }, eye);
        light.Add(new AdditionalLight
        {
            PositionOrDirection = new float3(1, 0, 0),
            Color = new float3(0, 0, 0.5f),
            ConeOffset = 1,
        }, eye);
        streams.Light(light);
        Compare(streams, camera, "additional" + hasNormals, 1);
        var lit = streams.Draw(camera).Gpu;
        for (int channel = 0; channel < 3; channel++)
            Assert.That(Enumerable.Range(0, 320 * 180).Count(i => lit.Rgba[4 * i + channel] > unlit.Rgba[4 * i + channel] + 8),
                Is.GreaterThan(300), "channel " + channel);
    }

    [Test]
    public void Draw_OneCloudOfTwoLit_LeavesTheOther()
    {
        var options = Options(4, true, ColorMode.Classification);
        options.LitFraction = 0;
        using var streams = new TwinStreams(m_demo, options, 2 * Points);
        var other = Options(4, true, ColorMode.Elevation);
        other.LitFraction = 1;
        var size = streams.Ranges.Robust.Size;
        streams.Add(m_demo, other, placement =>
        {
            placement.OriginWorld += new double3(0, 0, size.z);
            return placement;
        });
        Compare(streams, streams.Plan.Camera, "one-lit", 1);
        using var palettes = Palettes.CreateAll(Unity.Collections.Allocator.Persistent);
        var picture = streams.Draw(streams.Plan.Camera).Gpu;
        int Count(int palette)
        {
            var colors = palettes.GetSubArray(palette * Palettes.Length, Palettes.Length).ToArray();
            return Enumerable.Range(0, 320 * 180).Count(i => colors.Contains(picture[i % 320, i / 320]));
        }
        Assert.That(Count(Palettes.IndexOf(ColorMode.Classification)), Is.GreaterThan(500));
        Assert.That(Count(Palettes.IndexOf(ColorMode.Elevation)), Is.LessThan(500));
    }

    /// <summary>Two million points of a real scan; printed, for the page of rendering.</summary>
    [Category("Long")]
    [TestCase(1, 0)]
    [TestCase(3, 0)]
    [TestCase(3, 0.25f)]
    [TestCase(1, 0, true)]
    [TestCase(3, 0, true)]
    public void Draw_LitTwoMillionPoints_TakesAThirdMoreAtMost(float sizePx, float edlStrength, bool hasNormals = false)
    {
        string lion = TestData.PathOrIgnore("data/lion.laz");
        string cloud = hasNormals ? Convert(lion, "lion-normals", "--normals") : Convert(lion, "lion");
        double Measure(float share, bool hasShadows = false)
        {
            var options = Options(sizePx, true, ColorMode.Elevation);
            options.Shadows = hasShadows;
            (options.WidthPx, options.HeightPx, options.EdlStrength, options.LitFraction) = (1280, 720, edlStrength, share);
            using var streams = new TwinStreams(cloud, options, 2_000_000);
            return streams.LeastMilliseconds(streams.Plan.Camera);
        }
        double unlit = Measure(0), lit = Measure(0.7f), shadowed = Measure(0.7f, true);
        TestContext.Out.WriteLine($"{sizePx} px, lighting {edlStrength}, normals {hasNormals}: {unlit:0} ms, " +
            $"lit {lit:0} ms, {lit / unlit:0.00}, with shadows {shadowed:0} ms");
        Assert.That(lit, Is.LessThan(1.3 * unlit));
    }

    [TestCase(0)]
    [TestCase(0.4f)]
    public void Draw_HolesFilled_MatchesTheSoftwareRasterizer(float edlStrength)
    {
        var options = Options(2, true);
        options.EdlStrength = edlStrength;
        using var open = new TwinStreams(m_demo, options, Points);
        var holes = open.Draw(open.Plan.Camera).Cpu;
        options.FillsHoles = true;
        using var streams = new TwinStreams(m_demo, options, Points);
        Compare(streams, streams.Plan.Camera, "holes-" + edlStrength);
        var filled = streams.Draw(streams.Plan.Camera).Cpu;
        int more = 0;
        for (int i = 0; i < 320 * 180; i++)
        {
            bool wasCovered = holes[i % 320, i / 320] != options.Background;
            more += !wasCovered && filled[i % 320, i / 320] != options.Background ? 1 : 0;
            Assert.That(!wasCovered || filled[i % 320, i / 320] != options.Background);
        }
        Assert.That(more, Is.InRange(20, 2000));
    }

    /// <summary>Weights are rounded to a 32nd of the largest, on either side of it where a card's place of a pixel in a point
    /// differs in its last bits: a mean of few points differs by one 255th then.</summary>
    [TestCase("5", 0)]
    [TestCase("adaptive:3", 0)]
    [TestCase("adaptive:3", 0.3f)]
    [TestCase("0.5u", 0)]
    public void Draw_Splats_MatchesTheSoftwareRasterizer(string size, float edlStrength)
    {
        var options = Options();
        options.EdlStrength = edlStrength;
        Assert.That(options.SetStyle("size", size) ?? options.SetStyle("points", "splat"), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points);
        string name = "splat-" + size.Replace(':', '-') + "-" + edlStrength;
        Compare(streams, streams.Plan.Camera, name, 1);
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            streams.Ranges.Robust.Size.y), name + "-flat", 1);
    }

    [TestCase("7", 0)]
    [TestCase("adaptive", 0)]
    [TestCase("adaptive", 0.4f)]
    public void Draw_Paraboloids_MatchesTheSoftwareRasterizer(string size, float edlStrength)
    {
        var options = Options(0);
        options.EdlStrength = edlStrength;
        Assert.That(options.SetStyle("size", size) ?? options.SetStyle("points", "paraboloid"), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points / 2);
        string name = "paraboloid-" + size + "-" + edlStrength;
        Compare(streams, streams.Plan.Camera, name);
        var center = streams.Ranges.Robust.Center;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0),
            streams.Ranges.Robust.Size.y), name + "-flat");
    }

    [TestCase(false, false)]
    [TestCase(true, false)]
    [TestCase(true, true)]
    [TestCase(true, true, 1)]
    public void Draw_Clipped_MatchesTheSoftwareRasterizer(bool keeps, bool cuts, float sizePx = 3)
    {
        var options = Options(sizePx, sizePx > 1);
        using var streams = new TwinStreams(m_demo, options, Points);
        var bounds = streams.Ranges.Robust;
        var all = streams.Draw(streams.Plan.Camera).Gpu;
        var turned = new ClipBox(bounds.Min, bounds.Center, true);
        double sin = math.sin(0.5), cos = math.cos(0.5);
        turned.EdgesWorld = math.mul(new double3x3(new double3(cos, sin, 0), new double3(-sin, cos, 0), new double3(0, 0, 1)),
            turned.EdgesWorld);
        if (keeps)
            options.ClipBoxes.Add(new ClipBox(bounds.Center - bounds.Size * 0.3, bounds.Center + bounds.Size * 0.3));
        if (cuts)
            options.ClipBoxes.Add(turned);
        streams.Clip();
        Compare(streams, streams.Plan.Camera, "clip-" + keeps + cuts + sizePx);
        var left = streams.Draw(streams.Plan.Camera).Gpu;
        int Covered(RgbaImage image) => Enumerable.Range(0, 320 * 180).Count(i => image[i % 320, i / 320] != options.Background);
        Assert.That(Covered(left), keeps ? Is.LessThan(Covered(all) * 0.8) : (IResolveConstraint)Is.EqualTo(Covered(all)));
    }

    [TestCase(ColorMode.Classification)]
    [TestCase(ColorMode.Rgb)]
    [TestCase(ColorMode.Elevation)]
    public void Draw_ClassesHidden_MatchesTheSoftwareRasterizer(ColorMode mode)
    {
        var options = Options(3, true, mode);
        using var all = new TwinStreams(m_demo, options, Points);
        var everything = all.Draw(all.Plan.Camera).Gpu;
        Assert.That(options.SetStyle("classes", "2+5"), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points);
        Compare(streams, streams.Plan.Camera, "classes-" + mode);
        var some = streams.Draw(streams.Plan.Camera).Gpu;
        Assert.That(some.Rgba, Is.Not.EqualTo(everything.Rgba));
        if (mode != ColorMode.Classification)
            return;
        using var palette = Palettes.Create(mode, Unity.Collections.Allocator.Persistent);
        var wanted = new[] { palette[2], palette[5], options.Background };
        Assert.That(Enumerable.Range(0, 320 * 180).Select(i => some[i % 320, i / 320]).Distinct(), Is.SubsetOf(wanted));
    }

    [TestCase("1", false)]
    [TestCase("1", false, false)]
    [TestCase("3", false)]
    [TestCase("adaptive", true)]
    public void Draw_NodesFading_MatchesTheSoftwareRasterizer(string size, bool isRound, bool canCompute = true)
    {
        var options = Options(0, isRound);
        Assert.That(options.SetStyle("size", size), Is.Null);
        using var streams = new TwinStreams(m_demo, options, Points, canCompute: canCompute);
        var camera = streams.Plan.Camera;
        int Covered(RgbaImage image) => Enumerable.Range(0, 320 * 180).Count(i => image[i % 320, i / 320] != options.Background);
        int all = Covered(streams.Draw(camera).Gpu);
        streams.BeginFade(camera, Points / 8, 0.25f);
        Compare(streams, camera, "fading-" + size + (canCompute ? "" : "-primitives"));
        if (size == "adaptive")
            return;
        int[] covered = Enumerable.Range(0, 3).Select(_ => Covered(streams.Draw(camera).Gpu)).ToArray();
        Assert.That(covered[0], Is.InRange(all / 2, all - 50));
        Assert.That(covered[2], Is.EqualTo(all));
    }

    /// <summary>A camera 1 cm from a point whose coordinates are millions of metres, with points near and far in view.</summary>
    [Test]
    public void Draw_CameraBesideAPoint_MatchesTheSoftwareRasterizer()
    {
        using var streams = new TwinStreams(m_demo, Options(3, true), Points);
        var sample = streams.Ranges.FramingSample;
        var point = sample[sample.Length / 2];
        Assert.That(math.cmax(math.abs(point)), Is.GreaterThan(1e5), "no coordinates of a map");
        var eye = point + new double3(-0.008, 0.006, 0.002);
        var camera = PictureCamera.Perspective(eye, eye + new double3(0.8, -0.6, -0.15), new double3(0, 0, 1), 60);
        Compare(streams, camera, "beside");
    }

    [Test]
    public void Draw_FarAway_MatchesTheSoftwareRasterizer()
    {
        using var streams = new TwinStreams(m_demo, Options(1), Points);
        var camera = streams.Plan.Camera;
        var center = streams.Ranges.Robust.Center;
        var far = PictureCamera.Perspective(center + (camera.EyeGeo - center) * 300, center, new double3(0, 0, 1), 0.15);
        Compare(streams, far, "far");
    }

    [Test]
    public void Draw_Orthographic_MatchesTheSoftwareRasterizer()
    {
        using var streams = new TwinStreams(m_demo, Options(2), Points);
        var center = streams.Ranges.Robust.Center;
        var size = streams.Ranges.Robust.Size;
        Compare(streams, PictureCamera.Orthographic(center, center + new double3(0.3, 0.4, -1), new double3(0, 1, 0), size.y),
            "orthographic");
    }

    [TestCase(1e-3)]
    [TestCase(1)]
    [TestCase(1e6)]
    public void Draw_PlacedInTheWorld_MatchesTheSoftwareRasterizer(double scale)
    {
        double sin = math.sin(0.7), cos = math.cos(0.7);
        var linear = math.mul(new double3x3(new double3(cos, sin, 0), new double3(-sin, cos, 0), new double3(0, 0, 1)),
            new double3x3(new double3(scale, 0, 0), new double3(0, scale * 1.5, 0), new double3(0, 0, scale * 0.8)));
        using var streams = new TwinStreams(m_demo, Options(3, true), Points,
            geo => new CloudPlacement(math.mul(linear, geo.Linear), math.mul(linear, geo.OriginWorld)));
        var camera = streams.Plan.Camera;
        var eye = math.mul(linear, camera.EyeGeo);
        var center = math.mul(linear, streams.Ranges.Robust.Center);
        Compare(streams, PictureCamera.Perspective(eye, center, new double3(0, 0, 1), 60), "placed-" + scale);
    }

    [Category("Long")]
    [TestCase("data/lion.laz", 1)]
    [TestCase("data/lion.laz", 5)]
    [TestCase("data/ca13_d.laz", 1)]
    [TestCase("data/ca13_d.laz", 4)]
    public void Draw_RealScans_MatchesTheSoftwareRasterizer(string data, float sizePx)
    {
        string name = Path.GetFileNameWithoutExtension(data);
        string cloud = Convert(TestData.PathOrIgnore(data), name);
        using var streams = new TwinStreams(cloud, Options(sizePx, sizePx > 3, ColorMode.Auto), 60_000);
        Compare(streams, streams.Plan.Camera, name + "-overview-" + sizePx, 0, 2 * sizePx);
        var camera = streams.Plan.Camera;
        var near = camera.EyeGeo + (streams.Ranges.Robust.Center - camera.EyeGeo) * 0.7;
        Compare(streams, PictureCamera.Perspective(near, streams.Ranges.Robust.Center, new double3(0, 0, 1), 60),
            name + "-near-" + sizePx);
    }
}
