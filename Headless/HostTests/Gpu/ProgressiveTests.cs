namespace FastPoints.HostTests.Gpu;

public sealed class ProgressiveTests() : GpuCloudFixture(Points)
{
    const int Points = 150_000;

    static PictureOptions Options(string points, string size)
    {
        var options = new PictureOptions { WidthPx = 320, HeightPx = 180, Color = ColorMode.Rgb, EdlStrength = 0 };
        Assert.That(options.SetStyle("size", size) ?? options.SetStyle("points", points), Is.Null);
        return options;
    }

    ProgressiveStream Stream(string points, string size, bool canCompute = true) =>
        new(CloudPath, Options(points, size), Points, canCompute);

    /// <summary>A third of the way to the cloud.</summary>
    static PictureCamera Near(ProgressiveStream stream)
    {
        var center = stream.Ranges.Robust.Center;
        return PictureCamera.Perspective(center + (stream.Overview.EyeGeo - center) * 0.6, center, new double3(0, 0, 1), 60);
    }

    [TestCase("square", "1", true, 0)]
    [TestCase("square", "1", false, 0.001)]
    [TestCase("round", "4", true, 0.001)]
    [TestCase("square", "3", true, 0.001)]
    [TestCase("paraboloid", "5", true, 0.001)]
    public void Draw_CameraAtRest_ReachesTheWholePicture(string points, string size, bool canCompute, double maxShare)
    {
        using var stream = Stream(points, size, canCompute);
        var camera = Near(stream);
        stream.Settle(camera);
        stream.PointsPerFrame = Points / 8;
        Assert.That(stream.Differs(stream.Frame(camera), stream.Whole(camera)), Is.GreaterThan(0.05), "drawn whole at once");
        Assert.That(stream.DiffersAtRest(camera), Is.LessThanOrEqualTo(maxShare));
        var last = stream.Frame(camera);
        for (int frame = 0; frame < 8; frame++)
            Assert.That(stream.Frame(camera).Rgba, Is.EqualTo(last.Rgba), "it flickers");
    }

    [TestCase("square", "1")]
    [TestCase("round", "3")]
    public void Draw_AfterACutAtAQuarter_CoversNineTenthsInThreeFrames(string points, string size)
    {
        using var stream = Stream(points, size);
        // 94 % and 98 %; 90 % of pixels if blocks were drawn from one end to the other.
        Assert.That(CoveredAfterACut(stream), Is.GreaterThanOrEqualTo(0.91));
    }

    static double CoveredAfterACut(ProgressiveStream stream)
    {
        var camera = Near(stream);
        stream.Settle(stream.Overview);
        stream.PointsPerFrame = (int)(stream.Drawn / 4);
        stream.Frame(stream.Overview);
        stream.Settle(camera);
        var whole = stream.Whole(camera);
        stream.PointsPerFrame = (int)(stream.Drawn / 4);
        var covered = Enumerable.Range(0, 3).Select(_ => stream.Covers(stream.Frame(camera), whole)).ToArray();
        TestContext.Out.WriteLine("covered after a cut: " + string.Join(" ", covered.Select(s => s.ToString("P1"))));
        return covered[2];
    }

    static PictureCamera Along(ProgressiveStream stream, int frame)
    {
        var camera = Near(stream);
        var center = stream.Ranges.Robust.Center;
        double angle = frame * 0.02, sin = math.sin(angle), cos = math.cos(angle);
        var from = (camera.EyeGeo - center) * (1 - frame * 0.01);
        return PictureCamera.Perspective(center + new double3(cos * from.x - sin * from.y, sin * from.x + cos * from.y, from.z),
            center, new double3(0, 0, 1), 60);
    }

    [TestCase("square", "1", true)]
    [TestCase("square", "1", false)]
    [TestCase("round", "3", true)]
    public void Draw_InMotionAtHalf_DiffersLessThanAsManyPointsByLevel(string points, string size, bool canCompute)
    {
        using var stream = Stream(points, size, canCompute);
        using var half = Stream(points, size, canCompute);
        var (progressive, byLevel) = FlipInMotion(stream, half);
        Assert.That(progressive, Is.LessThan(byLevel));
    }

