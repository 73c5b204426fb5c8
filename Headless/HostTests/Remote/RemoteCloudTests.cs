namespace FastPoints.HostTests.Remote;

/// <summary>Converted clouds of a web server, streamed frame by frame.</summary>
[NonParallelizable]
public sealed class RemoteCloudTests : ScratchTests
{
    const int Points = 60_000;

    string m_cloud, m_other;
    string m_served;
    RangeServer m_server;
    long m_cacheBytes;

    [OneTimeSetUp]
    public void MakeClouds()
    {
        m_cloud = Convert("scan.fastpoints", Points);
        m_other = Convert("other.fastpoints", Points / 2);
    }

    string Convert(string name, int points)
    {
        var settings = new ConvertSettings { PointsPerChunk = 6000, CellsLog2 = 4, TargetPointsPerLeaf = 500 };
        using var reader = PointReaders.Open(Scratch.Demo(name + ".las", points));
        JobCoroutine.RunToEnd(ConvertCloud.Run([reader], Scratch[name], settings, _ => { }, null));
        return Scratch[name];
    }

    [SetUp]
    public void Serve()
    {
        m_cacheBytes = RemoteAccess.CacheBytes;
        RemoteAccess.CacheBytes = 0;
        m_served = Directory.CreateDirectory(Scratch[TestContext.CurrentContext.Test.Name]).FullName;
        Put(m_cloud);
        m_server = new RangeServer(m_served);
        RemoteStatistics.Reset();
    }

    [TearDown]
    public void EndServing()
    {
        CloudFolder.TailBytes = 1 << 18;
        m_server.Dispose();
        RemoteAccess.CacheBytes = m_cacheBytes;
        HttpFile.Forget();
    }

    string Address => m_server.Of("scan.fastpoints");

    void Put(string cloud)
    {
        foreach (string file in Directory.GetFiles(cloud, "*", SearchOption.AllDirectories))
        {
            string to = Path.Combine(m_served, "scan.fastpoints", Path.GetRelativePath(cloud, file));
            Directory.CreateDirectory(Path.GetDirectoryName(to));
            File.Copy(file, to, true);
            File.SetLastWriteTimeUtc(to, DateTime.UtcNow);
        }
    }

    static StreamContext Stream()
    {
        var stream = new StreamContext(new MemoryNodePool(64 << 20, 1 << 20));
        stream.Settings.Selection.MinScreenErrorPx = 0.05f;
        stream.Settings.FramesToRetry = 3;
        return stream;
    }

    static FolderSource Source(string path) => new(CloudFolder.Open(path), StoreLayout.ColorName);

