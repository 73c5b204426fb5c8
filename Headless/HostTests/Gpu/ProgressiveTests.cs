using FastPoints.Evaluation;
using UnityOutside.Tests.StandIns.Graphics;

namespace FastPoints.HostTests.Gpu;

public sealed class ProgressiveTests : GraphicsFixture
{
    const int Points = 150_000;

    ScratchFolder m_scratch;
    string m_demo;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_scratch = new ScratchFolder();
        m_demo = m_scratch.Converted(points: Points);
    }

    [OneTimeTearDown]
    public void DeleteCloud() => m_scratch?.Dispose();

    static PictureOptions Options(string points, string size)
    {
        var options = new PictureOptions { WidthPx = 320, HeightPx = 180, Color = ColorMode.Rgb, EdlStrength = 0 };
        Assert.That(options.TrySetStyle("size", size, out string error) && options.TrySetStyle("points", points, out error), error);
        return options;
    }

    ProgressiveStream Stream(string points, string size, bool canCompute = true) =>
        new(m_demo, Options(points, size), Points, canCompute);

    /// <summary>A third of the way to the cloud.</summary>
    static PictureCamera Near(ProgressiveStream stream)
    {
        var center = stream.Ranges.Robust.Center;
        return PictureCamera.Perspective(center + (stream.Overview.EyeGeo - center) * 0.6, center, new double3(0, 0, 1), 60);
    }

    static void Save(string name, RgbaImage picture) => File.WriteAllBytes(
        Path.Combine(TestContext.CurrentContext.WorkDirectory, "progressive-" + name + ".png"), Png.Encode(picture));

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
        var whole = stream.Whole(camera);
        stream.PointsPerFrame = Points / 8;
        var shares = new List<double>();
        RgbaImage last = null;
        for (int frame = 0; frame < 130; frame++)
            shares.Add(stream.Differs(last = stream.Frame(camera), whole));
        TestContext.Out.WriteLine(points + size + ": " + string.Join(" ", shares.Select(s => s.ToString("0.0000"))));
        Save("rest-" + points + size + "-whole", whole);
        Save("rest-" + points + size, last);
        Assert.That(shares[0], Is.GreaterThan(0.05), "drawn whole at once");
        Assert.That(shares[^1], Is.LessThanOrEqualTo(maxShare));
    }

    [TestCase("square", "1")]
    [TestCase("round", "3")]
    public void Draw_AfterACutAtAQuarter_CoversNineTenthsInThreeFrames(string points, string size)
    {
        using var stream = Stream(points, size);
        var camera = Near(stream);
        stream.PointsPerFrame = Points / 4;
        stream.Settle(stream.Overview);
        stream.Frame(stream.Overview);
        stream.Settle(camera);
        var whole = stream.Whole(camera);
        stream.PointsPerFrame = (int)(stream.Drawn / 4);
        var covered = Enumerable.Range(0, 3).Select(_ => stream.Covers(stream.Frame(camera), whole)).ToArray();
        TestContext.Out.WriteLine(points + size + ": " + string.Join(" ", covered.Select(s => s.ToString("P1"))));
        Assert.That(covered[2], Is.GreaterThanOrEqualTo(0.9));
    }
}
