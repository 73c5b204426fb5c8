namespace FastPoints.HostTests.Cluster;

/// <summary>Tasks that meet in object storage, which loses answers, breaks off and errs.</summary>
[NonParallelizable]
sealed class S3StoreTests : RemoteFixture
{
    const string Bucket = "clouds";

    S3Server m_server;
    S3Proxy m_proxy;
    ObjectStore m_store;

    [SetUp]
    public void Begin()
    {
        m_server = S3Server.Start(Scratch["s3"], Bucket);
        m_proxy = new S3Proxy(m_server.Port);
        S3Server.Use(m_proxy.Port);
        RemoteSettings.Current = new RemoteSettings();
        (S3Store.FirstPause, S3Store.IdleTime) = (TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(300));
        m_store = ObjectStore.Open("s3://" + Bucket + "/town");
    }

    [TearDown]
    public void End()
    {
        (S3Store.FirstPause, S3Store.IdleTime) = (TimeSpan.FromSeconds(0.5), TimeSpan.FromSeconds(60));
        S3Store.PieceBytes = 64 << 20;
        RemoteAccess.Sign = null;
        m_store?.Dispose();
        m_proxy?.Dispose();
        m_server?.Dispose();
    }

    string MakeFile(string name, int length)
    {
        Directory.CreateDirectory(Scratch["served"]);
        Make(name, length);
        return Path.Combine(Scratch["served"], name);
    }

    // The first time that each object is asked for by each method.
    void FailOnce(S3Fault fault, params string[] methods)
    {
        var seen = new HashSet<string>();
        m_proxy.Plan = (method, path) => methods.Contains(method) && seen.Add(method + path) ? fault : S3Fault.None;
    }

    void AssertHas(string name, string path)
    {
        using var to = new MemoryStream();
        byte[] bytes = File.ReadAllBytes(path);
        m_store.CopyRangeTo(name, 0, bytes.Length, to);
        Assert.That(to.ToArray(), Is.EqualTo(bytes));
    }

    [TestCase(nameof(S3Fault.None), 1000)]
    [TestCase(nameof(S3Fault.LostAnswer), 100_000)]
    [TestCase(nameof(S3Fault.Broken500), 100_000)]
    [TestCase(nameof(S3Fault.Busy503), 100_000)]
    [TestCase(nameof(S3Fault.WrongTag), 100_000)]
    [TestCase(nameof(S3Fault.None), 12_000_000)]
    [TestCase(nameof(S3Fault.LostAnswer), 12_000_000)]
    [TestCase(nameof(S3Fault.WrongTag), 12_000_000)]
    public void Put_ThatGoesWrongOnce_IsTriedAgain(string fault, int bytes)
    {
        S3Store.PieceBytes = 5 << 20;
        string path = MakeFile("a.bin", bytes);
        FailOnce(Enum.Parse<S3Fault>(fault), "PUT");
        m_store.Put("chunks/a b.bin", path);
        Assert.That(m_proxy.Done, fault == nameof(S3Fault.None) ? Is.Empty : Is.Not.Empty);
        m_proxy.Plan = (_, _) => S3Fault.None;
        AssertHas("chunks/a b.bin", path);
        Assert.That(m_store.List("chunks/"), Is.EqualTo(new[] { ("chunks/a b.bin", (long)bytes) }));
    }

    [TestCase(nameof(S3Fault.CutBody))]
    [TestCase(nameof(S3Fault.StalledBody))]
    [TestCase(nameof(S3Fault.LostAnswer))]
    [TestCase(nameof(S3Fault.Broken500))]
    [TestCase(nameof(S3Fault.WrongTag))]
    public void Get_ThatGoesWrongOnce_IsTriedAgain(string fault)
    {
        string path = MakeFile("a.bin", 2_000_000);
        m_store.Put("work/a.bin", path);
        FailOnce(Enum.Parse<S3Fault>(fault), "GET");
        Assert.That(File.ReadAllBytes(m_store.EnsureLocal("work/a.bin", Scratch.Root)), Is.EqualTo(File.ReadAllBytes(path)));
        Assert.That(m_proxy.Done, Is.Not.Empty);
        FailOnce(Enum.Parse<S3Fault>(fault), "GET");
        using var range = new MemoryStream();
        m_store.CopyRangeTo("work/a.bin", 1000, 1_500_000, range);
        Assert.That(range.ToArray(), Is.EqualTo(File.ReadAllBytes(path)[1000..1_501_000]));
    }

    [Test]
    public void PutAndGet_WhoseTagIsAlwaysWrong_AreRefused()
    {
        string path = MakeFile("a.bin", 1000);
        m_store.Put("a.bin", path);
        m_proxy.Plan = (_, _) => S3Fault.WrongTag;
        Assert.That(() => m_store.Put("a.bin", path), Throws.TypeOf<PointCloudException>().With.Property("Code")
            .EqualTo(FailureCode.WriteFailed));
        Assert.That(() => m_store.EnsureLocal("a.bin", Scratch.Root), Throws.TypeOf<PointCloudException>().With.Property("Code")
            .EqualTo(FailureCode.ReadFailed));
        Assert.That(m_store.ReadText("nothing"), Is.Null);
    }

    [TestCase("--cells")]
    [TestCase("--buckets")]
    public void Tasks_InAStoreThatErrs_MakeTheCloudOfOneConvert(string mode)
    {
        using var cloud = new ClusterCloud { Store = "s3://" + Bucket + "/country.fastpoints" };
        var random = new System.Random(1);
        m_proxy.Plan = (method, _) => random.Next(6) > 0 ? S3Fault.None
            : method == "PUT" ? (S3Fault)random.Next(1, 4) : (S3Fault)random.Next(2, 5);
        cloud.MakePlan("tiles", 60_000, mode);
        cloud.RunTasks();
        // What streams read is another matter.
        m_proxy.Plan = (_, _) => S3Fault.None;
        var commit = cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Done), commit.Error);
        Assert.That(m_proxy.Done.Distinct().Count(), Is.EqualTo(4));
        using var store = ObjectStore.Open(cloud.Store);
        Assert.That(store.List("work/"), Is.Empty);
        string copy = Scratch["copy"];
        foreach (string folder in new[] { "chunks", "upper" })
            Directory.CreateDirectory(Path.Combine(copy, folder));
        foreach (var (name, bytes) in store.List(""))
            using (var to = File.Create(Path.Combine(copy, name)))
                store.CopyRangeTo(name, 0, bytes, to);
        ClusterCloud.AssertSame(cloud.Whole("tiles"), copy);
        ClusterCloud.Done("picture", cloud.Store, "-o", Scratch["there.png"], "--size", "160x120", "--quiet");
        ClusterCloud.Done("picture", copy, "-o", Scratch["here.png"], "--size", "160x120", "--quiet");
        Assert.That(File.ReadAllBytes(Scratch["there.png"]), Is.EqualTo(File.ReadAllBytes(Scratch["here.png"])));
    }
}
