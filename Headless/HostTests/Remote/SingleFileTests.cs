namespace FastPoints.HostTests.Remote;

/// <summary>A cloud of one file gives what the same cloud gives as many files, from the disk and by its address.</summary>
[NonParallelizable]
sealed class SingleFileTests : RemoteFixture
{
    string m_many, m_one;

    [SetUp]
    public void MakeClouds()
    {
        RemoteSettings.Current = new RemoteSettings { ConfirmedMs = 60_000 };
        m_many = Scratch["served/many.fastpoints"];
        m_one = Scratch["served/one.fastpoints"];
        var settings = new ConvertSettings { PointsPerChunk = 6000, CellsLog2 = 4, TargetPointsPerLeaf = 500 };
        using (var reader = PointReaders.Open(Scratch.Demo(points: 20_000)))
            JobCoroutine.RunToEnd(ConvertCloud.Run([reader], m_many, settings, _ => { }, null));
        Assert.That(Directory.GetFiles(Path.Combine(m_many, "chunks")), Has.Length.GreaterThan(1));
    }

    void Publish()
    {
        var call = CliCall.Of("publish", m_many, "--single", "-o", m_one, "--json", "-");
        Assert.That(call.Status, Is.Zero, call.Error);
        Assert.That(call.Json.GetProperty("files").GetInt64(), Is.EqualTo(5));
        Assert.That(Directory.GetFileSystemEntries(m_one).Select(Path.GetFileName).Order(), Is.EqualTo(
            new[] { "cloud.bin", "cloud.json", "facts.json", "records.las", "sources.json" }));
    }

    [Test]
    public void Publish_SingleWithNormals_HasThem()
    {
        Assert.That(CliCall.Of("convert", m_many, "--normals").Status, Is.Zero);
        Publish();
        var verified = CliCall.Of("verify", m_one, "--against", Scratch["demo.las"]);
        Assert.That(verified.Status, Is.Zero, verified.Output + verified.Error);
        Assert.That(File.ReadAllText(Path.Combine(m_one, "cloud.json")), Does.Contain("\"orientation\""));
        Assert.That(CliCall.Of("verify", Server.Of("one.fastpoints")).Status, Is.Zero);
        Assert.That(CliCall.Of("verify", Server.Of("many.fastpoints")).Status, Is.Zero);
        Assert.That(CliCall.Of("convert", m_one, "--normals").Error, Does.Contain("one of a single file"));
    }

    [Test]
    public void Publish_Single_GivesPointsAndPicturesOfTheFolder()
    {
        Publish();
        string source = Scratch["demo.las"];
        var verified = CliCall.Of("verify", m_one, "--against", source);
        Assert.That(verified.Status, Is.Zero, verified.Output + verified.Error);
        Assert.That(CliCall.Of("publish", Server.Of("one.fastpoints")).Status, Is.Zero);
        StartAnew();
        string[] clouds = [m_many, m_one, Server.Of("one.fastpoints") + Secret];
        var infos = clouds.Select(Info).ToArray();
        Assert.That(infos[0], Does.Contain("\"nodes\"").And.Contain("demo.las"));
        Assert.That(infos[1..], Is.All.EqualTo(infos[0]));
        foreach (string verb in new[] { "picture", "fly --frames 40 --every 40" })
        {
            var pictures = clouds.Select((cloud, i) => Draw(verb.Split(' '), cloud, Scratch[verb[..3] + i + ".png"])).ToArray();
            Assert.That(pictures[0].Distinct().Count(), Is.GreaterThan(10), "the picture is empty");
            Assert.That(pictures[1..], Is.All.EqualTo(pictures[0]), verb);
        }
        Assert.That(CliCall.Of("publish", m_one, "--single", "-o", Scratch["again.fastpoints"]).Error,
            Does.Contain("got one of a single file"));
        Assert.That(CliCall.Of("publish", m_many, "--single").Status, Is.EqualTo(ExitStatus.Usage));
    }

    [Test]
    public void Publish_SingleOfADamagedPlane_SaysWhereAndMakesNothing()
    {
        string chunk = Directory.GetFiles(Path.Combine(m_many, "chunks"))[0];
        byte[] bytes = File.ReadAllBytes(chunk);
        bytes[500] ^= 1;
        File.WriteAllBytes(chunk, bytes);
        var call = CliCall.Of("publish", m_many, "--single", "-o", m_one, "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Does.StartWith("fastpoints: " + chunk + ": ").And.Contain("a plane is damaged"));
        Assert.That(call.ErrorLines, Is.EqualTo(1));
        FileChanges.AwaitDeletes();
        Assert.That(Directory.GetDirectories(Scratch["served"]), Is.EqualTo(new[] { m_many }));
    }

    // But for what is of the files.
    static string Info(string cloud)
    {
        var call = CliCall.Of("info", cloud, "--json", "-", "--quiet");
        Assert.That(call.Status, Is.Zero, call.Error);
        string[] keys = ["points", "bounds", "attributes", "tree", "bytesOfPlane", "checksum", "sources", "sampler"];
        return string.Join("\n", keys.Select(key => "\"" + key + "\": " + call.Json.GetProperty(key).GetRawText()));
    }

    static byte[] Draw(string[] verb, string cloud, string output)
    {
        var call = CliCall.Of([.. verb, cloud, "-o", output, "--size", "160x90", "--quiet"]);
        Assert.That(call.Status, Is.Zero, call.Error);
        return Png.Read(output).Rgba;
    }
}
