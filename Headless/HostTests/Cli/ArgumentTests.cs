namespace FastPoints.HostTests.Cli;

public sealed class ArgumentTests : ScratchTests
{
    string m_demo;

    [OneTimeSetUp]
    public void MakeDemo() => m_demo = Scratch.Demo();

    [Test]
    public void CommonOption_BeforeTheVerb_IsHonoured()
    {
        var call = CliCall.Of("--json", "-", "--quiet", "info", m_demo);
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("verb").GetString(), Is.EqualTo("info"));
    }

    [Test]
    public void File_AfterTwoDashes_MayHaveAnyName()
    {
        string before = Environment.CurrentDirectory;
        File.Copy(m_demo, Scratch["--help"]);
        try
        {
            Environment.CurrentDirectory = Scratch.Root;
            var call = CliCall.Of("info", "--json", "-", "--", "--help");
            Assert.That(call.Status, Is.Zero, call.Error);
            Assert.That(call.Json.GetProperty("inputs")[0].GetString(), Is.EqualTo("--help"));
            Assert.That(CliCall.Of("info", "--", "-none").Status, Is.EqualTo(ExitStatus.BadInput));
        }
        finally
        {
            Environment.CurrentDirectory = before;
        }
    }

    [TestCase("2k", 2000)]
    [TestCase("2e3", 2000)]
    [TestCase("1.5k", 1500)]
    [TestCase("2,000", 2000)]
    [TestCase("0.002M", 2000)]
    public void DemoCloud_PointsInAnySpelling_AreParsed(string written, long points)
    {
        var call = CliCall.Of("demo-cloud", "-o", Scratch["n.las"], "--points", written, "--json", "-");
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.EqualTo(points));
    }

    [Test]
    public void Threads_AboveTheCores_AreTakenDownWithANote()
    {
        var call = CliCall.Of("info", m_demo, "--threads", "1M", "--json", "-");
        Assert.That(call.Status, Is.Zero, call.Error);
        string note = call.Json.GetProperty("warnings")[0].GetString();
        Assert.That(note, Does.Contain("there are " + Environment.ProcessorCount + " cores"));
        Assert.That(call.Error, Does.Contain(note));
    }

    [TestCase("bench", "job chain", "--runs", "1", "--points", "100")]
    public void Output_ByItsOldName_IsStillKnown(params string[] args)
    {
        foreach (string name in new[] { "-o", "--output", "--out" })
        {
            string folder = Scratch["folder" + name];
            Assert.That(CliCall.Of(args.Append(name).Append(folder).ToArray()).Status, Is.Zero, name);
            Assert.That(Directory.GetFiles(folder), Is.Not.Empty);
        }
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void Json_ToADevice_IsWrittenAndTheDeviceStays()
    {
        Assert.That(CliCall.Of("info", m_demo, "--json", "/dev/null").Status, Is.Zero);
        Assert.That(File.ReadAllBytes("/dev/null"), Is.Empty);
    }
}
