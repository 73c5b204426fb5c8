namespace FastPoints.HostTests.Cli;

public sealed class InputTests : ScratchPerTest
{
    [Test]
    public void Info_OfALink_ReadsItsTarget()
    {
        string demo = Scratch.Demo("scan.las", 100);
        File.CreateSymbolicLink(Scratch["link.las"], demo);
        Assert.That(CliCall.Of("info", Scratch["link.las"], "--scan", "--json", "-").Json.GetProperty("points").GetInt64(),
            Is.EqualTo(100));
    }

    [Test]
    public void Info_OfAFolder_IsRecursiveOnRequest()
    {
        Directory.CreateDirectory(Scratch["tiles/a/b"]);
        File.Copy(Scratch.Demo("scan.las", 100), Scratch["tiles/1.las"]);
        File.Copy(Scratch["scan.las"], Scratch["tiles/a/2.las"]);
        File.Copy(Scratch["scan.las"], Scratch["tiles/a/b/3.las"]);
        Assert.That(CliCall.Of("convert", Scratch["scan.las"], "-o", Scratch["tiles/a/made.fastpoints"]).Status, Is.Zero);

        var flat = CliCall.Of("info", Scratch["tiles"], "--json", "-");
        Assert.That(flat.Json.GetProperty("points").GetInt64(), Is.EqualTo(100));
        Assert.That(Warnings(flat), Does.Contain("folders in it are not looked into: a\""));
        var deep = CliCall.Of("info", Scratch["tiles"], "--recursive", "--json", "-");
        Assert.That(deep.Json.GetProperty("points").GetInt64(), Is.EqualTo(300));
        Assert.That(Warnings(deep), Does.Contain("not looked into: made.fastpoints"));

        string Warnings(CliCall call) => call.Json.GetProperty("warnings").ToString();
    }

    [Test]
    public void Convert_WithUnitAndSystem_KeepsThem()
    {
        File.WriteAllText(Scratch["scan.xyz"], "0 0 0\n100 200 10\n");
        var asIs = CliCall.Of("info", Scratch["scan.xyz"]);
        Assert.That(asIs.Output, Does.Contain("UNKNOWN, taken for metres: say it by --unit"));
        var told = CliCall.Of("convert", Scratch["scan.xyz"], "-o", Scratch["scan.fastpoints"], "--unit", "us-ft");
        Assert.That(told.Output, Does.Contain("unit   US survey feet"));
        var json = CliCall.Of("info", Scratch["scan.fastpoints"], "--json", "-").Json;
        Assert.That(json.GetProperty("crsMetresPerUnit").GetDouble(), Is.EqualTo(1200.0 / 3937));
        Assert.That(json.GetProperty("crsUnitKnown").GetBoolean());
        told = CliCall.Of("convert", Scratch["scan.xyz"], "-o", Scratch["scan.fastpoints"], "--crs", "EPSG:2229+5703");
        Assert.That(told.Status, Is.Zero, "the same source, told otherwise");
        json = CliCall.Of("info", Scratch["scan.fastpoints"], "--json", "-").Json;
        Assert.That(json.GetProperty("crs").GetString(), Is.EqualTo("NAD83 / California zone 5 (ftUS) (EPSG:2229+5703)"));
        Assert.That(json.GetProperty("crsVerticalMetresPerUnit").GetDouble(), Is.EqualTo(1));
        Assert.That((json.GetProperty("crsKind").GetString(), json.GetProperty("crsAxes").GetString()),
            Is.EqualTo(("projected", "ENU")));
        var lost = CliCall.Of("export", Scratch["scan.xyz"], "-o", Scratch["scan.las"], "--unit", "us-ft");
        Assert.That(lost.Error, Does.Contain("the unit, US survey feet"));
        foreach (string wrong in new[] { "--unit=cubit", "--crs=2229" })
            Assert.That(CliCall.Of("info", Scratch["scan.xyz"], wrong).Status, Is.EqualTo(ExitStatus.Usage));
    }