    static (double Progressive, double ByLevel) FlipInMotion(ProgressiveStream stream, ProgressiveStream half)
    {
        double progressive = 0, byLevel = 0;
        const int frames = 24;
        for (int frame = -1; frame < frames; frame++)
        {
            var camera = Along(stream, frame);
            stream.Settle(camera);
            stream.PointsPerFrame = (int)(stream.Drawn / 2);
            half.Stream.Settings.Selection.PointBudget = stream.Drawn / 2;
            half.Settle(camera);
            var whole = stream.Whole(camera);
            var picture = stream.Frame(camera);
            // The first has no picture before it: it is a cut.
            if (frame < 0)
                continue;
            progressive += FlipMap.Of(picture, whole).Mean / frames;
            byLevel += FlipMap.Of(half.Whole(camera), whole).Mean / frames;
        }
        TestContext.Out.WriteLine($"in motion: FLIP {progressive:0.0000}, by level {byLevel:0.0000}");
        return (progressive, byLevel);
    }

    [Category("Long")]
    [TestCase("data/lion.laz", "square", "1")]
    [TestCase("data/lion.laz", "round", "3")]
    [TestCase("data/ca13_d.laz", "square", "1")]
    [TestCase("data/ca13_d.laz", "round", "3")]
    public void Draw_RealScans_AreWholeAtRestAndNearerInMotion(string data, string points, string size)
    {
        string file = TestData.PathOrIgnore(data);
        string cloud = Scratch[Path.GetFileNameWithoutExtension(data) + ".fastpoints"];
        if (!Directory.Exists(cloud))
            Assert.That(CliCall.Of("convert", file, "-o", cloud, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        var options = Options(points, size);
        options.Color = ColorMode.Auto;
        (options.WidthPx, options.HeightPx) = (640, 360);
        using var stream = new ProgressiveStream(cloud, options, 1_000_000);
        using var half = new ProgressiveStream(cloud, options, 500_000);
        Assert.That(CoveredAfterACut(stream), Is.GreaterThanOrEqualTo(0.9));
        double differs = stream.DiffersAtRest(Near(stream));
        TestContext.Out.WriteLine($"at rest {differs:0.00000} differ, of {stream.Drawn} points");
        Assert.That(differs, Is.LessThanOrEqualTo(size == "1" ? 0 : 0.001));
        var (progressive, byLevel) = FlipInMotion(stream, half);
        // Half of lion's points, evenly spaced by level, leave few pixels open: there they are nearer.
        Assert.That(progressive, Is.LessThan(byLevel * (data.Contains("lion") ? 1.4 : 1)));
        double Ms(Func<PictureCamera, RgbaImage> draw)
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            for (int frame = 0; frame < 10; frame++)
                draw(Near(stream));
            return watch.Elapsed.TotalMilliseconds / 10;
        }
        stream.Settle(Near(stream));
        stream.PointsPerFrame = (int)(stream.Drawn / 4);
        stream.Frame(Near(stream));
        TestContext.Out.WriteLine($"ms a frame: all points {Ms(stream.Whole):0}, a quarter {Ms(stream.Frame):0}");
    }

    static void ExpectNothingElse(ProgressiveStream stream, PictureCamera camera)
    {
        stream.Settle(camera);
        var whole = stream.Whole(camera);
        var picture = stream.Frame(camera);
        int covered = 0;
        for (int i = 0; i < whole.Width * whole.Height; i++)
        {
            int x = i % whole.Width, y = i / whole.Width;
            covered += picture[x, y] != stream.Options.Background ? 1 : 0;
            Assert.That(picture[x, y] == stream.Options.Background || whole[x, y] != stream.Options.Background, $"{x}, {y}");
        }
        Assert.That(covered, Is.GreaterThan(100));
    }

    [TestCase("square", "1")]
    [TestCase("round", "3")]
    public void Draw_MovedClippedOrReplaced_LeavesNothingBehind(string points, string size)
    {
        using var stream = Stream(points, size);
        var camera = Near(stream);
        stream.Settle(camera);
        stream.PointsPerFrame = Points / 8;
        for (int frame = 0; frame < 3; frame++)
            stream.Frame(camera);
        var placement = stream.Stream.Clouds[0].Placement;
        placement.OriginWorld += new double3(2, 3, 1) * 0.01 * stream.Ranges.Robust.Size;
        stream.Stream.Clouds[0].Placement = placement;
        ExpectNothingElse(stream, camera);
        var bounds = stream.Ranges.Robust;
        stream.Options.ClipBoxes.Add(new ClipBox(bounds.Min, bounds.Center, true));
        stream.Stream.SetClipBoxes(stream.Options.ClipBoxes);
        ExpectNothingElse(stream, camera);
        stream.Stream.Remove(0);
        stream.Add(CloudPath);
        ExpectNothingElse(stream, camera);
        Assert.That(stream.DiffersAtRest(camera), Is.LessThanOrEqualTo(size == "1" ? 0 : 0.001));
    }

    [Test]
    public void Draw_CameraInsideTheCloud_ReachesTheWholePicture()
    {
        using var stream = Stream("square", "1");
        var center = stream.Ranges.Robust.Center;
        var camera = PictureCamera.Perspective(center, center + new double3(1, 0.5, -0.1), new double3(0, 0, 1), 90);
        stream.Settle(camera);
        stream.PointsPerFrame = (int)(stream.Drawn / 5);
        Assert.That(stream.DiffersAtRest(camera), Is.Zero);
    }

    [TestCase(2, 1)]
    [TestCase(100, 7)]
    public void Draw_OneNode_ReachesTheWholePicture(int points, int perFrame)
    {
        string cloud = Scratch.Converted($"of{points}.fastpoints", points);
        using var stream = new ProgressiveStream(cloud, Options("square", "1"), Points);
        stream.Settle(stream.Overview);
        stream.PointsPerFrame = perFrame;
        Assert.That(stream.DiffersAtRest(stream.Overview, 128), Is.Zero);
    }

    [Test]
    public void Draw_TurnedOff_KeepsNoBuffer()
    {
        using var stream = Stream("square", "1");
        var camera = Near(stream);
        stream.Settle(camera);
        long Used()
        {
            stream.Frame(camera);
            for (int frame = 0; frame < 4; frame++)
                HeadlessGraphics.EndFrame();
            HeadlessGraphics.WaitForIdle();
            return HeadlessGraphics.UsedBytes;
        }
        long off = Used();
        stream.PointsPerFrame = Points / 4;
        long on = Used();
        stream.PointsPerFrame = 0;
        TestContext.Out.WriteLine($"{off} bytes off, {on} on: {(on - off) / (320.0 * 180):0.0} a pixel, {stream.Drawn} points");
        Assert.That(on, Is.GreaterThan(off));
        Assert.That(Used(), Is.EqualTo(off));
    }

    /// <summary>Also on a device whose vertex shaders have buffers enough for all other pictures.</summary>
    [TestCase("splat", "4", null, "splats")]
    [TestCase("round", "4", 2, "buffers")]
    public void Draw_NotPossible_DrawsAllPointsWithOneWarning(string points, string size, int? vertexBuffers, string why)
    {
        var logged = new List<string>();
        var sink = Debug.s_sink;
        (HeadlessGraphics.VertexBuffers, ProgressivePictures.HasWarned) = (vertexBuffers, false);
        try
        {
            using var stream = Stream(points, size);
            var camera = Near(stream);
            stream.Settle(camera);
            var whole = stream.Whole(camera);
            stream.PointsPerFrame = Points / 8;
            Debug.s_sink = (type, text) => logged.Add(text);
            for (int frame = 0; frame < 3; frame++)
                Assert.That(stream.Frame(camera).Rgba, Is.EqualTo(whole.Rgba));
            Assert.That(logged.Single(), Does.Contain(why));
        }
        finally
        {
            (Debug.s_sink, HeadlessGraphics.VertexBuffers) = (sink, null);
        }
    }

    /// <summary>Two clouds in one place: each pixel has two points at its depth.</summary>
    [Test]
    public void Draw_DuplicatePoints_CarriesOneAPixel()
    {
        using var stream = Stream("square", "1");
        stream.Add(CloudPath);
        stream.Stream.Settings.Selection.PointBudget = 2 * Points;
        var camera = Near(stream);
        stream.Settle(camera);
        stream.PointsPerFrame = Points / 2;
        RgbaImage picture = null;
        for (int frame = 0; frame < 20; frame++)
            picture = stream.Frame(camera);
        int covered = Enumerable.Range(0, picture.Width * picture.Height)
            .Count(i => picture[i % picture.Width, i / picture.Width] != stream.Options.Background);
        stream.Frame(camera);
        Assert.That(stream.Carried, Is.EqualTo(covered));
    }
}
