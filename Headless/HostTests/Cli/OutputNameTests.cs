namespace FastPoints.HostTests.Cli;

public sealed class OutputNameTests : ScratchPerTest
{
    [SetUp]
    public void MakeInputs()
    {
        Directory.CreateDirectory(Scratch["tiles"]);
        Assert.That(CliCall.Of("demo-cloud", "-o", Scratch["scan.las"], "--points", "100").Status, Is.Zero);
        File.Copy(Scratch["scan.las"], Scratch["tiles/a.las"]);
        File.WriteAllText(Scratch["scan.txt"], "1 2 3\n4 5 6\n");
        File.CreateSymbolicLink(Scratch["link.txt"], Scratch["scan.txt"]);
    }

    [TestCase("preview", "@scan.las", "-o", "@scan.las")]
    [TestCase("preview", "@scan.txt", "-o", "@tiles/../scan.txt")]
    [TestCase("picture", "@scan.txt", "-o", "@scan.txt")]
    [TestCase("picture", "@scan.las", "-o", "@p.png", "--flip-map", "@q.png", "--against", "@q.png")]
    [TestCase("picture", "@scan.las", "-o", "@p.png", "--flip-map", "@f.png")]
    [TestCase("picture", "@scan.las", "-o", "@p.png", "--flip-map", "@p.png", "--against", "@scan.txt")]
    [TestCase("info", "@scan.txt", "--json", "@scan.txt")]
    [TestCase("info", "@link.txt", "--json", "@scan.txt")]
    [TestCase("info", "@scan.txt", "--json", "@link.txt")]
    [TestCase("info", "@tiles", "--json", "@tiles/a.las")]
    [TestCase("verify", "@tiles", "--against", "@scan.txt", "--json", "@scan.txt")]
    [TestCase("convert", "@scan.las", "-o", "@scan.las")]
    [TestCase("convert", "@scan.txt", "-o", "@scan.txt")]
    [TestCase("fly", "@scan.txt", "-o", "@scan.txt", "--frames", "1")]
    [TestCase("demo-cloud", "--tile", "@scan.las", "--times", "2", "-o", "@scan.las")]
    [TestCase("@scan.txt", "--json", "@scan.txt", "--out", "@report")]
    [TestCase("@scan.txt", "-o", "@scan.txt")]
    [TestCase("--force", "preview", "@scan.las", "-o", "@scan.las")]
    [TestCase("--force", "info", "@scan.txt", "--json", "@scan.txt")]
    public void Output_OfAnInput_IsWrongUsageAndNothingIsWritten(params string[] args)
    {
        byte[][] before = Contents();
        var call = CliCall.Of(args.Select(a => a.StartsWith('@') ? Scratch[a[1..]] : a).ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(Contents(), Is.EqualTo(before));
    }

    [TestCase("preview", "@scan.las", "-o", "@new.laz")]
    [TestCase("picture", "@scan.las", "-o", "@new.ply")]
    [TestCase("info", "@scan.las", "--json", "@new.LAS")]
    [TestCase("convert", "@scan.las", "-o", "@new.copc.laz")]
    public void Output_NamedAsAPointCloud_IsWrongUsage(params string[] args)
    {
        var call = CliCall.Of(args.Select(a => a.StartsWith('@') ? Scratch[a[1..]] : a).ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(call.Error, Does.Contain(args[^1][1..]));
        Assert.That(File.Exists(Scratch[args[^1][1..]]), Is.False);
    }

    [Test]
    public void DemoCloud_OverAForeignFile_NeedsForce()
    {
        string[] demo = ["demo-cloud", "-o", Scratch["scan.las"], "--points", "50"];
        Assert.That(CliCall.Of(demo).Status, Is.Zero, "its own scan is replaced");
        File.WriteAllBytes(Scratch["scan.las"], new byte[600]);
        var refused = CliCall.Of(demo);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain("--force"));
        Assert.That(new FileInfo(Scratch["scan.las"]).Length, Is.EqualTo(600));
        Assert.That(CliCall.Of(demo.Append("--force").ToArray()).Status, Is.Zero);
    }

    [TestCase("@p.png", "preview", "@scan.las", "-o", "@p.png", "--size", "16x16")]
    [TestCase("@p.png", "picture", "@scan.las", "-o", "@p.png", "--size", "16x16")]
    [TestCase("@s.json", "info", "@scan.las", "--json", "@s.json")]
    [TestCase("@s.las", "demo-cloud", "-o", "@s.las", "--points", "10")]
    [TestCase("@s.laz", "demo-cloud", "-o", "@s.laz", "--points", "10")]
    [TestCase("@s.ply", "demo-cloud", "-o", "@s.ply", "--points", "10")]
    public void Output_ForeignFile_NeedsForce(string output, params string[] args)
    {
        output = Real(output);
        args = args.Select(Real).ToArray();
        File.WriteAllText(output, "of somebody else");
        var refused = CliCall.Of(args);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage), refused.Error);
        Assert.That(refused.Error, Does.Contain("--force"));
        Assert.That(File.ReadAllText(output), Is.EqualTo("of somebody else"));
        Assert.That(CliCall.Of(args.Append("--force").ToArray()).Status, Is.Zero);
        Assert.That(CliCall.Of(args).Status, Is.Zero, "its own output is replaced");
        File.WriteAllText(output, "");
        Assert.That(CliCall.Of(args).Status, Is.Zero, "nothing is lost with an empty file");
    }

    [TestCase("report.json", "@scan.las", "-o", "@d")]
    [TestCase("PerformanceTestResults.json", "bench", "job chain", "--runs", "1", "--points", "100", "-o", "@d")]
    public void Folder_WithOtherThings_NeedsForce(string made, params string[] args)
    {
        args = args.Select(Real).ToArray();
        Directory.CreateDirectory(Scratch["d"]);
        File.WriteAllText(Scratch["d/notes.txt"], "of somebody else");
        var refused = CliCall.Of(args);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage), refused.Error);
        Assert.That(Directory.GetFiles(Scratch["d"]), Has.Length.EqualTo(1));
        Assert.That(CliCall.Of(args.Prepend("--force").ToArray()).Status, Is.Zero);
        Assert.That(File.Exists(Scratch["d/" + made]), Is.True);
        Assert.That(CliCall.Of(args).Status, Is.Zero, "its own folder is filled again");
        Assert.That(File.ReadAllText(Scratch["d/notes.txt"]), Is.EqualTo("of somebody else"));
    }

    [Test]
    public void Convert_ToAPointCloudFile_SuggestsExport() => Assert.That(
        CliCall.Of("convert", Scratch["scan.las"], "-o", Scratch["new.laz"]).Error, Does.Contain("export"));

    string Real(string arg) => arg.StartsWith('@') ? Scratch[arg[1..]] : arg;

    byte[][] Contents() => Directory.GetFiles(Scratch.Root, "*", SearchOption.AllDirectories).Order()
        .Select(File.ReadAllBytes).ToArray();
}
