namespace FastPoints.HostTests.Remote;

/// <summary>Verbs of addresses: the summaries, pictures and files that those of the disk give, without waiting.</summary>
[NonParallelizable]
sealed class RemoteVerbTests : RemoteFixture
{
    // Of the machine, or of where the source is.
    static readonly string[] s_volatile =
    [
        "seconds", "stages", "peakResidentBytes", "inputs", "input", "requests", "bytesFetched", "bytesUnused", "cacheHits",
        "waves", "sliceMs", "temporaryBytesPeak", "pointsPerSecond", "bytesRead",
    ];

    [SetUp]
    public void Trust() => RemoteSettings.Current = new RemoteSettings { ConfirmedMs = 60_000 };

    CliCall Call(params string[] args)
    {
        var call = CliCall.Of([.. args, "--json", "-", "--quiet"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Output + call.Error, Does.Not.Contain("secret"));
        return call;
    }

    static string[] Lasting(JsonElement json) => json.EnumerateObject().Where(p => !s_volatile.Contains(p.Name)
        && p.Name != "files").Select(p => p.Name + ": " + p.Value).ToArray();

    void AssertSame(CliCall remote, CliCall local)
    {
        var lasting = Lasting(remote.Json).Select(value => value.Replace(Server.Address, Scratch["served"]));
        Assert.That(lasting, Is.EqualTo(Lasting(local.Json)));
        Assert.That(remote.Json.GetProperty("requests").GetInt64(), Is.EqualTo(Server.Requests.Count));
        Assert.That(remote.Json.GetProperty("bytesFetched").GetInt64(), Is.Positive);
        Assert.That(remote.Json.GetProperty("inputs")[0].GetString(), Does.StartWith("http://127.0.0.1:"));
        Assert.That(local.Json.TryGetProperty("requests", out _), Is.False);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    [TestCase("scan.las", "info")]
    [TestCase("scan.laz", "info --scan")]
    [TestCase("scan.copc.laz", "info --scan")]
    [TestCase("scan.ply", "info --scan")]
    public void Info_ByAddress_SaysWhatItSaysOfTheDisk(string name, string verb)
    {
        string path = Demo(name, 30_000);
        var local = Call([.. verb.Split(' '), path]);
        StartAnew();
        AssertSame(Call([.. verb.Split(' '), Server.Of(name) + Secret]), local);
    }

    [TestCase("scan.las", "preview")]
    [TestCase("scan.laz", "preview")]
    [TestCase("scan.las", "picture")]
    [TestCase("scan.copc.laz", "picture")]
    [TestCase("scan.copc.laz", "picture --budget 5000")]
    public void Picture_ByAddress_HasThePixelsOfTheDisk(string name, string verb)
    {
        string path = Demo(name, 30_000), here = Scratch["here.png"], there = Scratch["there.png"];
        var local = Call([.. verb.Split(' '), path, "--size", "160x120", "-o", here]);
        StartAnew();
        AssertSame(Call([.. verb.Split(' '), Server.Of(name) + Secret, "--size", "160x120", "-o", there]), local);
        Assert.That(File.ReadAllBytes(there), Is.EqualTo(File.ReadAllBytes(here)));
    }

    [TestCase("scan.las")]
    [TestCase("scan.copc.laz")]
    public void Convert_ByAddress_MakesTheSameCloud(string name)
    {
        string path = Demo(name, 60_000), here = Scratch["here.fastpoints"], there = Scratch["there.fastpoints"];
        var local = Call("convert", path, "-o", here);
        StartAnew();
        AssertSame(Call("convert", Server.Of(name) + Secret, "-o", there), local);
        foreach (string file in Directory.GetFiles(here, "*", SearchOption.AllDirectories))
            Assert.That(File.ReadAllBytes(Path.Combine(there, Path.GetRelativePath(here, file))),
                Is.EqualTo(File.ReadAllBytes(file)), file);
        Assert.That(Call("verify", there, "--against", Server.Of(name) + Secret).Json.GetProperty("ok").GetBoolean(), Is.True);
    }

    [TestCase("scan.laz", "there.ply")]
    [TestCase("scan.copc.laz", "there.las")]
    public void Export_ByAddress_WritesTheSameFile(string name, string to)
    {
        string path = Demo(name, 30_000);
        var local = Call("export", path, "-o", Scratch["here" + Path.GetExtension(to)]);
        StartAnew();
        AssertSame(Call("export", Server.Of(name) + Secret, "-o", Scratch[to]), local);
        Assert.That(File.ReadAllBytes(Scratch[to]), Is.EqualTo(File.ReadAllBytes(Scratch["here" + Path.GetExtension(to)])));
    }

    [Test]
    public void Export_OfAConvertedCloudByAddress_WritesTheSameFile()
    {
        string cloud = Scratch.Converted("served/scan.fastpoints", 30_000);
        var local = Call("export", cloud, "-o", Scratch["here.las"]);
        StartAnew();
        AssertSame(Call("export", Server.Of("scan.fastpoints") + Secret, "-o", Scratch["there.las"]), local);
        Assert.That(File.ReadAllBytes(Scratch["there.las"]), Is.EqualTo(File.ReadAllBytes(Scratch["here.las"])));
    }

    [Test]
    public void Info_OfWhatIsNotThere_IsBadInputInOneLine()
    {
        var call = CliCall.Of("info", Server.Of("no.las") + Secret, "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.BadInput));
        Assert.That(call.Error, Is.EqualTo("fastpoints: " + Server.Of("no.las") + ": the server answered 404: no such file\n"));
    }

    [TestCase("convert", "there.fastpoints")]
    [TestCase("export", "there.las")]
    [TestCase("picture", "there.png")]
    [TestCase("fly", "there")]
    [TestCase("demo-cloud", "there.las")]
    public void Output_ToAnAddress_IsAUsageErrorBeforeAnyWork(string verb, string name)
    {
        string[] source = verb == "demo-cloud" ? [] : [Demo("scan.las", 1000)];
        var call = CliCall.Of([verb, .. source, "-o", Server.Of(name) + Secret, "--quiet"]);
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Usage), call.Error);
        Assert.That(call.Error, Does.Contain("nothing is written to servers").And.Not.Contain("secret"));
        Assert.That(Directory.Exists("http:"), Is.False);
    }

    [Test]
    public void Info_ByHttpOfAnotherMachine_WantsPermission()
    {
        var call = CliCall.Of("info", "http://clouds.invalid/scan.las", "--quiet");
        Assert.That(call.Status, Is.Not.Zero);
        Assert.That(call.Error, Does.Contain("--allow-http"));
        Assert.That(CliCall.Of("info", "http://clouds.invalid/scan.las", "--allow-http", "--quiet").Error,
            Does.Not.Contain("--allow-http"));
        RemoteAccess.AllowsHttp = false;
    }

    [Test]
    public void Report_ByAddress_IsNamedByItsFile()
    {
        Demo("scan.laz", 5000);
        string folder = Scratch["report"];
        Call(Server.Of("scan.laz") + Secret, "-o", folder);
        Assert.That(Directory.Exists(Path.Combine(folder, "scan.fastpoints")), Is.True);
        foreach (string file in Directory.GetFiles(folder, "*", SearchOption.AllDirectories))
            Assert.That(File.ReadAllText(file), Does.Not.Contain("token=secret"), file);
        // Again: of the same source.
        Call(Server.Of("scan.laz") + Secret, "-o", folder);
    }

    [Test]
    public void Cache_Clear_EmptiesIt()
    {
        Demo("scan.laz", 30_000);
        Call("info", "--scan", Server.Of("scan.laz"));
        Assert.That(Call("cache").Json.GetProperty("entries").GetInt64(), Is.Positive);
        Call("cache", "--clear");
        Assert.That(Call("cache").Json.GetProperty("bytes").GetInt64(), Is.Zero);
    }
}
