namespace FastPoints.HostTests.Cli;

public sealed class ExportTests : ScratchTests
{
    string m_demo, m_cloud;

    [OneTimeSetUp]
    public void MakeCloud()
    {
        m_demo = Scratch.Demo(points: 60_000);
        m_cloud = Scratch["cloud.fastpoints"];
        Assert.That(CliCall.Of("convert", m_demo, "-o", m_cloud).Status, Is.Zero);
    }

    JsonElement Export(string output, params string[] args)
    {
        var call = CliCall.Of(["export", .. args, "-o", Scratch[output], "--json", "-", "--quiet"]);
        Assert.That(call.Status, Is.Zero, call.Error);
        return call.Json;
    }

    static JsonElement Scan(string path) => CliCall.Of("info", "--scan", path, "--json", "-").Json;

    [TestCase("whole.las"), TestCase("whole.laz"), TestCase("whole.copc.laz")]
    public void Export_OfASource_SumsAndGridAreTheSame(string output)
    {
        var json = Export(output, m_demo);
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(60_000));
        Assert.That(json.GetProperty("pointsLost").GetInt64(), Is.Zero);
        Assert.That(json.GetProperty("bytes").GetInt64(), Is.EqualTo(new FileInfo(Scratch[output]).Length));
        Assert.That(json.GetProperty("positionError").GetDouble(), Is.Zero);
        var made = Scan(Scratch[output]);
        var source = Scan(m_demo);
        foreach (string key in new[] { "columnSums", "scale", "offset", "crs", "crsWkt", "bounds", "pointFormat" })
            Assert.That(made.GetProperty(key).GetRawText(), Is.EqualTo(source.GetProperty(key).GetRawText()), key);
    }

    [TestCase("cloud.las"), TestCase("cloud.laz"), TestCase("cloud.copc.laz")]
    public void Export_OfAConvertedCloud_IsTheCloud(string output)
    {
        Assert.That(Export(output, m_cloud).GetProperty("points").GetInt64(), Is.EqualTo(60_000));
        Assert.That(CliCall.Of("verify", m_cloud, "--against", Scratch[output]).Error, Is.Empty);
        Assert.That(Scan(Scratch[output]).GetProperty("crsEpsg").GetInt32(), Is.EqualTo(32632));
    }

    [Test]
    public void Export_LevelsBudgetAndBoxes_ArePartsOfTheCloud()
    {
        long root = Export("level.laz", m_cloud, "--level", "0").GetProperty("points").GetInt64();
        Assert.That(root, Is.GreaterThan(0).And.LessThan(60_000));
        Assert.That(Export("budget.ply", m_cloud, "--budget", "10k").GetProperty("points").GetInt64(),
            Is.InRange(9_990, 10_000));
        var bounds = Scan(m_demo).GetProperty("bounds");
        double[] Corner(string end) => [.. bounds.GetProperty(end).EnumerateArray().Select(v => v.GetDouble())];
        string[] all = [.. Corner("min").Concat(Corner("max")).Select(v => v.ToString("R", CultureInfo.InvariantCulture))];
        string box = string.Join(',', all);
        Assert.That(Export("all.laz", m_cloud, "--clip", box).GetProperty("points").GetInt64(), Is.EqualTo(60_000));
        Assert.That(Export("none.laz", m_cloud, "--cut", box).GetProperty("points").GetInt64(), Is.Zero);
        all[3] = ((Corner("min")[0] + Corner("max")[0]) / 2).ToString("R", CultureInfo.InvariantCulture);
        string half = string.Join(',', all);
        long inside = Export("inside.laz", m_cloud, "--clip", half).GetProperty("points").GetInt64();
        Assert.That(inside, Is.GreaterThan(0).And.LessThan(60_000));
        Assert.That(Export("outside.laz", m_demo, "--cut", half).GetProperty("points").GetInt64(), Is.EqualTo(60_000 - inside));
    }

    // Numbers of the second tile have 64 bits along one axis, for its offset is another.
    [TestCase("tiles.las"), TestCase("tiles.laz")]
    public void Export_OfTilesWithTheirOwnOffsetAlongOneAxis_HasAllPoints(string output)
    {
        const int xOffsetAt = 155;
        string tiles = Scratch["offsets"];
        Directory.CreateDirectory(tiles);
        byte[] tile = File.ReadAllBytes(m_demo);
        File.WriteAllBytes(Path.Combine(tiles, "a.las"), tile);
        BitConverter.TryWriteBytes(tile.AsSpan(xOffsetAt), BitConverter.ToDouble(tile, xOffsetAt) + 1234.57);
        File.WriteAllBytes(Path.Combine(tiles, "b.las"), tile);
        var types = Scan(tiles).GetProperty("attributes").EnumerateArray().Select(a => a.GetProperty("type").GetString());
        Assert.That(types.Take(3), Is.EqualTo(new[] { "Int64", "Int32", "Int32" }));
        var json = Export(output, tiles);
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(120_000));
        string Bounds(string path) => Scan(path).GetProperty("bounds").GetRawText();
        Assert.That(Bounds(Scratch[output]), Is.EqualTo(Bounds(tiles)));
    }

    [Test]
    public void Export_CopcOfTextInLittleMemory_SummarisesTheResult()
    {
        File.WriteAllLines(Scratch["grid.xyz"], Enumerable.Range(0, 5000).Select(i => $"{i % 10} {i / 10 % 10} {i / 100}.5"));
        Export("grid.copc.laz", Scratch["grid.xyz"], "--memory", "200MiB");
        var info = Scan(Scratch["grid.copc.laz"]);
        Assert.That((info.GetProperty("format").GetString(), info.GetProperty("points").GetInt64()), Is.EqualTo(("COPC", 5000L)));
        Assert.That(CliCall.Of("export", m_cloud, "-o", Scratch["x.copc.laz"], "--memory", "3").Status,
            Is.EqualTo(ExitStatus.Usage));
    }

    [Test]
    public void Export_NoPoints_WarnsWithTheCloudsBounds()
    {
        string[] args = ["export", m_cloud, "-o", Scratch["nothing.las"], "--clip", "0,0,0,50,50,20"];
        var call = CliCall.Of(args);
        Assert.That(call.Status, Is.Zero);
        Assert.That(call.Error, Does.Contain("no point is left of 60,000, which lie in (").And.Contains(
            "wanted (0, 0, 0) to (50, 50, 20)"));
        Assert.That(CliCall.Of([.. args, "--strict", "--force"]).Status, Is.EqualTo(4));
    }

    [Test]
    public void Export_BoxFromTheMinCorner_IsTheSameForCloudAndFile()
    {
        long of(string source, string output) =>
            Export(output, source, "--clip-local", "0,0,0,50,50,20").GetProperty("points").GetInt64();
        Assert.That(of(m_demo, "local-file.laz"), Is.GreaterThan(0).And.EqualTo(of(m_cloud, "local.laz")));
        string text = Scratch["rows.xyz"];
        File.WriteAllLines(text, ["1 2 3", "4 5 6"]);
        Assert.That(CliCall.Of("export", text, "-o", Scratch["rows.las"], "--clip-local", "0,0,0,1,1,1").Error,
            Does.Contain("does not say where it begins"));
    }

    [Test]
    public void Export_Filtered_IsTheSameForCloudAndFile()
    {
        long of(string source, params string[] filter) =>
            Export("filtered.laz", [source, "--force", .. filter]).GetProperty("points").GetInt64();
        string ring = Scratch["all.wkt"];
        File.WriteAllText(ring, "POLYGON((-1e9 -1e9, 1e9 -1e9, 1e9 1e9, -1e9 1e9))");
        Assert.That(of(m_demo, "--every-nth", "7"), Is.EqualTo((60_000 + 6) / 7));
        Assert.That(of(m_demo, "--polygon", ring), Is.EqualTo(60_000));
        foreach (string source in new[] { m_demo, m_cloud })
        {
            long ground = of(source, "--classes", "2");
            Assert.That(ground, Is.GreaterThan(0).And.LessThan(60_000));
            Assert.That(of(source, "--where", "Classification != 2"), Is.EqualTo(60_000 - ground));
            Assert.That(of(source, "--returns", "last"), Is.EqualTo(of(source, "--where", "ReturnNumber == NumberOfReturns")));
            Assert.That(of(source, "--returns", "first"), Is.EqualTo(of(source, "--returns", "1")).And.GreaterThan(0));
        }
        string[] args = ["export", m_demo, "-o", Scratch["empty.laz"], "--where", "Classification == 255", "--strict"];
        Assert.That(CliCall.Of(args).Status, Is.EqualTo(4));
    }

    [TestCase("--every-nth", "7"), TestCase("--classes", "2")]
    [TestCase("--where", "Intensity > 100 && Z > 0", "--returns", "last")]
    public void Convert_Filtered_HasThePointsThatExportLeaves(params string[] filter)
    {
        string cloud = Scratch["part.fastpoints"], tiles = Scratch["two"];
        Directory.CreateDirectory(tiles);
        foreach (string tile in new[] { "a.las", "b.las" })
            File.Copy(m_demo, Path.Combine(tiles, tile), true);
        foreach (string source in new[] { m_demo, tiles })
        {
            string[] build = ["convert", source, "-o", cloud, "--attributes", "Intensity", "--force", .. filter];
            Assert.That(CliCall.Of(build).Status, Is.Zero);
            var wanted = Export("wanted.las", [source, "--force", "--attributes", "Intensity", .. filter]);
            Assert.That(wanted.GetProperty("points").GetInt64(), Is.GreaterThan(0).And.LessThan(120_000));
            Assert.That(CliCall.Of("verify", cloud, "--against", Scratch["wanted.las"]).Status, Is.Zero);
        }
    }

    [TestCase("las"), TestCase("laz"), TestCase("copc.laz")]
    public void Crs_Overridden_IsWrittenInPlaceOfTheFilesOwn(string extension)
    {
        string own = CliCall.Of("info", m_demo, "--json", "-", "--quiet").Json.GetProperty("crsWkt").GetString();
        Assert.That(own, Is.Not.Null);
        string target = Scratch["told." + extension];
        string[] losses = Losses(Export("told." + extension, m_demo, "--crs", "EPSG:2229", "--force"));
        var info = CliCall.Of("info", target, "--json", "-", "--quiet").Json;
        Assert.That((info.GetProperty("crsEpsg").GetInt32(), info.GetProperty("crsWkt").GetString()),
            Is.EqualTo((2229, (string)null)));
        Assert.That(info.GetProperty("crsMetresPerUnit").GetDouble(), Is.EqualTo(1200.0 / 3937).Within(1e-9));
        Assert.That(losses, Has.Some.Contains("as WKT"));
        if (extension == "las")
            Assert.That(Losses(Export("unit.las", m_demo, "--unit", "ft", "--force")), Has.Some.StartsWith("the unit, "));

        static string[] Losses(JsonElement json) =>
            [.. json.GetProperty("losses").EnumerateArray().Select(l => l.GetProperty("what").GetString())];
    }

    [Test]
    public void Losses_OfAnExport_AreNamedOnceInTextAndJson()
    {
        string ply = Scratch["faces.ply"];
        File.WriteAllText(ply, "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 1\nproperty float x\nproperty float y\n"
            + "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n");
        foreach (string[] line in new[] { new[] { "convert", ply, "-o", Scratch["faces.fastpoints"] },
            ["export", Scratch["faces.fastpoints"], "-o", Scratch["faces.las"]] })
        {
            string json = Scratch["losses.json"];
            var call = CliCall.Of([.. line, "--json", json]);
            string what = line[0] == "convert" ? "element face" : "comments";
            Assert.That((call.Status, call.Error.Split(what + ": lost").Length), Is.EqualTo((0, 2)), call.Error);
            var losses = JsonDocument.Parse(File.ReadAllText(json)).RootElement.GetProperty("losses");
            Assert.That(losses.EnumerateArray().Select(l => l.GetProperty("what").GetString()), Is.EqualTo(new[] { what }));
        }
    }

    [Test]
    public void Commands_OfTheReadme_RunAsDescribed()
    {
        string readme = Path.Combine(Checkout.Repository.Root, "README.md");
        string[] lines = [.. File.ReadLines(readme).Select(l => l.Split('#')[0].Trim())
            .Where(l => l.StartsWith("./fastpoints ") && !l.Contains("--help"))];
        Assert.That(lines, Has.Length.GreaterThan(2));
        Directory.CreateDirectory(Scratch["tiles"]);
        foreach (string copy in new[] { "scan.las", "tiles/east.las", "tiles/west.las" })
            File.Copy(m_demo, Scratch[copy]);
        foreach (string line in lines.Where(l => l != "./fastpoints scan.las" && !l.Contains(" fly ")))
        {
            var call = CliCall.Of([.. line.Split(' ').Skip(1).Select(word =>
                word.IndexOfAny(['.', '/']) >= 0 && !word.Contains(',') ? Scratch[word] : word), "--force"]);
            Assert.That((call.Status, call.Error.Contains("warning")), Is.EqualTo((0, false)), line + ": " + call.Error);
        }
        Assert.That(Scan(Scratch["part.laz"]).GetProperty("points").GetInt64(), Is.GreaterThan(0));
    }

    [Test]
    public void Export_SameSourceWithOneThreadOrMore_SameBytes()
    {
        Export("one.laz", m_cloud, "--threads", "1");
        Export("two.laz", m_cloud, "--threads", "2");
        Assert.That(File.ReadAllBytes(Scratch["one.laz"]), Is.EqualTo(File.ReadAllBytes(Scratch["two.laz"])));
    }

    [TestCase("out.e57", "wanted a name that ends in .las, .laz, .copc.laz or .ply")]
    [TestCase("out.las", "--classes: wanted numbers", "--classes", "256")]
    [TestCase("out.las", "--where: wanted an attribute or a number at character 9", "--where", "X > 1 &&")]
    [TestCase("out.las", "has no Colour; it has X, Y, Z", "--where", "Colour > 1")]
    [TestCase("out.las", "--returns: wanted first, last or a number", "--returns", "second")]
    [TestCase("out.las", "--clip: wanted x,y,z,X,Y,Z", "--clip", "1,2,3")]
    [TestCase("out.las", "has no Colour", "--attributes", "Colour")]
    [TestCase("out.las", "--level: wanted a whole number from 0", "--level", "-1")]
    public void Export_WrongArguments_AreUsage(string output, string message, params string[] more)
    {
        var call = CliCall.Of(["export", m_cloud, "-o", Scratch[output], .. more]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(call.Error, Does.Contain(message));
        Assert.That(File.Exists(Scratch[output]), Is.False);
    }

    [Test]
    public void Export_OverASource_IsRefused()
    {
        var bytes = File.ReadAllBytes(m_demo);
        Assert.That(CliCall.Of("export", m_demo, "-o", m_demo, "--force").Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(File.ReadAllBytes(m_demo), Is.EqualTo(bytes));
    }

    [TestCase("killed.las"), TestCase("killed.laz"), TestCase("killed.copc.laz")]
    public void Export_Killed_LeavesNothingUnderTheNameAndTheNextRunWorks(string output)
    {
        string target = Scratch[output], whole = "whole-" + output;
        bool IsWhole() => File.ReadAllBytes(target).AsSpan().SequenceEqual(File.ReadAllBytes(Scratch[whole]));
        for (int points = 600_000; ; points *= 2)
        {
            string large = Scratch.Demo($"large{points}.las", points);
            Export(whole, large, "--force");
            File.Delete(target);
            using var process = System.Diagnostics.Process.Start(new System.Diagnostics.ProcessStartInfo(
                Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"), ["export", large, "-o", target, "--quiet"]));
            while (Directory.GetFileSystemEntries(Scratch.Root, output + "*").Length == 0 && !process.HasExited)
                Thread.Yield();
            process.Kill();
            process.WaitForExit();
            if (File.Exists(target))
            {
                Assert.That(IsWhole(), Is.True, "half-written");
                Assert.That(points, Is.LessThan(20_000_000), "ended before it could be killed");
                continue;
            }
            Export(output, large);
            Assert.That(IsWhole(), Is.True);
            Assert.That(Directory.GetFileSystemEntries(Scratch.Root, output + "*"), Has.Length.EqualTo(1), "nothing is left");
            return;
        }
    }

    [Test]
    public void Export_Cancelled_LeavesNothing()
    {
        using var cancelled = new CancellationTokenSource();
        cancelled.Cancel();
        string output = Scratch["cancelled.laz"];
        Assert.That(CliCall.Of(cancelled.Token, "export", m_demo, "-o", output).Status, Is.EqualTo(ExitStatus.Cancelled));
        Assert.That(Directory.GetFiles(Scratch.Root, "cancelled*"), Is.Empty);
    }
}
