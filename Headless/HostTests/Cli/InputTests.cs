using System.Diagnostics;

namespace FastPoints.HostTests.Cli;

public sealed class InputTests : ScratchPerTest
{
    [Test]
    public void Info_OfALink_ReadsWhatItLeadsTo()
    {
        string demo = Scratch.Demo("scan.las", 100);
        File.CreateSymbolicLink(Scratch["link.las"], demo);
        Assert.That(CliCall.Of("info", Scratch["link.las"], "--scan", "--json", "-").Json.GetProperty("points").GetInt64(),
            Is.EqualTo(100));
    }

    [Test]
    public void Info_OfAFolder_LooksIntoFoldersIfItIsTold()
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

    [TestCase("returnnumber"), TestCase("GpsTime"), TestCase("scanangle"), TestCase("pointsource")]
    public void Picture_ByAnAttribute_OfAFileAndOfACloud_IsNotThatByColour(string color)
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

    [TestCase("picture"), TestCase("preview")]
    public void Picture_ByWhatIsNotThere_IsWrongUsageAndNamesWhatIs(string verb)
    {
        var call = CliCall.Of(verb, Scratch.Demo(), "-o", Scratch["p.png"], "--style", "color=temperature");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(call.Error, Does.Contain("no temperature to colour by; it has X, Y, Z, Intensity"));
    }

    [Test]
    public void Picture_OfEachView_IsAnotherAndSideIsLeft()
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
    public void Info_OfANameThatIsNoUtf8_ReadsTheFile()
    {
        Scratch.Demo("scan.las", 100);
        string line = "cp scan.las NAME; \"$0\" info NAME; status=$?; rm NAME; exit $status".Replace("NAME", "$'a\\xff.las'");
        Assert.That(Shell(line, out string output), Is.Zero, output);
        Assert.That(output, Does.Contain("100 by the header"));
    }

    [TestCase("info scan.las"), TestCase("info scan.las --json -"), TestCase("convert --help")]
    [Platform("Linux")]
    public void Output_ThatCannotBeWritten_IsAFailure(string line)
    {
        Scratch.Demo("scan.las", 100);
        Assert.That(Shell("\"$0\" " + line + " > /dev/full", out string output), Is.EqualTo(ExitStatus.Failed));
        Assert.That(output, Does.StartWith("fastpoints: standard output: ").And.EndsWith("\n"));
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
