namespace FastPoints.HostTests.Cli;

public sealed class FailureTests : ScratchPerTest
{
    static void FailsInOneLine(CliCall call, int status, string file)
    {
        Assert.That(call.Status, Is.EqualTo(status), call.Error);
        Assert.That(call.ErrorLines, Is.EqualTo(1), call.Error);
        Assert.That(call.Error, Does.StartWith("fastpoints: " + file + ": "));
    }

    [Test]
    public void Info_OfNoFile_IsBadInput() =>
        FailsInOneLine(CliCall.Of("info", Scratch["none.las"]), ExitStatus.BadInput, Scratch["none.las"]);

    [Test]
    public void Info_OfAFolder_IsBadInput() =>
        FailsInOneLine(CliCall.Of("info", Scratch.Root), ExitStatus.BadInput, Scratch.Root);

    [TestCase("")]
    [TestCase("LASF")]
    [TestCase("this is no point cloud, but long enough for a header of any kind that one might think of")]
    public void Info_OfAnotherFile_IsBadInput(string content)
    {
        File.WriteAllText(Scratch["bad.las"], content);
        FailsInOneLine(CliCall.Of("info", Scratch["bad.las"]), ExitStatus.BadInput, Scratch["bad.las"]);
    }

    [TestCase("lat,lon,alt\n50.1,8.6,120\n50.2,8.7,121\n", "--columns x,y,z")]
    [TestCase("tree 1 2 3\nhouse 4 5 6\n", "--columns x,y,z")]
    [TestCase("\u0089PNG\r\n\u001a\nrest of it", "a picture holds no points")]
    [TestCase("", "what comes from a pipe is read as -")]
    public void Info_NotACloud_GivesAHint(string content, string hint)
    {
        File.WriteAllBytes(Scratch["odd"], Encoding.Latin1.GetBytes(content));
        var call = CliCall.Of("info", Scratch["odd"]);
        FailsInOneLine(call, ExitStatus.BadInput, Scratch["odd"]);
        Assert.That(call.Error, Does.Contain(hint));
    }

    [TestCase("")]
    [TestCase("/ept.json")]
    public void Info_OctreeWithoutPoints_IsBadInput(string index)
    {
        Directory.CreateDirectory(Scratch["tree/ept-hierarchy"]);
        File.WriteAllText(Scratch["tree/ept-hierarchy/0-0-0-0.json"], "{\"0-0-0-0\":1}");
        string axes = string.Join(",", "XYZ".Select(c =>
            $"{{\"name\":\"{c}\",\"type\":\"signed\",\"size\":4,\"scale\":0.01,\"offset\":0}}"));
        File.WriteAllText(Scratch["tree/ept.json"], "{\"bounds\":[0,0,0,1,1,1],\"boundsConforming\":[0,0,0,1,1,1],"
            + "\"dataType\":\"laszip\",\"hierarchyType\":\"json\",\"points\":1,\"span\":128,\"version\":\"1.0.0\","
            + "\"schema\":[" + axes + "]}");
        FailsInOneLine(CliCall.Of("info", Scratch["tree" + index]), ExitStatus.BadInput,
            Scratch["tree/ept-data/0-0-0-0.laz"]);
    }

    [Test]
    public void Info_OfAnUrlOrAFolderOfFolders_GivesAHint()
    {
        Assert.That(CliCall.Of("info", "ftp://example.org/a.laz").Error, Does.Contain("download the file"));
        Directory.CreateDirectory(Scratch["all/tiles"]);
        Scratch.Demo("all/tiles/a.las", 10);
        var call = CliCall.Of("info", Scratch["all"]);
        FailsInOneLine(call, ExitStatus.BadInput, Scratch["all"]);
        Assert.That(call.Error, Does.Contain("name those, such as " + Scratch["all/tiles"]));
    }

    [Test]
    public void Columns_WithUnusedWords_AreRead()
    {
        File.WriteAllText(Scratch["words.txt"], "tree 1 2 3\nhouse 4 5 6\n");
        var call = CliCall.Of("info", "--scan", Scratch["words.txt"], "--columns=-,x,y,z", "--json", "-");
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.EqualTo(2));
    }

    [Test]
    public void Failure_WithJson_IsInTheSummary()
    {
        File.WriteAllText(Scratch["bad.las"], "LASF");
        var call = CliCall.Of("info", Scratch["bad.las"], "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        var failure = call.Json.GetProperty("failure");
        Assert.That(failure.GetProperty("code").GetString(), Is.EqualTo("Truncated"));
        Assert.That(failure.GetProperty("file").GetString(), Is.EqualTo(Scratch["bad.las"]));
        Assert.That(failure.GetProperty("message").GetString(), Does.StartWith(Scratch["bad.las"]));
        Assert.That(failure.GetProperty("offset").ValueKind, Is.EqualTo(JsonValueKind.Number));
        Assert.That(call.Json.GetProperty("inputs")[0].GetString(), Is.EqualTo(Scratch["bad.las"]));
    }

    [Test]
    public void Output_IntoAMissingFolder_Fails()
    {
        string demo = Scratch.Demo();
        FailsInOneLine(CliCall.Of("preview", demo, "-o", Scratch["no/such/p.png"], "--size", "16x16"), ExitStatus.Failed,
            Scratch["no/such/p.png"]);
        FailsInOneLine(CliCall.Of("demo-cloud", "-o", Scratch["no/such/d.las"], "--points", "10"), ExitStatus.Failed,
            Scratch["no/such/d.las"]);
    }

    [Test]
    public void Picture_AgainstAnotherSize_IsBadInput()
    {
        string demo = Scratch.Demo(), small = Scratch["small.png"];
        Assert.That(CliCall.Of("picture", demo, "-o", small, "--size", "16x16").Status, Is.EqualTo(ExitStatus.Done));
        FailsInOneLine(CliCall.Of("picture", demo, "-o", Scratch["p.png"], "--size", "32x16", "--against", small),
            ExitStatus.BadInput, small);
    }

    [TestCase("demo-cloud", "-o", "OUT/made.las", "--points", "100000")]
    [TestCase("demo-cloud", "-o", "OUT/made.ply", "--points", "100000", "--order", "random")]
    [TestCase("preview", "DEMO", "-o", "OUT/p.png")]
    [TestCase("picture", "DEMO", "-o", "OUT/p.png")]
    [TestCase("convert", "DEMO", "-o", "OUT/made.fastpoints")]
    [TestCase("demo-cloud", "-o", "OUT/tiled.las", "--tile", "DEMO", "--times", "3")]
    public void Spool_Cancelled_LeavesNothing(params string[] args)
    {
        string demo = Scratch.Demo();
        Directory.CreateDirectory(Scratch["out"]);
        var call = CliCall.Of(new CancellationToken(true),
            args.Select(a => a == "DEMO" ? demo : a.Replace("OUT", Scratch["out"], StringComparison.Ordinal)).ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Cancelled), call.Error);
        Assert.That(call.Error, Is.EqualTo("fastpoints: cancelled" + Environment.NewLine));
        Assert.That(Directory.GetFileSystemEntries(Scratch["out"]), Is.Empty);
    }
}
