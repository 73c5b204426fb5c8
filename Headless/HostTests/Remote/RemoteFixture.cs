namespace FastPoints.HostTests.Remote;

// A folder that is served, with short waits, a cache that is empty and nothing left of other tests.
abstract class RemoteFixture
{
    protected const string Secret = "?token=secret";

    protected ScratchFolder Scratch { get; private set; }
    protected RangeServer Server { get; private set; }

    [SetUp]
    public void Serve()
    {
        Scratch = new ScratchFolder();
        Directory.CreateDirectory(Scratch["served"]);
        RemoteSettings.Current = new RemoteSettings
        {
            StallMs = 400,
            MaxTries = 3,
            RetryMs = 2,
            MaxRetryAfterMs = 20,
            MinBytesPerSecond = 4096,
            ConfirmedMs = 0,
        };
        RemoteAccess.CacheFolder = Scratch["cache"];
        RemoteAccess.CacheBytes = 64 << 20;
        Server = new RangeServer(Scratch["served"]);
        StartAnew();
    }

    [TearDown]
    public void Stop()
    {
        StartAnew();
        Server.Dispose();
        Scratch.Dispose();
        RemoteSettings.Current = new RemoteSettings();
        RemoteFile.MaxSmallFileBytes = 32 << 20;
        RemoteAccess.CacheFolder = null;
        RemoteAccess.CacheBytes = 4L << 30;
    }

    // As another process would, that begins now.
    protected void StartAnew()
    {
        AwaitCache();
        HttpFile.Forget();
        CloseClient();
        RemoteStatistics.Reset();
        (string folder, RemoteAccess.CacheFolder) = (RemoteAccess.CacheFolder, Scratch["no cache"]);
        _ = RangeCache.Current; // Closes the one before.
        RemoteAccess.CacheFolder = folder;
    }

    protected static void CloseClient() => Interlocked.Exchange(ref RangeExchange.s_client, null)?.Dispose();

    // Who reads does not wait until what came is in the cache.
    protected static void AwaitCache() => SpinWait.SpinUntil(() => RangeQueue.InFlight == 0, 10_000);

    // Of any format that can be exported.
    protected string Demo(string name, int points)
    {
        string las = Scratch.Demo("served/" + name[..name.IndexOf('.')] + ".las", points);
        string made = Scratch["served/" + name];
        if (made != las)
            Assert.That(CliCall.Of("export", las, "-o", made, "--quiet").Status, Is.Zero);
        return made;
    }

    // Returns the file's bytes.
    protected byte[] Make(string name, int length, int seed = 1)
    {
        byte[] bytes = new byte[length];
        new System.Random(seed).NextBytes(bytes);
        File.WriteAllBytes(Scratch["served/" + name], bytes);
        return bytes;
    }

    protected static byte[] Read(RemoteFile file, long offset, int count)
    {
        byte[] bytes = new byte[count];
        file.Read(offset, bytes);
        return bytes;
    }

    // Null, or what it fails with.
    protected static Exception Try(Action action)
    {
        try
        {
            action();
            return null;
        }
        catch (Exception e)
        {
            return e;
        }
    }

    protected static void AssertOneLine(Exception failure, string address)
    {
        string path = address.Split('?')[0];
        Assert.That(failure, Is.TypeOf<PointCloudException>(), failure.ToString());
        var exception = (PointCloudException)failure;
        Assert.That(exception.Code, Is.Not.EqualTo(FailureCode.Unexpected), exception.FullMessage);
        Assert.That(exception.Path, Is.EqualTo(path));
        Assert.That(exception.ToString(), Does.Not.Contain("secret"));
        Assert.That(exception.Message, Does.StartWith(path + ": ").And.Not.Contain("\n"));
    }

    protected static void AssertWithin(double seconds, Action action)
    {
        var watch = Stopwatch.StartNew();
        action();
        Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(seconds));
    }
}