    static int Add(StreamContext stream, FolderSource source) =>
        stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));

    internal static FrameStats Frame(StreamContext stream, double scalePx = 1000)
    {
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent) { [0] = StreamView.Everything(scalePx) };
        return FrameStep.Run(stream, views);
    }

    static FrameStats Until(StreamContext stream, Func<FrameStats, bool> isThere, string what, double scalePx = 1000)
    {
        for (int frame = 0; frame < 20_000; frame++)
        {
            var stats = Frame(stream, scalePx);
            if (isThere(stats))
                return stats;
            Thread.Sleep(1);
        }
        Assert.Fail(what);
        return default;
    }

    static FrameStats Settle(StreamContext stream) => Until(stream, s => s.IsSettled, "it does not come to rest");

    // What is drawn of each node, by its page and number.
    static unsafe Dictionary<(int, int), ulong> Drawn(StreamContext stream, int cloud)
    {
        var drawn = new Dictionary<(int, int), ulong>();
        foreach (var node in stream.Drawn.AsArray())
            if (node.Cloud == cloud)
                drawn.Add((node.Page, node.Node), ContentHash.Of(((MemoryNodePool)stream.Pool).AddressOf(node.Range),
                    stream.Clouds[cloud].BytesOf(node.Page, node.Node)));
        return drawn;
    }

    static Dictionary<(int, int), ulong> DrawnOf(string path)
    {
        using var stream = Stream();
        int cloud = Add(stream, Source(path));
        Settle(stream);
        return Drawn(stream, cloud);
    }

    static List<string> Failures(StreamContext stream)
    {
        var failures = new List<string>();
        while (stream.TryTakeFailure(out var failure))
            failures.Add(failure.ToString());
        return failures;
    }

    [Test]
    public void Open_AnAddress_TakesARequestForEachOfTwoFiles()
    {
        using var folder = CloudFolder.Open(Address + "?sig=secret");
        using var local = CloudFolder.Open(m_cloud);
        Assert.That(folder.Root.Nodes.ToArray(), Is.EqualTo(local.Root.Nodes.ToArray()));
        Assert.That(folder.PageCount, Is.EqualTo(local.PageCount).And.GreaterThan(4));
        Assert.That(m_server.Requests.Select(r => r.Target), Is.EqualTo(new[]
        {
            "/scan.fastpoints/cloud.json?sig=secret", "/scan.fastpoints/hierarchy.bin?sig=secret",
        }));
    }

    [Test]
    public void Open_WhatIsNotThere_SaysSoWithoutTheQuery()
    {
        var failure = Assert.Throws<PointCloudException>(() => CloudFolder.Open(m_server.Of("no.fastpoints?sig=secret")));
        Assert.That(failure.Code, Is.EqualTo(FailureCode.NotFound));
        Assert.That(failure.Path, Is.EqualTo(m_server.Of("no.fastpoints/cloud.json")));
        File.WriteAllText(Path.Combine(m_served, "scan.fastpoints", StoreFormat.ManifestName), "{}");
        failure = Assert.Throws<PointCloudException>(() => CloudFolder.Open(Address + "?sig=secret"));
        Assert.That(failure.Code, Is.EqualTo(FailureCode.BadInput));
        Assert.That(failure.ToString(), Does.Not.Contain("secret"));
    }

    [TestCase(0), TestCase(1 << 12), TestCase(1 << 18)]
    public void LoadPage_OfAnAddress_IsThatOfTheDiskByFewRequests(int tailBytes)
    {
        CloudFolder.TailBytes = tailBytes;
        using var folder = CloudFolder.Open(Address);
        using var local = CloudFolder.Open(m_cloud);
        m_server.ResetCounts();
        // So that gaps are worth it.
        m_server.LatencyMs = 20;
        for (int page = 1; page < folder.PageCount; page++)
        {
            folder.FetchFrom(page);
            using var table = folder.LoadPage(page);
            using var wanted = local.LoadPage(page);
            Assert.That(table.Nodes.ToArray(), Is.EqualTo(wanted.Nodes.ToArray()));
            Assert.That(table.PlaneRanges.ToArray(), Is.EqualTo(wanted.PlaneRanges.ToArray()));
        }
        Assert.That(m_server.Requests.Count, Is.LessThan(folder.PageCount / 2));
        Assert.That(m_server.Requests.Count, tailBytes == 1 << 18 ? Is.Zero : Is.Positive, "all come with the root's");
    }

    [Test]
    public void Run_AnAddress_DrawsTheNodesAndBytesOfTheDisk()
    {
        UnsafeUtility.ForgiveLeaks();
        var drawn = DrawnOf(Address);
        Assert.That(drawn, Is.EquivalentTo(DrawnOf(m_cloud)));
        Assert.That(drawn.Count, Is.GreaterThan(20));
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    [Test]
    public void Run_AgainWithoutTheServer_DrawsTheSame()
    {
        RemoteAccess.CacheFolder = Scratch["cache"];
        RemoteAccess.CacheBytes = 64 << 20;
        try
        {
            var drawn = DrawnOf(Address);
            HttpFile.Forget();
            m_server.Dispose();
            Assert.That(DrawnOf(Address), Is.EquivalentTo(drawn));
        }
        finally
        {
            RemoteAccess.CacheFolder = null;
        }
    }

    [Test]
    public void Run_TowardsACloud_FetchesTablesBeforeItsChunksAreSelected()
    {
        m_server.LatencyMs = 40;
        CloudFolder.TailBytes = 0;
        using var stream = Stream();
        stream.Settings.Selection.MinScreenErrorPx = 0.1f;
        stream.FrameSeconds = 1 / 60f;
        var source = Source(Address);
        Add(stream, source);
        // What is asked for stays so.
        m_server.Gate = new TaskCompletionSource().Task;
        var bounds = source.Folder.Manifest.BoundsGeo;
        using var views = new NativeArray<StreamView>(1, Allocator.Persistent);
        var view = views;
        for (int frame = 0; frame < 4; frame++)
        {
            var eye = (bounds.Min + bounds.Max) / 2 + new double3(0, 0, 60_000 - 1900 * frame);
            view[0] = StreamView.Perspective(eye, new double3(1, 0, 0), new double3(0, 1, 0), new double3(0, 0, -1), 1,
                new double2(640, 360));
            FrameStep.Run(stream, views);
            Assert.That(stream.Selector.Missing.Length, Is.Zero, "too near");
        }
        Assert.That(stream.FramesToPredict, Is.GreaterThan(stream.Settings.PrefetchFrames + 3), "two round trips of 40 ms");
        Assert.That(stream.Reads.Fetches.Count(f => f.Phase == FetchPhase.Reading && f.IsTable), Is.GreaterThan(1));
    }

    [Test]
    public void Dispose_WhileReadsAreInFlight_FreesAllAtOnce()
    {
        m_server.LatencyMs = 300;
        UnsafeUtility.ForgiveLeaks();
        var stream = Stream();
        Add(stream, Source(Address));
        Until(stream, s => s.ReadsInFlight > 3, "no reads");
        var watch = System.Diagnostics.Stopwatch.StartNew();
        stream.Dispose();
        Assert.That(watch.ElapsedMilliseconds, Is.LessThan(200), "it waits for the server");
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
    }

    [Test]
    public void Run_WhatLeavesTheView_IsCancelled()
    {
        using var stream = Stream();
        Add(stream, Source(Address));
        // No answer comes meanwhile.
        var gate = new TaskCompletionSource();
        m_server.Gate = gate.Task;
        Until(stream, s => s.ReadsInFlight > 3, "no reads");
        // Nothing but the root is that large.
        Until(stream, s => s.ReadsInFlight <= 1, "reads of nodes that nobody sees go on", 1e-9);
        gate.SetResult();
        Settle(stream);
        Assert.That(Drawn(stream, 0), Is.EquivalentTo(DrawnOf(m_cloud)));
    }

    [Test]
    public void Run_WithoutAServerForAWhile_SaysSoOnceAndGoesOn()
    {
        using var folder = CloudFolder.Open(m_cloud);
        _ = folder.EachTable().Count();
        string[] away = folder.Files().Select(f => f.Path).Where(p => p.Contains(StoreFormat.ChunkFolderName))
            .Select(p => Path.Combine(m_served, "scan.fastpoints", Path.GetRelativePath(m_cloud, p))).ToArray();
        foreach (string file in away)
            File.Move(file, file + ".away");
        using var stream = Stream();
        Add(stream, Source(Address));
        var failures = new List<string>();
        Until(stream, s =>
        {
            failures.AddRange(Failures(stream));
            return failures.Count == away.Length;
        }, "not all failures are reported");
        Assert.That(failures, Is.All.Contains("404"));
        foreach (string file in away)
            File.Move(file + ".away", file);
        Settle(stream);
        Assert.That(Failures(stream), Is.Empty);
        Assert.That(Drawn(stream, 0), Is.EquivalentTo(DrawnOf(m_cloud)));
    }

    [Test]
    public void Update_OfACloudThatIsReplacedOnTheServer_ShowsTheOtherAndNothingMixed()
    {
        using var stream = Stream();
        using var feed = CloudFeeds.Open(Address);
        var versions = new CloudVersions(stream);
        versions.Add(feed.Take(StoreLayout.ColorName));
        // Only what is still to come can be missed.
        long budget = stream.Settings.Selection.PointBudget;
        stream.Settings.Selection.PointBudget = Points / 10;
        Settle(stream);
        Put(m_other);
        stream.Settings.Selection.PointBudget = budget;
        var wanted = DrawnOf(m_other);
        int first = versions.ShownNumber;
        Until(stream, _ =>
        {
            feed.Update(1);
            if (feed.Newest != null)
                versions.Add(feed.Take(StoreLayout.ColorName));
            versions.Update();
            return versions.ShownNumber != first;
        }, "the cloud is not opened again");
        Settle(stream);
        Assert.That(Drawn(stream, versions.ShownNumber), Is.EquivalentTo(wanted));
    }

    [Test]
    public void Run_WrongBytes_AreNeverDrawn()
    {
        using (var folder = CloudFolder.Open(m_cloud))
        {
            string path = Path.Combine(m_served, "scan.fastpoints", Path.GetRelativePath(m_cloud, folder.PlanesPathOf(0)));
            byte[] bytes = File.ReadAllBytes(path);
            var range = folder.Root.PlaneRanges[0];
            bytes[range.OffsetBytes + range.LengthBytes / 2] ^= 1;
            File.WriteAllBytes(path, bytes);
        }
        using var stream = Stream();
        int cloud = Add(stream, Source(Address));
        Settle(stream);
        Assert.That(Failures(stream), Has.One.EndsWith("node 0 is damaged"));
        Assert.That(Drawn(stream, cloud).Keys, Has.None.EqualTo((0, 0)));
    }

    [Test]
    public void Run_Idle_MakesNoGarbage()
    {
        using var views = new NativeArray<StreamView>([StreamView.Everything(1000)], Allocator.Persistent);
        long Garbage(string path)
        {
            using var stream = Stream();
            Add(stream, Source(path));
            Settle(stream);
            // Files are closed meanwhile.
            for (uint i = 0; i < 2 * stream.Files.FramesToClose; i++)
                FrameStep.Run(stream, views);
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 50; i++)
                FrameStep.Run(stream, views);
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
        // The safety checks of the test build remember each job; their pools grow now and then.
        long Least(string path) => Enumerable.Range(0, 3).Min(_ => Garbage(path));
        Assert.That(Least(Address), Is.EqualTo(Least(m_cloud)));
    }

    [Test]
    public void Pick_OfAnAddress_FindsThePointOfTheDisk()
    {
        PickedPoint Pick(string path)
        {
            using var stream = Stream();
            var source = Source(path);
            Add(stream, source);
            Settle(stream);
            var bounds = source.Folder.Manifest.BoundsGeo;
            using var picker = new StreamPicker();
            var above = (bounds.Min + bounds.Max) / 2 + new double3(0, 0, 500);
            picker.Begin(stream, PointQuery.Parallel(above, new double3(0, 0, -1), 1, 5));
            for (int i = 0; i < 20_000 && !picker.Update(5); i++)
                Thread.Sleep(1);
            Assert.That(picker.Pick.Failure, Is.Null);
            return picker.Pick.Point;
        }
        PickedPoint wanted = Pick(m_cloud), got = Pick(Address + "?sig=secret");
        Assert.That(wanted, Is.Not.Null);
        Assert.That(got.PositionGeo, Is.EqualTo(wanted.PositionGeo));
        Assert.That(got.Attributes.Select(a => a.ToString()), Is.EqualTo(wanted.Attributes.Select(a => a.ToString())));
    }

    [Test]
    public void Picture_OfAnAddress_HasThePixelsOfTheDisk([Values("adaptive", "2")] string size, [Values] bool hasNormals)
    {
        string disk = Path.Combine(m_served, "scan.fastpoints"), style = "size=" + size + (hasNormals ? ",light=on" : "");
        if (hasNormals)
            JobCoroutine.RunToEnd(AddNormals.Run(disk, new NormalSettings(), null, null));
        byte[] Picture(string path)
        {
            string picture = Scratch["picture.png"];
            var call = CliCall.Of("picture", path, "-o", picture, "--size", "200x120", "--style", style, "--quiet",
                "--force", "--plain");
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            return File.ReadAllBytes(picture);
        }
        Assert.That(Picture(Address + "?sig=secret"), Is.EqualTo(Picture(disk)));
        Assert.That(RemoteStatistics.Waits, Is.Zero);
        Assert.That(m_server.Requests.Any(r => r.Name.Contains(StoreFormat.LayerFolderName)), Is.EqualTo(hasNormals));
    }

    [Test]
    public void Queries_OfAnAddressWhereReadsFailOnce_AreThoseOfAllPoints()
    {
        using var stream = Stream();
        Add(stream, Source(Address));
        using var queries = new PointCloudQueries(stream);
        Until(stream, stats => stats.IsSettled, "the picture", 1e9);
        int failures = 2;
        m_server.Plan = _ => Interlocked.Decrement(ref failures) >= 0 ? Fault.Missing404 : Fault.None;
        _ = queries.Resident;
        Until(stream, _ =>
        {
            queries.Update();
            return queries.IsComplete;
        }, "the copies", 1e9);
        Assert.That(failures, Is.Negative);
        Assert.That(queries.Resident.Count(PointQuery.Nearest(default)), Is.EqualTo(Points));
        var wanted = new List<PointHit>();
        JobCoroutine.RunToEnd(queries.FindInFullDetail(PointQuery.Nearest(default), 10, wanted));
        using var hits = new NativeArray<PointHit>(10, Allocator.Persistent);
        Assert.That(queries.Resident.Find(PointQuery.Nearest(default), hits), Is.EqualTo(10));
        Assert.That(hits.Select(hit => hit.Position), Is.EqualTo(wanted.Select(hit => hit.Position)));
    }

    [Test]
    public void Fly_AnAddress_SaysWhenItWasThere()
    {
        var call = CliCall.Of("fly", Address, "--frames", "90", "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("secondsTo95").GetDouble(),
            Is.GreaterThanOrEqualTo(call.Json.GetProperty("secondsToFull").GetDouble()));
        Assert.That(call.Json.GetProperty("pointsDrawn").GetInt64(), Is.GreaterThan(Points / 2));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Verify_OfAnAddress_FindsAllPoints(bool hasNormals)
    {
        if (hasNormals)
            JobCoroutine.RunToEnd(AddNormals.Run(Path.Combine(m_served, "scan.fastpoints"), null, null, null));
        var call = CliCall.Of("verify", Address, "--json", "-");
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
        Assert.That(call.Json.GetProperty("points").GetInt64(), Is.EqualTo(Points));
        // The hierarchy says how long they are.
        Assert.That(m_server.Requests.Where(r => r.Header("Range") == "bytes=0-65535").Select(r => r.Name),
            Has.None.Contains(StoreFormat.ChunkFolderName));
    }

    [Test]
    public void Info_OfAnAddress_IsThatOfTheDisk()
    {
        string Info(string path)
        {
            var call = CliCall.Of("info", path);
            Assert.That(call.Status, Is.EqualTo(ExitStatus.Done), call.Error);
            return Regex.Replace(call.Output, @"(?m)^.*scan\.fastpoints.*$|size .*", "");
        }
        Assert.That(Info(Address), Is.EqualTo(Info(m_cloud)));
    }
}
