namespace FastPoints.HostTests.Remote;

/// <summary>Time against latency, over nginx without TLS. FASTPOINTS_FIGURES names a file for the table; then each is the
/// median of three, and lines are not one but six. Built for Release they are the figures of the page of remote clouds.</summary>
[Category("Long")]
sealed class LinkFigureTests : RemoteFixture
{
    const int Budget = 1_000_000;

    // Of ca13_d from the south a million points of its five are drawn.
    const string FromTheSouth = "0 693907 3915200 500 693907 3915870 40", LoneStar = "0 515385 4918310 2350 515385 4918360 2330",
        Lion = "0 -2 -8 2 -2 4 0";

    // Over tiles of 575 m, at 180 m/s.
    const string Eastward = "0 693700 3915876 150 693900 3915876 10\n899 696397 3915876 150 696597 3915876 10";

    static readonly string s_table = Environment.GetEnvironmentVariable("FASTPOINTS_FIGURES");

    static readonly (int RoundTripMs, double Megabits)[] s_links = s_table == null ? [(50, 100)]
        : [(20, 100), (50, 100), (150, 100), (20, 10), (50, 10), (150, 10)];

    static readonly int s_repeats = s_table == null ? 1 : 3;

    NginxServer m_nginx;
    string m_served;

    [TearDown]
    public void EndServing()
    {
        RangeExchange.CreateHandler = null;
        m_nginx?.Dispose();
    }

    void Begin()
    {
        m_served = Scratch["served"];
        m_nginx = new NginxServer(Directory.CreateDirectory(Scratch["nginx"]).FullName, m_served, "gzip off;");
        RemoteSettings.Current = new RemoteSettings { MaxConnections = 6 };
    }

    [Test]
    public void Converted_OfAMillionPoints_IsThereInTime()
    {
        Begin();
        Convert(TestData.PathOrIgnore("data/ca13_d.laz"), FromTheSouth, out CameraPath path);
        Compare("ca13.fastpoints", OneRangeANode.OfConverted(m_served, "ca13.fastpoints", path, Budget), FromTheSouth);
    }

    // 15 s over a cloud that lies along the way, over a line that brings twice as much as the way needs.
    [Test]
    public void Flight_OnAPathThatNeedsHalfTheLine_HasWhatIsSelected()
    {
        Begin();
        CliCall.Of("demo-cloud", "-o", Scratch["tiled.laz"], "--tile", TestData.PathOrIgnore("data/ca13_d.laz"), "--times",
            s_table == null ? "6" : "20", "--quiet");
        string cloud = Convert(Scratch["tiled.laz"], Eastward, out CameraPath path);
        RemoteSettings.Current = new RemoteSettings();
        var shares = new double[s_repeats];
        for (int i = 0; i < s_repeats; i++)
        {
            TimedFlight local = TimedFlight.Over(cloud, path, Budget);
            double megabits = 2 * local.ReadBytes * 8e-6 / (path.FrameCount / 60.0);
            using var link = new SlowLink(m_nginx.Port, 50, megabits);
            RemoteAccess.CacheFolder = Scratch["cache" + Guid.NewGuid()];
            StartAnew();
            TimedFlight remote = TimedFlight.Over($"http://127.0.0.1:{link.Port}/ca13.fastpoints", path, Budget);
            shares[i] = remote.FullShare;
            Say($"flight, 50 ms {megabits:0} Mbit/s: {remote}; {RemoteStatistics.Requests} requests, " +
                $"{RemoteStatistics.BytesFetched} bytes, {RemoteStatistics.BytesUnused} unused; from disk {local}");
            Assert.That(remote.GarbageAtRest, Is.EqualTo(local.GarbageAtRest));
        }
        // Others may keep the processors from a build for Debug.
        Assert.That(shares.Order().ElementAt(s_repeats / 2), Is.GreaterThanOrEqualTo(s_table == null ? 0.75 : 0.9));
    }

    // Returns where the cloud is, to be flown over along the view's path.
    string Convert(string laz, string view, out CameraPath path)
    {
        string cloud = Path.Combine(m_served, "ca13.fastpoints");
        Assert.That(CliCall.Of("convert", laz, "-o", cloud, "--quiet").Status, Is.Zero);
        File.WriteAllText(Scratch["path.txt"], view);
        path = CameraPath.Read(Scratch["path.txt"], new double3(0, 0, 1), 45);
        return cloud;
    }