    [Test]
    public void Convert_OverACloudOfAnotherScan_NeedsForce()
    {
        string[] Convert(string file) => ["convert", Scratch[file], "-o", Scratch["q.fastpoints"], "--quiet"];
        Scratch.Demo("a.las", 100);
        Scratch.Demo("b.las", 200);
        Assert.That(CliCall.Of(Convert("a.las")).Status, Is.Zero);
        Assert.That(CliCall.Of(Convert("a.las")).Status, Is.Zero, "repeated");

        var refused = CliCall.Of(Convert("b.las"));

        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain("holds a cloud of a.las").And.Contains("--force"));
        Assert.That(CliCall.Of("info", Scratch["q.fastpoints"], "--json", "-").Json.GetProperty("points").GetInt64(),
            Is.EqualTo(100));
        Assert.That(CliCall.Of([.. Convert("b.las"), "--force"]).Status, Is.Zero);
    }

    [Test]
    public void Convert_OverACloudOfAScanWithEqualNameAndSize_NeedsForce()
    {
        string[] Convert(string folder) => ["convert", Scratch[folder + "/s.las"], "-o", Scratch["q.fastpoints"], "--quiet"];
        foreach (string folder in new[] { "a", "b" })
        {
            Directory.CreateDirectory(Scratch[folder]);
            Assert.That(CliCall.Of("demo-cloud", "-o", Scratch[folder + "/s.las"], "--points", "100", "--seed",
                folder == "a" ? "1" : "2").Status, Is.Zero);
        }
        Assert.That(CliCall.Of(Convert("a")).Status, Is.Zero);
        Assert.That(CliCall.Of(Convert("b")).Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(CliCall.Of(Convert("a")).Status, Is.Zero);
    }

    [Test]
    public void Convert_MemoryMeasuredLate_IsRepeated()
    {
        Directory.CreateDirectory(Scratch["tree/ept-hierarchy"]);
        Directory.CreateDirectory(Scratch["tree/ept-data"]);
        File.WriteAllText(Scratch["tree/ept-hierarchy/0-0-0-0.json"], "{\"0-0-0-0\":1}");
        File.WriteAllBytes(Scratch["tree/ept-data/0-0-0-0.bin"], new byte[12]);
        string axes = string.Join(",", "XYZ".Select(c =>
            $"{{\"name\":\"{c}\",\"type\":\"signed\",\"size\":4,\"scale\":0.01,\"offset\":0}}"));
        File.WriteAllText(Scratch["tree/ept.json"], "{\"bounds\":[0,0,0,1,1,1],\"boundsConforming\":[0,0,0,1,1,1],"
            + "\"dataType\":\"binary\",\"hierarchyType\":\"json\",\"points\":1,\"span\":128,\"version\":\"1.0.0\","
            + "\"schema\":[" + axes + "]}");
        foreach (string[] line in new[] { new[] { "convert", Scratch["tree"], "-o", Scratch["q.fastpoints"] },
            ["export", Scratch["tree"], "-o", Scratch["q.las"]] })
            for (int i = 0; i < 2; i++)
            {
                var call = CliCall.Of(line);
                Assert.That(call.Status, Is.Zero, call.Error);
            }
    }

    [TestCase("{\"version\": 1}"), TestCase("not ours")]
    public void Convert_OverAForeignFolder_NeedsForce(string manifest)
    {
        Directory.CreateDirectory(Scratch["q.fastpoints"]);
        File.WriteAllText(Scratch["q.fastpoints/cloud.json"], manifest);
        string[] convert = ["convert", Scratch.Demo(), "-o", Scratch["q.fastpoints"], "--quiet"];
        var refused = CliCall.Of(convert);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain("holds something else: --force"));
        Assert.That(CliCall.Of([.. convert, "--force"]).Status, Is.Zero);
    }

    [TestCase("out.las"), TestCase("out.laz"), TestCase("out.ply")]
    public void Export_OverAFileOfOtherSourcesOrAnEditedOne_NeedsForce(string name)
    {
        string output = Scratch[name], cloud = Scratch.Converted(), scan = Scratch["s3000.las"];
        string[] Export(string from) => ["export", from, "-o", output, "--quiet"];
        Assert.That(CliCall.Of(Export(cloud)).Status, Is.Zero);
        Assert.That(CliCall.Of([.. Export(cloud), "--every-nth", "2"]).Status, Is.Zero, "of the same cloud");

        var refused = CliCall.Of(Export(scan));
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain("other sources than s3000.las").And.Contains("--force"));
        Assert.That(CliCall.Of([.. Export(scan), "--force"]).Status, Is.Zero);
        Assert.That(CliCall.Of(Export(scan)).Status, Is.Zero, "of the same file");

        using (var file = File.OpenWrite(output))
        {
            file.Seek(-1, SeekOrigin.End);
            file.WriteByte(1);
        }
        Assert.That(CliCall.Of(Export(scan)).Status, Is.EqualTo(ExitStatus.Usage), "edited");
    }

    [TestCase("returnnumber"), TestCase("GpsTime"), TestCase("scanangle"), TestCase("pointsource")]
    public void Picture_ByAnAttribute_DiffersFromRgb(string color)
    {
        string scan = Scratch.Demo("scan.las", 3000), cloud = Scratch.Converted();
        foreach (string source in new[] { scan, cloud })
        {
            byte[] Draw(string by)
            {
                var call = CliCall.Of("picture", source, "-o", Scratch["p.png"], "--size", "160x90", "--style", "color=" + by);
                Assert.That(call.Status, Is.Zero, call.Error);
                Assert.That(call.Output, Does.Not.Contain("to colour by"));
                return File.ReadAllBytes(Scratch["p.png"]);
            }
            Assert.That(Draw(color), Is.Not.EqualTo(Draw("rgb")));
        }
    }

    [Test]
    public void Picture_ByAnAttributeOfAnOctreeWithABudget_IsDrawnFromTheFile()
    {
        Assert.That(CliCall.Of("export", Scratch.Demo("scan.las"), "-o", Scratch["scan.copc.laz"]).Status, Is.Zero);
        var call = CliCall.Of("picture", Scratch["scan.copc.laz"], "-o", Scratch["p.png"], "--budget", "1000", "--style",
            "color=gpstime");
        Assert.That(call.Status, Is.Zero, call.Error);
    }

    [TestCase("--clip", "0,0,0,1,1,1"), TestCase("--style", "classes=99")]
    public void Picture_WithoutAPoint_WarnsAndIsIncompleteIfStrict(params string[] filter)
    {
        string[] draw = ["picture", Scratch.Converted(), "-o", Scratch["p.png"], "--size", "160x90", .. filter];
        var call = CliCall.Of(draw);
        Assert.That(call.Status, Is.Zero);
        Assert.That(call.Error, Does.Match(@"p\.png: no point is to be seen of 3,000, which lie in \(44.*\) to \(44"));
        Assert.That(call.Error, filter[0] == "--clip" ? Does.Contain("; wanted (0, 0, 0) to (1, 1, 1)")
            : Does.Not.Contains("wanted"));
        Assert.That(CliCall.Of([.. draw, "--strict"]).Status, Is.EqualTo(4));
        Assert.That(CliCall.Of("picture", Scratch["scan.fastpoints"], "-o", Scratch["p.png"], "--strict").Status, Is.Zero);
    }

    [TestCase("picture"), TestCase("preview"), TestCase("")]
    public void Picture_ByAMissingAttribute_IsWrongUsageAndListsTheOthers(string verb)
    {
        string[] draw = [Scratch.Demo(), "-o", Scratch[verb == "" ? "report" : "p.png"], "--style", "color=temperature"];
        var call = CliCall.Of(verb == "" ? draw : [verb, .. draw]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(Path.Exists(draw[2]), Is.False, "nothing is written");
        Assert.That(call.Error, Does.Contain("no temperature to colour by; it has X, Y, Z, Intensity"));
    }

    [Test]
    public void Picture_OfEachView_DiffersAndSideIsLeft()
    {
        string scan = Scratch.Demo();
        var pictures = new[] { "top", "bottom", "front", "back", "left", "right", "iso", "side" }.Select(view =>
        {
            var call = CliCall.Of("picture", scan, "-o", Scratch["p.png"], "--size", "160x90", "--view", view);
            Assert.That(call.Status, Is.Zero, call.Error);
            return System.Convert.ToHexString(File.ReadAllBytes(Scratch["p.png"]));
        }).ToList();
        Assert.That(pictures.Distinct().Count(), Is.EqualTo(7));
        Assert.That(pictures[^1], Is.EqualTo(pictures[4]));
    }

    [Test]
    [Platform("Linux")]
    public void Info_NonUtf8Name_ReadsTheFile()
    {
        Scratch.Demo("scan.las", 100);
        string line = "cp scan.las NAME; \"$0\" info NAME; status=$?; rm NAME; exit $status"
            .Replace("NAME", "$'a\\xff.las'");
        Assert.That(Shell(line, out string output), Is.Zero, output);
        Assert.That(output, Does.Contain("100 by the header").And.Contains("/a%FF.las"));
    }

    [TestCase("convert scan.las -o $'a\\xff.fastpoints'")]
    [TestCase("export scan.las -o $'b\\xff.las'"), TestCase("info $'c\\xff'")]
    [Platform("Linux")]
    public void Output_NonUtf8Name_IsRefusedAndNothingIsWritten(string line)
    {
        Scratch.Demo("scan.las", 100);
        string all = "touch $'b\\xff.las'; \"$0\" " + line + "; status=$?; rm $'b\\xff.las'; exit $status";
        Assert.That(Shell(all, out string output), Is.EqualTo(ExitStatus.Usage), output);
        Assert.That(output, Does.Contain("%FF"));
        Assert.That(Directory.GetFileSystemEntries(Scratch.Root), Has.Length.EqualTo(1));
    }

    [Test]
    public void Picture_OfADamagedCloud_NamesFileAndByteAndIsIncompleteIfStrict()
    {
        string cloud = Scratch.Converted(), upper = Directory.GetFiles(Path.Combine(cloud, "upper")).Single();
        byte[] bytes = File.ReadAllBytes(upper);
        bytes[100] ^= 4;
        File.WriteAllBytes(upper, bytes);
        string[] draw = ["picture", cloud, "-o", Scratch["p.png"], "--size", "160x90"];
        Assert.That(CliCall.Of(draw).Error, Does.Match(@"upper/.*\.bin.* at (byte )?96: node 0 is damaged"));
        Assert.That(CliCall.Of([.. draw, "--strict"]).Status, Is.Not.Zero);
        var export = CliCall.Of("export", cloud, "-o", Scratch["out.las"]);
        Assert.That(export.Error, Does.Match(@"upper/.*\.bin: at byte 96: .*hash does not fit: wanted \w{16}, got \w{16}"));
        Assert.That(CliCall.Of("verify", cloud).Output, Does.Match(@"upper/.*\.bin: at byte 96: .*wanted \w{16}, got \w{16}"));
    }

    [TestCase("info scan.las"), TestCase("info scan.las --json -"), TestCase("convert --help")]
    [TestCase("--help"), TestCase("help --man")]
    [Platform("Linux")]
    public void Output_ThatCannotBeWritten_IsAFailure(string line)
    {
        Scratch.Demo("scan.las", 100);
        Assert.That(Shell("\"$0\" " + line + " > /dev/full", out string output), Is.EqualTo(ExitStatus.Failed));
        Assert.That(output, Does.StartWith("fastpoints: standard output: ").And.EndsWith("\n"));
    }

    [TestCase("-.las", "LAS"), TestCase("-.laz", "LAZ"), TestCase("-.ply", "PLY"), TestCase("-", "LAS")]
    [Platform("Linux")]
    public void Pipe_OfExportIntoConvert_IsTheCloud(string output, string format)
    {
        Scratch.Demo("scan.las", 3000);
        string made = Directory.CreateDirectory(Scratch["tmp"]).FullName;
        Assert.That(Shell($"export TMPDIR={made}; set -o pipefail; \"$0\" export scan.las -o {output} | tee made | "
            + "\"$0\" convert - -o q.fastpoints", out string said), Is.Zero, said);
        Assert.That(said, Does.Contain("warning: standard input is kept in " + made).And.Contains("q.fastpoints: 3,000 points"));
        Assert.That(CliCall.Of("verify", Scratch["q.fastpoints"], "--against", Scratch["made"]).Status, Is.Zero);
        Assert.That(CliCall.Of("info", Scratch["made"], "--json", "-").Json.GetProperty("format").GetString(),
            Is.EqualTo(format));
        Assert.That(Directory.GetFileSystemEntries(made), Is.Empty);
    }

    [TestCase("printf '1 2 3\\n4 5 6\\n' | \"$0\" info - --scan", 0, "points                2")]
    [TestCase("\"$0\" info - < /dev/null", ExitStatus.BadInput, "standard input is empty")]
    [TestCase("\"$0\" info - - < scan.las", ExitStatus.Usage, "can be read once")]
    [TestCase("\"$0\" export scan.las -o - --json -", ExitStatus.Usage, "only one of them can be standard output")]
    [TestCase("\"$0\" picture scan.las -o -", ExitStatus.Usage, "standard output takes points")]
    [TestCase("\"$0\" convert scan.las -o -", ExitStatus.Usage, "standard output takes points")]
    [TestCase("\"$0\" export scan.las -o - > /dev/full", ExitStatus.Failed, "standard output: ")]
    [TestCase("\"$0\" demo-cloud -o - --points 9 | \"$0\" info - | grep '9 by the header'", 0, "9 by")]
    [Platform("Linux")]
    public void Dash_AsPath_IsStandardInputOrOutput(string line, int status, string expected)
    {
        Scratch.Demo("scan.las", 100);
        Assert.That(Shell(line, out string said), Is.EqualTo(status), said);
        Assert.That(said, Does.Contain(expected));
    }

    int Shell(string line, out string output)
    {
        var start = new ProcessStartInfo("bash", ["-c", line, Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli")])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = Scratch.Root,
        };
        using var process = Process.Start(start);
        var errors = process.StandardError.ReadToEndAsync();
        output = process.StandardOutput.ReadToEnd() + errors.Result;
        process.WaitForExit();
        return process.ExitCode;
    }
}
