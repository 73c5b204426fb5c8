namespace FastPoints.HostTests.Remote;

sealed class NginxTests : RemoteFixture
{
    NginxServer m_nginx;

    void Begin(string more = "")
    {
        m_nginx = new NginxServer(Directory.CreateDirectory(Scratch["nginx"]).FullName, Scratch["served"], more);
        RemoteSettings.Current.StallMs = 5000;
        RangeExchange.CreateHandler = m_nginx.Trusting;
        StartAnew();
    }

    [TearDown]
    public void End()
    {
        (RangeExchange.CreateHandler, RangeExchange.HttpVersion) = (null, HttpVersion.Version11);
        m_nginx?.Dispose();
        m_nginx = null;
    }

    [Test]
    public void Reads_ByTls_AreTheFilesBytesAndOneRequestTheSecondTime()
    {
        byte[] bytes = Make("a b.las", 3_000_000);
        Begin();
        string address = $"https://127.0.0.1:{m_nginx.TlsPort}/a%20b.las";

        Assert.That(Read(RemoteFile.Open(address), 0, 3_000_000).AsSpan().SequenceEqual(bytes));
        int requests = m_nginx.AccessLog.Length;
        StartAnew();
        byte[] part = Read(RemoteFile.Open(address), 1_000_000, 1_000_000);
        Assert.That(part.AsSpan().SequenceEqual(bytes.AsSpan(1_000_000, 1_000_000)));

        Assert.That(m_nginx.AccessLog, Has.Length.EqualTo(requests + 1));
        Assert.That(m_nginx.AccessLog.Take(requests), Has.All.Contains(" 206 "));
        AssertOneLine(Try(() => RemoteFile.Open(address + "x")), address + "x");
    }

