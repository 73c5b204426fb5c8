namespace FastPoints.HostTests.Cli;

public sealed class DemoCloudTests : ScratchPerTest
{
    JsonElement Scan(string name)
    {
        var call = CliCall.Of("info", Scratch[name], "--scan", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(0), call.Error);
        return call.Json;
    }

    void Make(string name, params string[] args)
    {
        var call = CliCall.Of(new[] { "demo-cloud", "-o", Scratch[name] }.Concat(args).ToArray());
        Assert.That(call.Status, Is.EqualTo(0), call.Error);
    }

    [TestCase(1)]
    [TestCase(2)]
    [TestCase(1001)]
    [TestCase(70_000)]
    public void DemoCloud_OfAnySize_HasExactlyThePoints(int points)
    {
        Make("a.las", "--points", points.ToString());
        Assert.That(Scan("a.las").GetProperty("points").GetInt32(), Is.EqualTo(points));
    }

    [Test]
    public void DemoCloud_SameSeed_HasTheSameBytesWithAnyThreads()
    {
        Make("one.las", "--points", "20000", "--threads", "1");
        Make("three.las", "--points", "20000", "--threads", "3");
        Make("other.las", "--points", "20000", "--seed", "2");
        var one = File.ReadAllBytes(Scratch["one.las"]);
        Assert.That(File.ReadAllBytes(Scratch["three.las"]), Is.EqualTo(one));
        Assert.That(File.ReadAllBytes(Scratch["other.las"]), Is.Not.EqualTo(one));
    }

    [Test]
    public void DemoCloud_AsLaz_HoldsTheSamePoints()
    {
        Make("a.las", "--points", "60001");
        Make("a.laz", "--points", "60001");
        JsonElement las = Scan("a.las"), laz = Scan("a.laz");
        Assert.That(laz.GetProperty("format").GetString(), Is.EqualTo("LAZ"));
        foreach (string key in new[] { "points", "columnSums", "bounds", "boundsClaimed", "attributes", "crs" })
            Assert.That(laz.GetProperty(key).GetRawText(), Is.EqualTo(las.GetProperty(key).GetRawText()), key);
        Assert.That(laz.GetProperty("warnings").GetArrayLength(), Is.Zero);
        Assert.That(new FileInfo(Scratch["a.laz"]).Length, Is.LessThan(new FileInfo(Scratch["a.las"]).Length / 2));
        Assert.That(Directory.GetFiles(Path.GetDirectoryName(Scratch["a.laz"])!).Length,
            Is.EqualTo(2), "nothing is left beside");
    }

    [Test]
    public void DemoCloud_IsAStreet()
    {
        Make("a.las", "--points", "50000");
        var json = Scan("a.las");
        var min = json.GetProperty("bounds").GetProperty("min").EnumerateArray().Select(v => v.GetDouble()).ToArray();
        var max = json.GetProperty("bounds").GetProperty("max").EnumerateArray().Select(v => v.GetDouble()).ToArray();
        Assert.That(min[0], Is.InRange(440_700, 441_000));
        Assert.That(max[0], Is.InRange(441_000, 441_300));
        Assert.That(min[1], Is.InRange(5_611_700, 5_612_000));
        Assert.That(max[2], Is.InRange(125, 150), "roofs and trees");
        var ranges = json.GetProperty("attributes").EnumerateArray()
            .ToDictionary(a => a.GetProperty("name").GetString(),
                a => (a.GetProperty("min").GetDouble(), a.GetProperty("max").GetDouble()));
        Assert.That(ranges["Classification"], Is.EqualTo((1.0, 65.0)));
        Assert.That(ranges["NumberOfReturns"].Item2, Is.EqualTo(4));
        Assert.That(ranges["PointSourceId"], Is.EqualTo((1.0, 3.0)));
        Assert.That(ranges["Green"].Item2, Is.GreaterThan(40_000));
        Assert.That(ranges["Intensity"].Item2, Is.GreaterThan(20_000));
        Assert.That(ranges["GpsTime"].Item2, Is.GreaterThan(ranges["GpsTime"].Item1));
    }

    [Test]
    public void Order_AnyScan_KeepsTheSamePoints()
    {
        Make("strip.las", "--points", "30000");
        string sums = Scan("strip.las").GetProperty("columnSums").GetRawText();
        foreach (string order in new[] { "tile", "class", "random" })
        {
            Make(order + ".las", "--points", "30000", "--order", order);
            Assert.That(Scan(order + ".las").GetProperty("columnSums").GetRawText(), Is.EqualTo(sums), order);
            Assert.That(File.ReadAllBytes(Scratch[order + ".las"]),
                Is.Not.EqualTo(File.ReadAllBytes(Scratch["strip.las"])), order);
        }
    }

    [Test]
    public void Ply_HoldsTheSamePositions()
    {
        Make("a.las", "--points", "5000");
        Make("a.ply", "--points", "5000");
        var las = Scan("a.las").GetProperty("bounds");
        var ply = Scan("a.ply");
        Assert.That(ply.GetProperty("points").GetInt32(), Is.EqualTo(5000));
        for (int axis = 0; axis < 3; axis++)
            Assert.That(ply.GetProperty("bounds").GetProperty("min")[axis].GetDouble(),
                Is.EqualTo(las.GetProperty("min")[axis].GetDouble()).Within(1e-9));
    }

    [Test]
    public void Tile_AnyFile_RepeatsThePointsSideBySide()
    {
        Make("a.las", "--points", "4000");
        Make("b.las", "--tile", Scratch["a.las"], "--times", "3");
        var one = Scan("a.las");
        var three = Scan("b.las");
        Assert.That(three.GetProperty("points").GetInt32(), Is.EqualTo(12_000));
        Assert.That(three.GetProperty("pointsClaimed").GetInt32(), Is.EqualTo(12_000));
        Assert.That(three.GetProperty("warnings").GetArrayLength(), Is.Zero);
        double min = one.GetProperty("bounds").GetProperty("min")[0].GetDouble();
        double max = one.GetProperty("bounds").GetProperty("max")[0].GetDouble();
        double grown = three.GetProperty("bounds").GetProperty("max")[0].GetDouble();
        Assert.That(grown, Is.EqualTo(max + 2 * (max - min + 0.001)).Within(1e-6));
        Assert.That(three.GetProperty("boundsClaimed").GetProperty("max")[0].GetDouble(), Is.EqualTo(grown).Within(1e-6));
        foreach (string unmoved in new[] { "Y", "Z", "Red" })
            Assert.That(ulong.Parse(three.GetProperty("columnSums").GetProperty(unmoved).GetString()),
                Is.EqualTo(unchecked(3 * ulong.Parse(one.GetProperty("columnSums").GetProperty(unmoved).GetString()))),
                unmoved);
    }

    // Moved chunks and unpacked, tiled records are the same points.
    [Test]
    public void Tile_OfLaz_MatchesThatOfItsRecords()
    {
        Make("a.laz", "--points", "60000");
        Make("b.laz", "--tile", Scratch["a.laz"], "--times", "3");
        Make("b.las", "--tile", Scratch["a.laz"], "--times", "3");
        var laz = Scan("b.laz");
        Assert.That(laz.GetProperty("points").GetInt32(), Is.EqualTo(180_000));
        Assert.That(laz.GetProperty("warnings").GetArrayLength(), Is.Zero);
        foreach (string key in new[] { "pointsClaimed", "points", "columnSums", "bounds" })
            Assert.That(laz.GetProperty(key).GetRawText(), Is.EqualTo(Scan("b.las").GetProperty(key).GetRawText()), key);
    }
}
