namespace FastPoints.HostTests.Remote;

/// <summary>Octrees of other formats on a web server, streamed frame by frame.</summary>
[NonParallelizable]
sealed class RemoteTreeTests : RemoteFixture
{
    static IEnumerable<FormatFixture> Trees => FormatFixture.All.Where(f => f.Format is "COPC" or "EPT" or "Potree");

    static readonly string[] s_planes = [StoreLayout.ColorName];

    [SetUp]
    public void Trust()
    {
        RemoteSettings.Current = new RemoteSettings { ConfirmedMs = 60_000 };
        RemoteAccess.CacheBytes = 0;
    }

    string AddressOf(string path) => Server.Of(Path.GetRelativePath(Scratch["served"], path).Replace('\\', '/')) + Secret;

    static StreamContext Stream()
    {
        var stream = new StreamContext(new MemoryNodePool(64 << 20, 1 << 20));
        stream.Settings.Selection.MinScreenErrorPx = 0.05f;
        return stream;
    }

    static int Add(StreamContext stream, string path)
    {
        var reader = PointReaders.Open(path);
        JobCoroutine.RunToEnd(TreeSource.ReadTop(reader));
        var source = new TreeSource(reader, s_planes);
        return stream.Add(source, CloudPlacement.Geo(source.Grid, source.Root));
    }

    static void Until(StreamContext stream, Func<FrameStats, bool> isThere, double scalePx = 1000)
    {
        for (int frame = 0; frame < 20_000; frame++)
        {
            if (isThere(RemoteCloudTests.Frame(stream, scalePx)))
                return;
            Thread.Sleep(1);
        }
        Assert.Fail("it does not come to rest");
    }

    // What is drawn of each node, by its page and number.
    static unsafe Dictionary<(int, int), ulong> DrawnOf(string path)
    {
        using var stream = Stream();
        int cloud = Add(stream, path);
        Until(stream, stats => stats.IsSettled);
        Assert.That(stream.TryTakeFailure(out var failure), Is.False, failure.ToString());
        return stream.Drawn.AsArray().ToDictionary(node => (node.Page, node.Node), node => ContentHash.Of(
            ((MemoryNodePool)stream.Pool).AddressOf(node.Range), stream.Clouds[cloud].BytesOf(node.Page, node.Node)));
    }

    [TestCaseSource(nameof(Trees))]
    public void Run_AnOctreeByAddress_DrawsTheNodesAndBytesOfTheDisk(FormatFixture format)
    {
        string path = format.Write(Scratch["served"]);
        var wanted = DrawnOf(path);
        UnsafeUtility.ForgiveLeaks();
        Assert.That(DrawnOf(AddressOf(path)), Is.EquivalentTo(wanted));
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    string Copc() => FormatFixture.All.First(f => f.Format == "COPC").Write(Scratch["served"]);

    [Test]
    public void Dispose_WhileNodesAreOnTheirWay_FreesAllAtOnce()
    {
        string path = Copc();
        UnsafeUtility.ForgiveLeaks();
        var stream = Stream();
        Add(stream, AddressOf(path));
        Server.Gate = new TaskCompletionSource().Task;
        RemoteFile.Find(AddressOf(path)).DropOpened();
        Until(stream, stats => stats.ReadsInFlight > 0);
        // Had it waited for the server, it would do so until that counts as stalled.
        AssertWithin(RemoteSettings.Current.StallMs / 1000.0, stream.Dispose);
        Assert.That(UnsafeUtility.CheckForLeaks(), Is.Zero);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    [Test]
    public void Run_WhatLeavesTheView_IsCancelledAndComesLater()
    {
        string path = Copc();
        var wanted = DrawnOf(path);
        using var stream = Stream();
        Add(stream, AddressOf(path));
        var gate = new TaskCompletionSource();
        Server.Gate = gate.Task;
        RemoteFile.Find(AddressOf(path)).DropOpened();
        Until(stream, stats => stats.ReadsInFlight > 2);
        // Nothing but the root is that large; none has come.
        Until(stream, stats => stats.ReadsInFlight <= 1, 1e-9);
        gate.SetResult();
        Until(stream, stats => stats.IsSettled);
        Assert.That(stream.Drawn.Length, Is.EqualTo(wanted.Count));
        Assert.That(stream.TryTakeFailure(out _), Is.False);
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    [Test]
    public void Run_ANodeWhoseFileIsMissing_LeavesItOutAndSaysSo()
    {
        string path = FormatFixture.All.First(f => f.ToString() == "EPT_Laszip").Write(Scratch["served"]);
        int all = DrawnOf(path).Count;
        File.Delete(Directory.GetFiles(Scratch["served"], "1-*.laz", SearchOption.AllDirectories).First());
        using var stream = Stream();
        Add(stream, AddressOf(path));
        Until(stream, stats => stats.IsSettled);
        Assert.That(stream.Drawn.Length, Is.EqualTo(all - 1));
        Assert.That(stream.TryTakeFailure(out var failure), Is.True);
        Assert.That(failure.ToString(), Does.EndWith(".laz: the server answered 404: no such file").And.Not.Contain("secret"));
    }
}