    // By TLS, which HTTP/2 takes.
    [TestCase(20)]
    [TestCase(50)]
    [TestCase(150)]
    public void Converted_ByHttp2_IsThereNoLater(int roundTripMs)
    {
        Begin();
        string cloud = Convert(TestData.PathOrIgnore("data/ca13_d.laz"), FromTheSouth, out _);
        Fly(cloud, 100);
        RangeExchange.CreateHandler = m_nginx.Trusting;
        var seconds = new[] { new List<double>(), new List<double>() };
        foreach (int version in new[] { 1, 2, 1, 2, 1, 2 })
        {
            using var link = new SlowLink(version == 1 ? m_nginx.TlsPort : m_nginx.Http2Port, roundTripMs, 100);
            RemoteAccess.CacheFolder = Scratch["cache" + Guid.NewGuid()];
            StartAnew();
            JsonElement json = Fly($"https://127.0.0.1:{link.Port}/ca13.fastpoints", 100);
            seconds[version - 1].Add(json.GetProperty("secondsTo95").GetDouble());
            Say($"HTTP/{version} by TLS, {roundTripMs} ms: {json.GetProperty("secondsTo95")} s, " +
                $"{json.GetProperty("requests")} requests, {json.GetProperty("bytesFetched")} bytes, " +
                $"{link.Connections} connections");
            Assert.That(link.Connections, version == 1 ? Is.LessThanOrEqualTo(6) : Is.EqualTo(1));
        }
        // The middle ones: one run may meet a busy machine, another an idle one.
        double[] middle = Array.ConvertAll(seconds, s => s.Order().ElementAt(1));
        Assert.That(middle[1], Is.LessThan(1.2 * middle[0]));
    }

    [Test]
    public void Copc_AsItIs_IsThereInTime()
    {
        Begin();
        File.Copy(TestData.SampleOrIgnore("copc/lone-star.copc.laz"), Path.Combine(m_served, "lone-star.copc.laz"));
        Compare("lone-star.copc.laz", OneRangeANode.OfCopc(m_served, "lone-star.copc.laz"), LoneStar);
    }

    [TestCase("lone-star-laszip", LoneStar)]
    [TestCase("lion_takanawa_ept_bin", Lion)]
    public void Ept_AsItIs_IsThereInTime(string name, string view)
    {
        Begin();
        string from = Path.GetDirectoryName(TestData.SampleOrIgnore($"ept/{name}/ept.json"));
        foreach (string file in Directory.GetFiles(from, "*", SearchOption.AllDirectories))
        {
            string to = Path.Combine(m_served, name, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(to));
            File.Copy(file, to);
        }
        Compare(name + "/ept.json", OneRangeANode.OfEpt(m_served, name), view);
    }

    void Compare(string target, OneRangeANode policy, string view)
    {
        File.WriteAllText(Scratch["path.txt"], view + "\n");
        // Compiles all that it takes.
        JsonElement local = Fly(Path.Combine(m_served, target), 100);
        long points = local.GetProperty("pointsDrawn").GetInt64() * 95 / 100;
        Say($"{target}: {local.GetProperty("pointsDrawn")} points in {local.GetProperty("nodesDrawn")} nodes, from disk " +
            $"{local.GetProperty("secondsTo95").GetDouble():0.00} s, processors {Environment.ProcessorCount}");
        foreach ((int roundTripMs, double megabits) in s_links)
        {
            var runs = new List<(double Seconds, JsonElement Json)>();
            var policies = new List<double>();
            for (int i = 0; i < s_repeats; i++)
            {
                using (var link = new SlowLink(m_nginx.Port, roundTripMs, megabits))
                {
                    RemoteAccess.CacheFolder = Scratch["cache" + Guid.NewGuid()];
                    StartAnew();
                    JsonElement json = Fly($"http://127.0.0.1:{link.Port}/{target}", megabits);
                    Assert.That(link.Connections, Is.LessThanOrEqualTo(6));
                    runs.Add((json.GetProperty("secondsTo95").GetDouble(), json));
                }
                using (var link = new SlowLink(m_nginx.Port, roundTripMs, megabits))
                    policies.Add(policy.Seconds($"http://127.0.0.1:{link.Port}", points));
            }
            (double seconds, JsonElement median) = runs.OrderBy(r => r.Seconds).ElementAt(s_repeats / 2);
            double ofPolicy = policies.Order().ElementAt(s_repeats / 2);
            long Number(string key) => median.GetProperty(key).GetInt64();
            Say($"  {roundTripMs,3} ms {megabits,3} Mbit/s: {seconds:0.00} s, {Number("requests")} requests, " +
                $"{Number("bytesFetched")} bytes, {100.0 * Number("bytesUnused") / Number("bytesFetched"):0.0} % unused; " +
                $"a range a node {ofPolicy:0.00} s, {policy.Requests} requests; {seconds / ofPolicy:0.00} of it");
            // The last ones may still be on their way.
            Assert.That(Number("pointsDrawn"), Is.InRange(points, local.GetProperty("pointsDrawn").GetInt64()));
        }
    }

    JsonElement Fly(string target, double megabits)
    {
        int frames = megabits < 50 ? 900 : 240;
        var call = CliCall.Of("fly", target, "--frames", frames.ToString(), "--path", Scratch["path.txt"], "--budget",
            Budget.ToString(), "--fade", "0", "--json", "-", "--quiet");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        return call.Json;
    }

    static void Say(string line)
    {
        TestContext.Out.WriteLine(line);
        if (s_table != null)
            File.AppendAllText(s_table, line + "\n");
    }
}
