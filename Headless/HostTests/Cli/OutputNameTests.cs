namespace FastPoints.HostTests.Cli;

/// <summary>No verb writes over an input, nor under a name that promises another kind of file.</summary>
public sealed class OutputNameTests
{
    ScratchFolder m_scratch;

    [SetUp]
    public void MakeInputs()
    {
        m_scratch = new ScratchFolder();
        Directory.CreateDirectory(m_scratch["tiles"]);
        Assert.That(CliCall.Of("demo-cloud", "-o", m_scratch["scan.las"], "--points", "100").Status, Is.Zero);
        File.Copy(m_scratch["scan.las"], m_scratch["tiles/a.las"]);
        File.WriteAllText(m_scratch["scan.txt"], "1 2 3\n4 5 6\n");
        File.CreateSymbolicLink(m_scratch["link.txt"], m_scratch["scan.txt"]);
    }

    [TearDown]
    public void RemoveScratch() => m_scratch.Dispose();

    [TestCase("preview", "@scan.las", "-o", "@scan.las")]
    [TestCase("preview", "@scan.txt", "-o", "@tiles/../scan.txt")]
    [TestCase("picture", "@scan.txt", "-o", "@scan.txt")]
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
    public void Output_OfAnInput_IsWrongUsageAndNothingIsWritten(params string[] args)
    {
        byte[][] before = Contents();
        var call = CliCall.Of(args.Select(a => a.StartsWith('@') ? m_scratch[a[1..]] : a).ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(Contents(), Is.EqualTo(before));
    }

    [TestCase("preview", "@scan.las", "-o", "@new.laz")]
    [TestCase("picture", "@scan.las", "-o", "@new.ply")]
    [TestCase("info", "@scan.las", "--json", "@new.LAS")]
    [TestCase("convert", "@scan.las", "-o", "@new.copc.laz")]
    public void Output_NamedAsAPointCloud_IsWrongUsage(params string[] args)
    {
        var call = CliCall.Of(args.Select(a => a.StartsWith('@') ? m_scratch[a[1..]] : a).ToArray());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(call.Error, Does.Contain(args[^1][1..]));
        Assert.That(File.Exists(m_scratch[args[^1][1..]]), Is.False);
    }

    [Test]
    public void DemoCloud_OverAScanOfSomebody_WantsForce()
    {
        string[] demo = ["demo-cloud", "-o", m_scratch["scan.las"], "--points", "50"];
        Assert.That(CliCall.Of(demo).Status, Is.Zero, "its own scan is replaced");
        File.WriteAllBytes(m_scratch["scan.las"], new byte[600]);
        var refused = CliCall.Of(demo);
        Assert.That(refused.Status, Is.EqualTo(ExitStatus.Usage));
        Assert.That(refused.Error, Does.Contain("--force"));
        Assert.That(new FileInfo(m_scratch["scan.las"]).Length, Is.EqualTo(600));
        Assert.That(CliCall.Of(demo.Append("--force").ToArray()).Status, Is.Zero);
    }

    byte[][] Contents() => Directory.GetFiles(m_scratch.Root, "*", SearchOption.AllDirectories).Order()
        .Select(File.ReadAllBytes).ToArray();
}
