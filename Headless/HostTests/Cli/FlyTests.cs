namespace FastPoints.HostTests.Cli;

public sealed class FlyTests
{
    const int Points = 30_000;

    ScratchFolder m_scratch;
    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_scratch = new ScratchFolder();
        m_cloud = m_scratch.Converted(points: Points);
    }

    [OneTimeTearDown]
    public void RemoveCloud() => m_scratch.Dispose();

    [Test]
    public void Fly_TwoClouds_WritesPicturesFramesAndTheKeys()
    {
        string folder = m_scratch["flight"];
        var call = CliCall.Of("fly", m_cloud, m_cloud, "--frames", "40", "--every", "10", "--size", "160x90",
            "-o", folder, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        var json = call.Json;
        foreach (string key in new[] { "frames", "garbageBytes", "pointsDrawn", "bytesRead",
            "secondsToFull", "hitches", "disposeMs" })
            Assert.That(json.GetProperty(key).ValueKind, Is.EqualTo(JsonValueKind.Number), key);
        foreach (string key in new[] { "frameMs", "mainThreadMs" })
            foreach (string part in new[] { "p50", "p99", "max" })
                Assert.That(json.GetProperty(key).GetProperty(part).GetDouble(), Is.GreaterThan(0), key);
        Assert.That(json.GetProperty("frames").GetInt32(), Is.EqualTo(40));
        Assert.That(json.GetProperty("pointsDrawn").GetInt64(), Is.InRange(1, 2 * Points));
        Assert.That(json.GetProperty("cuts").EnumerateArray().First().GetProperty("frame").GetInt32(), Is.Zero);
        Assert.That(File.ReadLines(Path.Combine(folder, "frames.csv")).Count(), Is.EqualTo(41));
        var last = Png.Read(Path.Combine(folder, "last.png"));
        Assert.That(last.Rgba.Distinct().Count(), Is.GreaterThan(10), "the picture is empty");
        var first = Png.Read(Path.Combine(folder, "flight.png"));
        Assert.That((first.Width, first.Height), Is.EqualTo((160, 90)));
    }

    [Test]
    public void Fly_PathOfOnesOwn_HasItsFramesAndCuts()
    {
        string path = m_scratch["way.txt"];
        File.WriteAllText(path, "# a comment\n0 -50 -50 30 0 0 0\n10, 50,-50,30, 0,0,0\n12 0 0 5 10 10 0 "
            + "cut\n20 1 0 5 10 10 0\n");
        var call = CliCall.Of("fly", m_cloud, "--path", path, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("frames").GetInt32(), Is.EqualTo(21));
        Assert.That(call.Json.GetProperty("cuts").EnumerateArray().Select(c => c.GetProperty("frame").GetInt32()),
            Is.EqualTo(new[] { 0, 12 }));
    }

    [Test]
    public void Fly_FewerFramesThanAPictureTakes_DrawsTheLast()
    {
        string folder = m_scratch["short"];
        Assert.That(CliCall.Of("fly", m_cloud, "--frames", "3", "--every", "10", "--size", "32x18", "-o", folder).Status,
            Is.EqualTo(ExitStatus.Done));
        Assert.That(Png.Read(Path.Combine(folder, "flight.png")).Rgba,
            Is.EqualTo(Png.Read(Path.Combine(folder, "last.png")).Rgba));
    }

    [TestCase("0 1 2 3 4 5\n", "line 1")]
    [TestCase("0 1 2 3 4 5 6\n0 1 2 3 4 5 6\n", "line 2")]
    [TestCase("0 1 2 3 4 5 nan\n", "line 1")]
    [TestCase("# nothing\n", "no line")]
    public void Fly_PathThatIsNone_SaysWhere(string text, string said)
    {
        string path = m_scratch["bad.txt"];
        File.WriteAllText(path, text);
        var call = CliCall.Of("fly", m_cloud, "--path", path);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Does.Contain(path).And.Contains(said));
    }

    [Test]
    public void Fly_NoCloud_SaysSo()
    {
        var call = CliCall.Of("fly", m_scratch["none.fastpoints"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Failed));
        Assert.That(call.Error, Does.Contain("none.fastpoints"));
    }

    [TestCase("--budget", "0")]
    [TestCase("--every", "0")]
    [TestCase("--every", "3601")]
    [TestCase("--pool", "0")]
    public void Fly_NumberOutOfRange_IsWrongUsage(string option, string value)
    {
        var call = CliCall.Of("fly", m_cloud, option, value);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain(option));
    }

    /// <summary>Clouds as they are, of several formats, beside a converted one.</summary>
    [Test]
    public void Fly_FormatsWithOctreesOfTheirOwn_StreamsThemAsTheyAre()
    {
        string copc = TestData.SampleOrIgnore("copc/simple_with_page.copc.laz");
        string potree = Path.GetDirectoryName(TestData.SampleOrIgnore("potree/v2-mixedconifer-default/metadata.json"));
        string ept = Path.GetDirectoryName(TestData.SampleOrIgnore("ept/bcbf/ept.json"));
        var call = CliCall.Of("fly", copc, potree, ept, m_cloud, "--frames", "60", "--size", "32x18", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("pointsDrawn").GetInt64(), Is.GreaterThan(0));
        Assert.That(call.Json.GetProperty("warnings").GetArrayLength(), Is.Zero);
    }

    [Test]
    public void Fly_FileWithoutAnOctree_FliesOverItsPreview()
    {
        var call = CliCall.Of("fly", m_scratch.Demo(points: 20_000), "--budget", "5000", "--frames", "60", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("pointsDrawn").GetInt64(), Is.InRange(1, 5000));
    }

    /// <summary>The same points in the same places and colours, through packed blocks and without.</summary>
    [TestCase("copc/lone-star.copc.laz", "classification")]
    [TestCase("potree/v2-autzen-brotli", "rgb")]
    [TestCase("ept/lone-star-laszip", "classification")]
    public void Picture_BudgetForAllPoints_IsThePictureOfTheFile(string sample, string color)
    {
        string cloud = sample.EndsWith(".laz") ? TestData.SampleOrIgnore(sample)
            : Path.GetDirectoryName(TestData.SampleOrIgnore(sample
                + (sample.StartsWith("ept") ? "/ept.json" : "/metadata.json")));
        var info = CliCall.Of("info", cloud, "--json", "-").Json.GetProperty("boundsClaimed");
        double[] Corner(string name) => info.GetProperty(name).EnumerateArray().Select(v => v.GetDouble()).ToArray();
        double[] min = Corner("min"), max = Corner("max"), size = min.Zip(max, (a, b) => b - a).ToArray();
        string Place(double x, double y, double z) => System.FormattableString.Invariant(
            $"{min[0] + x * size[0]:R},{min[1] + y * size[1]:R},{min[2] + z * size[2]:R}");
        string[] camera =
        [
            "--eye", Place(-0.2, -0.5, 3), "--target", Place(0.5, 0.5, 0.5), "--size", "320x180",
            "--style", "color=" + color + ",size=2,edl=0",
        ];
        string whole = m_scratch["whole.png"], streamed = m_scratch["streamed.png"];
        Assert.That(CliCall.Of(["picture", cloud, "-o", whole, .. camera]).Status, Is.EqualTo(ExitStatus.Done));
        var call = CliCall.Of(["picture", cloud, "-o", streamed, "--budget", "1000000", "--against",
            whole, "--json", "-", .. camera]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("nodes").GetInt32(), Is.GreaterThan(0));
        // Nodes smaller than a pixel are left out, and which of two points at one depth is seen is chance.
        Assert.That(call.Json.GetProperty("uncovered").GetDouble(), Is.LessThan(0.002));
        Assert.That(call.Json.GetProperty("ssim").GetDouble(), Is.GreaterThan(0.99));
    }

    [Test]
    public void Picture_KindsTogether_AreOnePicture()
    {
        string copc = TestData.SampleOrIgnore("copc/simple_with_page.copc.laz"), converted = m_scratch["page.fastpoints"];
        Assert.That(CliCall.Of("convert", copc, "-o", converted, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        var call = CliCall.Of("picture", converted, copc, "-o", m_scratch["both.png"], "--size", "320x180", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.InRange(1066, 2 * 1065));
    }
}
