namespace FastPoints.HostTests.Cli;

public sealed class FlyTests : ScratchTests
{
    const int Points = 30_000;

    string m_cloud;

    [OneTimeSetUp]
    public void MakeCloud() => m_cloud = Scratch.Converted(points: Points);

    // South of the middle of the demo cloud, which it looks at.
    static string Way(int frame, double north, string cut = "") => System.FormattableString.Invariant(
        $"{frame} 441000 {5612020 + north} 160 441000 5612020 125{cut}\n");

    [Test]
    public void Fly_TwoClouds_WritesPicturesFramesAndTheKeys()
    {
        string folder = Scratch["flight"];
        var call = CliCall.Of("fly", m_cloud, m_cloud, "--frames", "40", "--every", "10", "--size", "160x90",
            "-o", folder, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        var json = call.Json;
        foreach (string key in new[] { "frames", "garbageBytes", "garbageBytesAfter60Frames", "firstFrameMs",
            "mostLaterMs", "pointsDrawn", "bytesRead",
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
        string[] animations = Directory.GetFiles(folder, "flight.*");
        Assert.That(animations, Has.Length.EqualTo(1), "the smaller");
        Assert.That(json.GetProperty("animation").GetString(), Is.EqualTo(animations[0]));
        Assert.That(json.GetProperty("bytes").GetInt64(), Is.EqualTo(new FileInfo(animations[0]).Length));
        if (AnimatedWebp.CanWrite)
            Assert.That(Path.GetExtension(animations[0]), Is.EqualTo(".webp"));
    }

    [Test]
    public void Fly_Popping_IsNoneWhileTheSameNodesAreDrawn()
    {
        // The camera moves a little over a small cloud that is whole after the first frames; then it is cut.
        string folder = Scratch["popping"], path = Scratch["slow.txt"];
        File.WriteAllText(path, Way(0, -90) + Way(40, -88) + Way(41, 90, " cut") + Way(45, 90));
        var call = CliCall.Of("fly", m_cloud, "--popping", "--path", path, "--upload", "64",
            "--size", "64x36", "-o", folder, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        var popping = File.ReadLines(Path.Combine(folder, "frames.csv")).Skip(1).Select(line => line.Split(',')[^1]).ToList();
        Assert.That(Enumerable.Range(0, popping.Count).Where(i => popping[i] == ""), Is.EqualTo(new[] { 0, 41 }), "cuts");
        var flips = popping.Select(p => p == "" ? 0 : double.Parse(p, CultureInfo.InvariantCulture)).ToList();
        Assert.That(flips.Max(), Is.GreaterThan(0.01), "nodes arrive");
        Assert.That(flips.Skip(30).Take(11), Is.All.Zero, "nothing but the camera changes");
        var json = call.Json.GetProperty("popping");
        Assert.That(json.GetProperty("max").GetDouble(), Is.EqualTo(flips.Max()).Within(1e-6));
        Assert.That(json.GetProperty("frameOfMax").GetInt32(), Is.EqualTo(flips.IndexOf(flips.Max())));
        Assert.That(json.GetProperty("mean").GetDouble(), Is.EqualTo(flips.Sum() / 44).Within(1e-6));
        Assert.That(call.Json.GetProperty("poppingWhenLoaded").GetProperty("max").GetDouble(), Is.LessThan(flips.Max()));
        Assert.That(File.ReadAllText(Path.Combine(folder, "report.html")), Does.Contain("Popping"));
    }

    [Test]
    public void Fly_PoppingOnAGpu_IsWrongUsage() =>
        Assert.That(CliCall.Of("fly", m_cloud, "--popping", "--gpu").Status, Is.EqualTo(ExitStatus.Usage));

    /// <summary>The safety checks of the test build remember each job, in all frames alike. What the first ones make beyond
    /// that grows the pools: 143 kB here, 31 kB without the checks.</summary>
    [Test]
    public void Fly_FirstFrames_AllocateOnlyPools()
    {
        var call = CliCall.Of("fly", m_cloud, "--frames", "120", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        long all = call.Json.GetProperty("garbageBytes").GetInt64();
        long later = call.Json.GetProperty("garbageBytesAfter60Frames").GetInt64();
        Assert.That(all - 2 * later, Is.LessThan(160_000), $"{all} bytes, {later} of them after 60 frames");
    }

    [Test]
    public void Fly_CustomPath_HasItsFramesAndCuts()
    {
        string path = Scratch["way.txt"];
        File.WriteAllText(path, "# a comment\n0 -50 -50 30 0 0 0\n10, 50,-50,30, 0,0,0\n12 0 0 5 10 10 0 "
            + "cut\n20 1 0 5 10 10 0\n");
        var call = CliCall.Of("fly", m_cloud, "--path", path, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("frames").GetInt32(), Is.EqualTo(21));
        Assert.That(call.Json.GetProperty("cuts").EnumerateArray().Select(c => c.GetProperty("frame").GetInt32()),
            Is.EqualTo(new[] { 0, 12 }));
    }

    [Test]
    public void Fly_FewerFramesThanOnePicture_DrawsTheLast()
    {
        string[] outputs = [Scratch["short"], Scratch["short.png"], Scratch["single-%04d.png"]];
        // It stands still until all is loaded: a flight shows what is there by then.
        string still = Scratch["still.txt"];
        File.WriteAllText(still, Way(0, -90) + Way(150, -90));
        foreach (string output in outputs)
            Assert.That(CliCall.Of("fly", m_cloud, "--path", still, "--every", "1000", "--size", "32x18", "-o", output).Status,
                Is.EqualTo(ExitStatus.Done), output);
        byte[] last = Png.Read(Path.Combine(outputs[0], "last.png")).Rgba;
        Assert.That(last.Distinct().Count(), Is.GreaterThan(10), "the picture is empty");
        Assert.That(Png.Read(outputs[1]).Rgba, Is.EqualTo(last));
        Assert.That(Png.Read(Scratch["single-0000.png"]).Rgba, Is.EqualTo(last));
    }

    [Test]
    public void Fly_WebpName_WritesAnAnimationWithAFrameForEachPicture()
    {
        if (!AnimatedWebp.CanWrite)
            Assert.Ignore("no libwebp here, WebP is not tried; with root: apt-get install libwebp7");
        string output = Scratch["flight.webp"];
        // The second is written over the first, which is the tool's own.
        for (int i = 0; i < 2; i++)
            Assert.That(CliCall.Of("fly", m_cloud, "--frames", "35", "--every", "10", "--size", "33x17", "-o", output).Status,
                Is.EqualTo(ExitStatus.Done));
        byte[] file = File.ReadAllBytes(output);
        Assert.That(BitConverter.ToUInt32(file, 4), Is.EqualTo(file.Length - 8));
        var chunks = new List<string>();
        for (int at = 12; at < file.Length; at += 8 + BitConverter.ToInt32(file, at + 4))
        {
            chunks.Add(Encoding.ASCII.GetString(file, at, 4));
            if (chunks[^1] != "ANMF")
                continue;
            Assert.That((file[at + 14], file[at + 17], BitConverter.ToInt32(file, at + 19) >> 8), Is.EqualTo((32, 16, 166)));
            Assert.That(Encoding.ASCII.GetString(file, at + 24, 4), Is.EqualTo("VP8 "));
        }
        Assert.That(chunks, Is.EqualTo(new[] { "VP8X", "ANIM", "MADE", "ANMF", "ANMF", "ANMF" }));
        Assert.That(Directory.GetFiles(Path.GetDirectoryName(output)!, "flight.*"), Is.EqualTo(new[] { output }), "nothing else");
    }

    [Test]
    public void FlightPictures_WithoutLibwebp_WritesPngUnlessWebpIsNamed()
    {
        var options = new PictureOptions { WidthPx = 32, HeightPx = 18 };
        Assert.That(() => new FlightOutput(Scratch["x.webp"], options, 1, 100, canWebp: false),
            Throws.TypeOf<UsageException>().With.Message.Contains("libwebp"));
        string folder = Directory.CreateDirectory(Scratch["without"]).FullName;
        using var pictures = new FlightOutput(folder, options, 1, 100, canWebp: false);
        pictures.Add(new RgbaImage(32, 18));
        pictures.Commit();
        Assert.That(Directory.GetFiles(folder), Is.EqualTo(new[] { pictures.CommittedPath }));
        Assert.That(pictures.CommittedPath, Does.EndWith("flight.png"));
    }

    [TestCase("0 1 2 3 4 5\n", "line 1")]
    [TestCase("0 1 2 3 4 5 6\n0 1 2 3 4 5 6\n", "line 2")]
    [TestCase("0 1 2 3 4 5 nan\n", "line 1")]
    [TestCase("# nothing\n", "no line")]
    public void Fly_InvalidPath_NamesTheLine(string text, string said)
    {
        string path = Scratch["bad.txt"];
        File.WriteAllText(path, text);
        var call = CliCall.Of("fly", m_cloud, "--path", path);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Does.Contain(path).And.Contains(said));
    }

    [Test]
    public void Fly_NoCloud_ReportsIt()
    {
        var call = CliCall.Of("fly", Scratch["none.fastpoints"]);
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

    [Test]
    public void Fly_FormatsWithAnOctree_AreStreamedDirectly()
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
    public void Fly_FileWithoutAnOctree_ShowsItsPreview()
    {
        var call = CliCall.Of("fly", Scratch.Demo(points: 20_000), "--budget", "5000", "--frames", "60", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("pointsDrawn").GetInt64(), Is.InRange(1, 5000));
    }

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
        string whole = Scratch["whole.png"], streamed = Scratch["streamed.png"];
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
    public void Picture_DifferentFormats_AreOnePicture()
    {
        string copc = TestData.SampleOrIgnore("copc/simple_with_page.copc.laz"), converted = Scratch["page.fastpoints"];
        Assert.That(CliCall.Of("convert", copc, "-o", converted, "--quiet").Status, Is.EqualTo(ExitStatus.Done));
        var call = CliCall.Of("picture", converted, copc, "-o", Scratch["both.png"], "--size", "320x180", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.InRange(1066, 2 * 1065));
    }
}
