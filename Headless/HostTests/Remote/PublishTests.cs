namespace FastPoints.HostTests.Remote;

[NonParallelizable]
public sealed class PublishTests : ScratchTests
{
    string m_cloud;
    RangeServer m_server;

    [SetUp]
    public void MakeCloud()
    {
        RemoteAccess.CacheBytes = 0;
        m_cloud = Scratch["cloud.fastpoints"];
        if (!Directory.Exists(m_cloud))
            Convert();
        m_server = new RangeServer(Path.GetDirectoryName(m_cloud));
    }

    void Convert()
    {
        var settings = new ConvertSettings { PointsPerChunk = 6000, CellsLog2 = 4, TargetPointsPerLeaf = 500 };
        using var reader = PointReaders.Open(Scratch.Demo(points: 20_000));
        JobCoroutine.RunToEnd(ConvertCloud.Run([reader], m_cloud, settings, _ => { }, null));
    }

    [TearDown]
    public void EndServing()
    {
        m_server.Dispose();
        RemoteAccess.CacheBytes = 4L << 30;
        HttpFile.Forget();
    }

    string Address => m_server.Of("cloud.fastpoints");

    [Test]
    public void Publish_OfAFolderAndOfItsAddress_CountTheirFiles()
    {
        string[] files = Directory.GetFiles(m_cloud, "*", SearchOption.AllDirectories);
        foreach (string path in new[] { m_cloud, Address })
        {
            var call = CliCall.Of("publish", path, "--json", "-");
            Assert.That(call.Status, Is.Zero, call.Error);
            // A server is not asked for what not every cloud has.
            var counted = files.Where(f => path == m_cloud || Path.GetFileName(f) is not ("facts.json" or "records.las"))
                .ToArray();
            Assert.That(call.Json.GetProperty("files").GetInt64(), Is.EqualTo(counted.Length));
            Assert.That(call.Json.GetProperty("bytes").GetInt64(), Is.EqualTo(counted.Sum(f => new FileInfo(f).Length)));
            Assert.That(call.Json.GetProperty("problems").GetArrayLength(), Is.Zero);
        }
    }

    [Test]
    public void Publish_OfAFolderWithMissingAndOtherFiles_NamesThem()
    {
        string other = Path.Combine(m_cloud, "notes.txt");
        string chunk = Directory.GetFiles(Path.Combine(m_cloud, "chunks"), "*", SearchOption.AllDirectories)[0];
        File.WriteAllText(other, "");
        File.Move(chunk, Scratch["chunk"]);
        try
        {
            var call = CliCall.Of("publish", m_cloud);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
            Assert.That(call.Output, Does.Contain(chunk + " is missing").And.Contain(other + " is no part of the cloud"));
        }
        finally
        {
            File.Delete(other);
            File.Move(Scratch["chunk"], chunk);
        }
    }

    [TestCase(nameof(Fault.WholeBody), "no ranges")]
    [TestCase(nameof(Fault.Compressed), "compressed")]
    [TestCase(nameof(Fault.Missing404), "no such file")]
    public void Publish_OnAServerThatDoesNotDoAsNeeded_SaysWhat(string fault, string wanted)
    {
        m_server.Plan = request => request.Name.Contains("chunks") ? Enum.Parse<Fault>(fault) : Fault.None;
        var call = CliCall.Of("publish", Address + "?sig=secret");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput), call.Error);
        Assert.That(call.Output, Does.Contain(wanted));
        Assert.That(call.Output + call.Error, Does.Not.Contain("secret"));
    }
}
