using FastPoints.Cli.Convert;

namespace FastPoints.HostTests.Cli;

public sealed class SummaryTests : ScratchTests
{
    string m_demo;

    [OneTimeSetUp]
    public void MakeDemo() => m_demo = Scratch.Demo();

    [TestCase("\"schema\": 1", "\"schema\": 2"), TestCase("\"points\": 3000", "\"points\": -3")]
    [TestCase("\"verb\": \"info\"", "\"verb\": \"inform\""), TestCase("\"crsEpsg\": 32632", "\"crsEpsgs\": 32632")]
    [TestCase("\"warnings\": []", "\"warnings\": {}"), TestCase("\"stages\": []", "\"stages\": [{ \"nam\": 1 }]")]
    public void Schema_SummaryWithAPlantedMistake_RefusesIt(string right, string wrong)
    {
        string summary = CliCall.Of("info", m_demo, "--json", "-").Output;
        Assert.That(summary, Does.Contain(right));
        Assert.That(SummarySchema.Problems(summary.Replace(right, wrong)), Is.Not.Empty);
    }

    static void HasKey(JsonElement of, string name, params JsonValueKind[] kinds)
    {
        Assert.That(of.TryGetProperty(name, out var value), Is.True, name);
        Assert.That(kinds, Does.Contain(value.ValueKind), name);
    }