    [TestCase("copc/lone-star.copc.laz", "lone-star.copc.laz")]
    [TestCase("ept/lone-star-laszip/ept.json", "lone-star-laszip/ept.json")]
    [TestCase("potree/v2-autzen-brotli/metadata.json", "v2-autzen-brotli/metadata.json")]
    public void Picture_ByTls_HasThePixelsOfTheDisk(string sample, string target)
    {
        string from = Path.GetDirectoryName(TestData.SampleOrIgnore(sample));
        Directory.Delete(Scratch["served"]);
        Directory.CreateSymbolicLink(Scratch["served"], target.Contains('/') ? Path.GetDirectoryName(from) : from);
        Begin();

        byte[] Picture(string path)
        {
            var call = CliCall.Of("picture", path, "-o", Scratch["picture.png"], "--size", "320x200", "--force", "--plain",
                "--quiet");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            return File.ReadAllBytes(Scratch["picture.png"]);
        }
        byte[] wanted = Picture(Scratch["served/" + target]);
        RemoteStatistics.Reset();
        Assert.That(Picture($"https://127.0.0.1:{m_nginx.TlsPort}/{target}").AsSpan().SequenceEqual(wanted));
        Assert.That(RemoteStatistics.Requests, Is.Positive);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    // The command line asks for HTTP/2 where a server has it; the package never does.
    [Test]
    public void Export_ByHttp2_TakesOneConnectionAndGivesTheSame()
    {
        string local = Scratch.Converted("served/scan.fastpoints", 300_000);
        Begin();
        string Export(string cloud)
        {
            StartAnew();
            var call = CliCall.Of("export", cloud, "-o", Scratch["out.las"], "--force", "--quiet");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            return Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(Scratch["out.las"])));
        }
        string wanted = Export(local);
        using (var link = new SlowLink(m_nginx.Http2Port, 1, 1000))
        {
            Assert.That(Export($"https://127.0.0.1:{link.Port}/scan.fastpoints"), Is.EqualTo(wanted));
            Assert.That(link.Connections, Is.EqualTo(1));
        }
        Assert.That(m_nginx.AccessLog, Has.All.Contains(" HTTP/2.0\" 206 "));
        RemoteAccess.CacheFolder = Scratch["another cache"];
        int requests = m_nginx.AccessLog.Length;
        Assert.That(Export($"https://127.0.0.1:{m_nginx.TlsPort}/scan.fastpoints"), Is.EqualTo(wanted));
        Assert.That(m_nginx.AccessLog.Skip(requests), Has.All.Contains(" HTTP/1.1\" 206 "));
    }

    [Test]
    public void Open_OfAServerWithHttp2_AsksByHttp1()
    {
        Make("a.las", 100_000);
        Begin();
        RemoteFile.Open($"https://127.0.0.1:{m_nginx.Http2Port}/a.las");
        Assert.That(m_nginx.AccessLog, Has.All.Contains(" HTTP/1.1\" 206 "));
    }

    [Test]
    public void Open_ByACertificateThatNobodyTrusts_FailsInOneLine()
    {
        Make("a.las", 100_000);
        Begin();
        RangeExchange.CreateHandler = null;
        CloseClient();
        string address = $"https://127.0.0.1:{m_nginx.TlsPort}/a.las" + Secret;

        Exception failure = Try(() => RemoteFile.Open(address));

        AssertOneLine(failure, address);
        Assert.That(failure.Message, Does.Contain("certificate").IgnoreCase);
        Assert.That(m_nginx.AccessLog, Is.Empty);
    }

    [Test]
    public void Read_OfAServerThatCompresses_AsksItNotTo()
    {
        byte[] bytes = Encoding.ASCII.GetBytes(string.Concat(Enumerable.Repeat("1 2 3\n", 50_000)));
        File.WriteAllBytes(Scratch["served/a.txt"], bytes);
        Begin("gzip on; gzip_min_length 1; gzip_types *;");
        string address = $"http://127.0.0.1:{m_nginx.Port}/a.txt";
        using var client = new HttpClient();
        client.DefaultRequestHeaders.TryAddWithoutValidation("Accept-Encoding", "gzip");
        Assert.That(client.GetAsync(address).Result.Content.Headers.ContentEncoding, Is.EqualTo(new[] { "gzip" }));

        Assert.That(Read(RemoteFile.Open(address), 100_000, 100_000).AsSpan().SequenceEqual(bytes.AsSpan(100_000, 100_000)));
    }

    [Test]
    public void Reads_OfAServerThatRefusesMany_ComeAllTheSame()
    {
        byte[] bytes = Make("a.las", 8_000_000);
        Begin("limit_req_zone $host zone=all:1m rate=20r/s; limit_req zone=all burst=1 nodelay; limit_req_status 429;");
        (RemoteSettings.Current.RetryMs, RemoteSettings.Current.MaxTries) = (100, 6);
        var file = RemoteFile.Open($"http://127.0.0.1:{m_nginx.Port}/a.las");

        Assert.That(Read(file, 0, bytes.Length).AsSpan().SequenceEqual(bytes));

        Assert.That(m_nginx.AccessLog, Has.Some.Contains(" 429 "));
    }

    // 40 ranges with gaps between that no request may span, 3 MB: in what the line takes for them, and a few round trips.
    [TestCase(50, 100, true)]
    [TestCase(150, 100, true)]
    [TestCase(150, 100, false)]
    [TestCase(20, 10, true, Category = "Long")]
    [TestCase(20, 100, true, Category = "Long")]
    [TestCase(50, 10, true, Category = "Long")]
    [TestCase(150, 10, true, Category = "Long")]
    public void Reads_OverALink_TakeItsTimeAndFewRoundTrips(int roundTripMs, int megabits, bool isTls)
    {
        const int Ranges = 40, Bytes = 75_000, Apart = 1_300_000;
        byte[] bytes = Make("a.las", Ranges * Apart);
        Begin();
        using var link = new SlowLink(isTls ? m_nginx.TlsPort : m_nginx.Port, roundTripMs, megabits);
        var watch = Stopwatch.StartNew();
        var file = RemoteFile.Open($"{(isTls ? "https" : "http")}://127.0.0.1:{link.Port}/a.las");
        double opened = watch.Elapsed.TotalSeconds;
        RemoteRead[] reads = Enumerable.Range(0, Ranges).Select(i => file.Begin((long)Apart * i + 100_000, Bytes, i)).ToArray();
        foreach (RemoteRead read in reads)
            read.Await();
        double seconds = watch.Elapsed.TotalSeconds - opened;

        double wire = Ranges * Bytes / link.BytesPerSecond, trips = roundTripMs / 1000.0;
        TestContext.Out.WriteLine($"{roundTripMs} ms, {megabits} Mbit/s{(isTls ? ", TLS" : "")}: open {opened:0.000} s, " +
            $"40 ranges {seconds:0.000} s, on the wire {wire:0.000} s; {link.Connections} connections, {link.Bytes} bytes");
        for (int i = 0; i < Ranges; i++)
            using (reads[i])
                AssertSame(reads[i], bytes.AsSpan(Apart * i + 100_000, Bytes));
        Assert.That(link.Connections, Is.LessThanOrEqualTo(8));
        // Five rounds of eight, the first with new connections of two or three trips before; the rest is for busy machines.
        Assert.That(seconds, Is.LessThan(1.2 * wire + (Ranges / 8 + 3) * trips + 1.5));
    }

    static unsafe void AssertSame(RemoteRead read, ReadOnlySpan<byte> bytes) =>
        Assert.That(new ReadOnlySpan<byte>(read.Data, bytes.Length).SequenceEqual(bytes));
}