    static JsonElement Summary(string verb, params string[] args)
    {
        var call = CliCall.Of(args.Append("--json").Append("-").ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        var json = call.Json;
        Assert.That(json.GetProperty("verb").GetString(), Is.EqualTo(verb));
        Assert.That(json.GetProperty("schema").GetInt32(), Is.EqualTo(1));
        HasKey(json, "inputs", JsonValueKind.Array);
        HasKey(json, "seconds", JsonValueKind.Number);
        HasKey(json, "peakResidentBytes", JsonValueKind.Number);
        foreach (string count in new[] { "pointsClaimed", "pointsFound", "pointsLost" })
            HasKey(json, count, JsonValueKind.Number, JsonValueKind.Null);
        HasKey(json, "warnings", JsonValueKind.Array);
        HasKey(json, "stages", JsonValueKind.Array);
        foreach (var stage in json.GetProperty("stages").EnumerateArray())
        {
            HasKey(stage, "name", JsonValueKind.String);
            HasKey(stage, "seconds", JsonValueKind.Number);
            HasKey(stage, "points", JsonValueKind.Number, JsonValueKind.String);
            HasKey(stage, "bytes", JsonValueKind.Number, JsonValueKind.String);
        }
        Assert.That(json.TryGetProperty("failure", out _), Is.False);
        Assert.That(json.EnumerateObject().Select(p => p.Name), Is.Unique);
        return json;
    }

    static void HasInfoKeys(JsonElement json, bool scanned)
    {
        Assert.That(json.GetProperty("format").GetString(), Is.EqualTo("LAS"));
        Assert.That(json.GetProperty("version").GetString(), Is.EqualTo("1.4"));
        Assert.That(json.GetProperty("pointFormat").GetInt32(), Is.EqualTo(7));
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        Assert.That(json.GetProperty("pointsAre").GetString(), Is.EqualTo(scanned ? "counted" : "claimed"));
        HasKey(json, "bounds", scanned ? JsonValueKind.Object : JsonValueKind.Null);
        Assert.That(json.GetProperty("boundsClaimed").GetProperty("min").GetArrayLength(), Is.EqualTo(3));
        Assert.That(json.GetProperty("boundsClaimed").GetProperty("max").GetArrayLength(), Is.EqualTo(3));
        Assert.That(json.GetProperty("scale").GetArrayLength(), Is.EqualTo(3));
        Assert.That(json.GetProperty("offset").GetArrayLength(), Is.EqualTo(3));
        Assert.That(json.GetProperty("crs").GetString(), Does.Contain("UTM zone 32N"));
        HasKey(json, "columnSums", scanned ? JsonValueKind.Object : JsonValueKind.Null);
        foreach (var attribute in json.GetProperty("attributes").EnumerateArray())
        {
            HasKey(attribute, "name", JsonValueKind.String);
            HasKey(attribute, "type", JsonValueKind.String);
            HasKey(attribute, "min", scanned ? JsonValueKind.Number : JsonValueKind.Null);
            HasKey(attribute, "max", scanned ? JsonValueKind.Number : JsonValueKind.Null);
        }
    }

    [Test]
    public void Info_FromTheHeader_HasItsKeys() => HasInfoKeys(Summary("info", "info", m_demo), false);

    [Test]
    public void Info_WithScan_MatchesTheHeader()
    {
        var json = Summary("info", "info", m_demo, "--scan");
        HasInfoKeys(json, true);
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        Assert.That(json.GetProperty("bounds").GetRawText(), Is.EqualTo(json.GetProperty("boundsClaimed").GetRawText()));
        foreach (var sum in json.GetProperty("columnSums").EnumerateObject())
            Assert.That(ulong.TryParse(sum.Value.GetString(), out _), Is.True, sum.Name);
    }

    [Test]
    public void Info_AnyNumberOfThreads_IsTheSame()
    {
        string one = Summary("info", "info", m_demo, "--scan", "--threads", "1").GetProperty("columnSums").GetRawText();
        string three = Summary("info", "info", m_demo, "--scan", "--threads", "3").GetProperty("columnSums").GetRawText();
        Assert.That(three, Is.EqualTo(one));
    }

    [Test]
    public void Info_OfSeveralFiles_ListsThem()
    {
        var json = Summary("info", "info", m_demo, m_demo);
        Assert.That(json.GetProperty("files").GetArrayLength(), Is.EqualTo(2));
        Assert.That(json.GetProperty("pointsClaimed").GetInt64(), Is.EqualTo(6000), "of all files");
        Assert.That(json.GetProperty("pointsLost").GetInt64(), Is.Zero);
        HasInfoKeys(json.GetProperty("files")[1], false);
    }

    [Test]
    public void Preview_HasItsKeysAndAPicture()
    {
        string png = Scratch["preview.png"];
        var json = Summary("preview", "preview", m_demo, "-o", png, "--size", "160x90");
        HasPreviewKeys(json);
        Assert.That(File.ReadAllBytes(png).Take(4), Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47 }));
    }

    [Test]
    public void PreviewReport_OfAFile_PlotsErrorsOverTime()
    {
        string folder = Scratch["errors"];
        var json = Summary("preview", "preview", m_demo, "-o", Scratch["p.png"], "--size", "160x90",
            "--report", "--out", folder);
        HasPreviewKeys(json);
        var error = json.GetProperty("error");
        foreach (string key in new[]
            { "psnr", "ssim", "flip", "uncovered", "flipFull", "rms", "hausdorff95", "hausdorff99", "uncoveredCells64",
                "uncoveredCells128", "uncoveredCells256", "shareVariation", "bias", "biasByChance" })
            HasKey(error, key, JsonValueKind.Number, JsonValueKind.Null);
        Assert.That(error.GetProperty("rms").GetDouble(), Is.Zero, "the sample is the whole");
        Assert.That(error.GetProperty("uncoveredCells256").GetDouble(), Is.Zero);
        Assert.That(error.GetProperty("found").GetInt32(), Is.EqualTo(3000));
        Assert.That(error.GetProperty("flipFull").GetDouble(),
            Is.EqualTo(error.GetProperty("floor").GetProperty("flip").GetDouble()).And.GreaterThan(0), "the sample is the whole");
        foreach (var curve in error.GetProperty("curves").EnumerateArray())
        {
            Assert.That(curve.GetProperty("waves").GetArrayLength(), Is.GreaterThan(0), curve.GetProperty("name").GetString());
            foreach (var wave in curve.GetProperty("waves").EnumerateArray())
                Assert.That(wave.GetProperty("found").GetInt32(), Is.EqualTo(wave.GetProperty("lookedUp").GetInt32()));
        }
        Assert.That(json.GetProperty("report").GetString(), Is.EqualTo(Path.Combine(folder, "report.html")));
        Assert.That(File.ReadAllText(Path.Combine(folder, "report.html")), Does.Contain("<svg").And.Contain("data:image/png"));
        string[] table = File.ReadAllLines(Path.Combine(folder, "errors.csv"));
        Assert.That(table.Select(l => l.Split(',').Length), Is.All.EqualTo(table[0].Split(',').Length));
        Assert.That(table[^1], Does.StartWith("all points one sample a pixel,3000,"));
        Assert.That(File.Exists(Path.Combine(folder, "rms.svg")), Is.True);
    }

    [Test]
    public void SamplerReport_SmallCloud_HasFlipAndItsFloor()
    {
        string folder = Scratch["samplers"];
        using (var reader = PointReaders.Open(m_demo))
            new SamplerReport(reader, folder, new ConvertSettings(),
                new CliRun(TextWriter.Null, TextWriter.Null, new RunSettings { IsQuiet = true }, default))
            {
                WidthPx = 64,
                HeightPx = 36,
            }.Write();
        var rows = File.ReadAllLines(Path.Combine(folder, "pictures.csv"))
            .Select(line => line.Split('"')[^1].Trim(',').Split(',')).ToList();
        int flip = Array.IndexOf(rows[0], "flip") - rows[0].Length;
        double[] flips = rows.Skip(1).Select(r => double.Parse(r[^-flip], CultureInfo.InvariantCulture)).ToArray();
        // Two views: a floor, then six settings under five budgets that all points fit in.
        Assert.That(flips, Has.Length.EqualTo(2 + 6 * 2 * 5).And.All.InRange(0.0001, 0.6));
        Assert.That(flips[2], Is.EqualTo(flips[0]), "all points, by the sampler that the reference is drawn from");
        Assert.That(File.ReadAllText(Path.Combine(folder, "report.html")),
            Does.Contain("FLIP").And.Contain("one sample a pixel"));
    }

    [Test]
    public void Picture_SeveralSamples_IsTheMeanOfALargerPicture()
    {
        string smooth = Scratch["smooth.png"], large = Scratch["large.png"];
        string[] view = ["picture", m_demo, "--view", "top", "--plain"];
        HasPictureKeys(Summary("picture", [.. view, "-o", smooth, "--size", "80x45", "--samples", "4", "--style", "size=1"]));
        HasPictureKeys(Summary("picture", [.. view, "-o", large, "--size", "320x180", "--style", "size=4"]));
        var (mean, of) = (Png.Read(smooth), Png.Read(large));
        Assert.That(mean.Width, Is.EqualTo(80));
        for (int y = 0; y < 45; y++)
            for (int x = 0; x < 80; x++)
            {
                double light = 0;
                for (int i = 0; i < 16; i++)
                    light += Math.Pow((of[4 * x + i % 4, 4 * y + i / 4] >> 8 & 255) / 255.0, 2.2) / 16;
                Assert.That(mean[x, y] >> 8 & 255, Is.EqualTo(255 * Math.Pow(light, 1 / 2.2)).Within(8), $"{x}, {y}");
            }
    }

    static void HasPreviewKeys(JsonElement json)
    {
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        HasKey(json, "bytesRead", JsonValueKind.Number);
        foreach (var wave in json.GetProperty("waves").EnumerateArray())
        {
            HasKey(wave, "points", JsonValueKind.Number);
            HasKey(wave, "seconds", JsonValueKind.Number);
        }
    }

    static void HasPictureKeys(JsonElement json, JsonValueKind nodes = JsonValueKind.Null)
    {
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        HasKey(json, "nodes", nodes);
        HasKey(json, "seconds", JsonValueKind.Number);
        HasKey(json, "device", JsonValueKind.String);
    }

    [Test]
    public void Picture_AgainstItself_HasNoError()
    {
        string first = Scratch["first.png"], second = Scratch["second.png"];
        HasPictureKeys(Summary("picture", "picture", m_demo, "-o", first, "--size", "160x90", "--view", "iso"));
        var json = Summary("picture", "picture", m_demo, "-o", second, "--size", "160x90", "--view", "iso", "--against", first);
        HasPictureKeys(json);
        Assert.That(json.GetProperty("psnr").ValueKind, Is.EqualTo(JsonValueKind.Null), "infinite");
        Assert.That(json.GetProperty("ssim").GetDouble(), Is.EqualTo(1).Within(1e-9));
        Assert.That(json.GetProperty("flip").GetDouble(), Is.Zero);
        Assert.That(json.GetProperty("uncovered").GetDouble(), Is.Zero);
    }

    [Test]
    public void Picture_WithAFlipMap_WritesWhereItDiffers()
    {
        string near = Scratch["near.png"], far = Scratch["far.png"], map = Scratch["map.png"];
        HasPictureKeys(Summary("picture", "picture", m_demo, "-o", near, "--size", "160x90", "--view", "iso"));
        var json = Summary("picture", "picture", m_demo, "-o", far, "--size", "160x90", "--view", "top", "--against", near,
            "--flip-map", map);
        var flip = FlipMap.Of(Png.Read(far), Png.Read(near));
        Assert.That(json.GetProperty("flip").GetDouble(), Is.EqualTo(flip.Mean).Within(1e-9).And.GreaterThan(0.01));
        Assert.That(Png.Read(map).Rgba, Is.EqualTo(flip.ToImage().Rgba));
    }

    [Test]
    public void ConvertVerifyPicture_OfACloud_HaveTheirKeys()
    {
        string cloud = Scratch["keys.fastpoints"];
        HasConvertKeys(Summary("convert", "convert", m_demo, "-o", cloud));
        var json = Summary("verify", "verify", cloud, "--against", m_demo);
        Assert.That(json.GetProperty("ok").GetBoolean(), Is.True);
        Assert.That(json.GetProperty("problems").GetArrayLength(), Is.Zero);
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        foreach (var level in json.GetProperty("levels").EnumerateArray())
        {
            foreach (string number in new[] { "level", "nodes", "points" })
                HasKey(level, number, JsonValueKind.Number);
            // Leaves keep all their points: a level of leaves alone has no distance to keep.
            HasKey(level, "minDistance", JsonValueKind.Number, JsonValueKind.Null);
        }
        HasPictureKeys(Summary("picture", "picture", cloud, "-o", Scratch["cloud.png"], "--size", "160x90"),
            JsonValueKind.Number);
    }

    [Test]
    public void ConvertNormals_WithABuildOrLater_HaveTheirKeys()
    {
        string cloud = Scratch["normals.fastpoints"];
        var json = Summary("convert", "convert", m_demo, "-o", cloud, "--normals");
        HasConvertKeys(json);
        Assert.That(json.GetProperty("normals").GetProperty("points").GetInt64(), Is.EqualTo(3000));
        json = Summary("convert", "convert", cloud, "--normals");
        Assert.That(json.GetProperty("normals").GetProperty("orientation").GetString(), Is.EqualTo("up").Or.EqualTo("viewer"));
        Assert.That(Summary("verify", "verify", cloud, "--against", m_demo).GetProperty("ok").GetBoolean(), Is.True);
    }

    [TestCase("--normals")]
    [TestCase("--report")]
    public void Convert_OfAFileWithoutOutput_SaysSo(string option)
    {
        var call = CliCall.Of("convert", m_demo, option);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain("--output: wanted NAME.fastpoints"));
    }

    [Test]
    public void Verify_OfADamagedCloud_IsBadInput()
    {
        string cloud = Scratch["damaged.fastpoints"];
        Assert.That(CliCall.Of("convert", m_demo, "-o", cloud).Status, Is.EqualTo(ExitStatus.Done));
        string upper = Directory.GetFiles(Path.Combine(cloud, "upper")).Single();
        byte[] bytes = File.ReadAllBytes(upper);
        bytes[bytes.Length / 2] ^= 4;
        File.WriteAllBytes(upper, bytes);
        var call = CliCall.Of("verify", cloud);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Output, Does.Contain("its hash does not fit"));
    }

    static void HasConvertKeys(JsonElement json)
    {
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(3000));
        foreach (string number in new[] { "pointsLeftOut", "nodes", "levelCount", "bytesOnDisk", "temporaryBytesPeak" })
            HasKey(json, number, JsonValueKind.Number);
        HasKey(json, "checksum", JsonValueKind.String);
        HasKey(json.GetProperty("bytesPerPoint"), "position", JsonValueKind.Number);
        HasKey(json.GetProperty("bytesPerPoint"), "color", JsonValueKind.Number);
    }

    [Test]
    public void DemoCloud_HasItsKeys()
    {
        string file = Scratch["keys.las"];
        var json = Summary("demo-cloud", "demo-cloud", "-o", file, "--points", "1000");
        Assert.That(json.GetProperty("points").GetInt64(), Is.EqualTo(1000));
        Assert.That(json.GetProperty("bytes").GetInt64(), Is.EqualTo(new FileInfo(file).Length));
    }

    [Test]
    public void Bench_HasItsKeys()
    {
        var json = Summary("bench", "bench", "job chain", "--runs", "1", "--points", "1000", "--out", Scratch["bench"]);
        var workload = json.GetProperty("workloads").EnumerateArray().Single();
        HasKey(workload, "name", JsonValueKind.String);
        foreach (string number in new[] { "ms", "pointsPerSecond", "bytesPerSecond", "error", "garbageBytes" })
            HasKey(workload, number, JsonValueKind.Number);
    }

    [Test]
    public void MainJob_OfAFile_WritesItsReport()
    {
        string folder = Scratch["report"];
        var json = Summary("", m_demo, "--out", folder);
        HasInfoKeys(json.GetProperty("info"), false);
        HasPreviewKeys(json.GetProperty("preview"));
        HasConvertKeys(json.GetProperty("convert"));
        HasPictureKeys(json.GetProperty("picture"), JsonValueKind.Number);
        Assert.That(Directory.Exists(Path.Combine(folder, Path.GetFileNameWithoutExtension(m_demo) + ".fastpoints")), Is.True);
        Assert.That(json.GetProperty("report").GetString(), Is.EqualTo(Path.Combine(folder, "report.html")));
        string[] always = ["report.html", "preview.png", "picture.png", "report.json"];
        Assert.That(Directory.GetFiles(folder).Select(Path.GetFileName),
            Is.EquivalentTo(HeadlessGraphics.IsAvailable ? always.Append("gpu.png") : always));
        Assert.That(json.TryGetProperty("gpu", out var gpu), Is.EqualTo(HeadlessGraphics.IsAvailable));
        if (HeadlessGraphics.IsAvailable)
            HasPictureKeys(gpu, JsonValueKind.Number);
        Assert.That(File.ReadAllText(Path.Combine(folder, "report.html")), Does.Contain("data:image/png;base64,"));
    }

    [TestCase(false), TestCase(true)]
    public void MainJob_WithoutAFile_CreatesADemoCloudAndKeepsItIfAsked(bool keeps)
    {
        string folder = Scratch["own" + keeps];
        string[] options = ["--out", folder, "--points", "3000"];
        var json = Summary("", keeps ? [.. options, "--keep"] : options);
        HasInfoKeys(json.GetProperty("info"), false);
        Assert.That(File.Exists(Path.Combine(folder, "demo.las")), Is.EqualTo(keeps));
        Assert.That(Directory.Exists(Path.Combine(folder, "demo.fastpoints")), Is.EqualTo(keeps));
        Assert.That(File.Exists(Path.Combine(folder, "report.html")), Is.True);
    }

    [Test]
    public void JsonFile_Requested_IsWrittenBesideTheText()
    {
        string file = Scratch["summary.json"];
        var call = CliCall.Of("info", m_demo, "--json", file);
        Assert.That(call.Output, Does.Contain("LAS 1.4, point format 7"));
        Assert.That(JsonDocument.Parse(File.ReadAllBytes(file)).RootElement.GetProperty("verb").GetString(), Is.EqualTo("info"));
    }
}
