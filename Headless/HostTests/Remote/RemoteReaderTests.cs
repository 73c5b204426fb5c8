namespace FastPoints.HostTests.Remote;

/// <summary>Sources by address: what is read is what is read of the disk, without waiting, by few requests.</summary>
[NonParallelizable]
sealed class RemoteReaderTests : RemoteFixture
{
    static IEnumerable<FormatFixture> Formats => FormatFixture.All;

    [SetUp]
    public void Trust() => RemoteSettings.Current = new RemoteSettings { ConfirmedMs = 60_000 };

    string AddressOf(string path) => Server.Of(Path.GetRelativePath(Scratch["served"], path).Replace('\\', '/')) + Secret;

    static PointReader Open(string path) => PointReaders.Open(path);

    // Of each block's columns, in order.
    static unsafe List<ulong> HashesOf(PointReader reader)
    {
        var hashes = new List<ulong>();
        var summary = new SummariseCloud(reader)
        {
            BlockCompleted = read =>
            {
                for (int c = 0; c < read.Points.Schema.Count; c++)
                    hashes.Add(ContentHash.Of((byte*)read.Points.Bytes.GetUnsafeReadOnlyPtr() + read.Points.Column(c).OffsetBytes,
                        (long)read.Points.Count * read.Points.Schema[c].Type.SizeOf()));
            },
        };
        JobCoroutine.RunToEnd(summary.Run(null));
        return hashes;
    }

    static unsafe ulong HashOf(PointBatch batch)
    {
        ulong hash = 0;
        for (int c = 0; c < batch.Schema.Count; c++)
            hash = hash * 31 + ContentHash.Of((byte*)batch.Bytes.GetUnsafeReadOnlyPtr() + batch.Column(c).OffsetBytes,
                (long)batch.Count * batch.Schema[c].Type.SizeOf());
        return hash;
    }

    static string[] WarningsOf(PointReader reader) => reader.Info.Warnings.Select(w => w.ByteOffset + " " + w.Text).ToArray();

    [TestCaseSource(nameof(Formats))]
    public void Scan_ByAddress_GivesTheSamePointsWithoutWaiting(FormatFixture format)
    {
        string path = format.Write(Scratch["served"]);
        using var local = Open(path);
        var wanted = HashesOf(local);
        using var remote = Open(AddressOf(path));
        Assert.That(HashesOf(remote), Is.EqualTo(wanted));
        Assert.That(remote.Info.PointsReadable, Is.EqualTo(local.Info.PointsReadable));
        Assert.That(WarningsOf(remote), Is.EqualTo(WarningsOf(local)));
        Assert.That(RemoteStatistics.Waits, Is.Zero);
        Assert.That(remote.Info.Warnings.Any(w => w.ToString().Contains("secret")), Is.False);

        Assert.That(Server.Requests.Count, Is.LessThanOrEqualTo(MaxRequests(remote)));
    }

    // One opens each file; another brings what did not come with that, of Potree 2 for each node; and where the nodes of Potree 1
    // are is tried out.
    int MaxRequests(PointReader reader)
    {
        const int Probes = 8;
        int files = Directory.GetFiles(Scratch["served"], "*", SearchOption.AllDirectories)
            .Sum(file => new FileInfo(file).Length > RemoteFile.HeadBytes ? 2 : 1);
        return files + (reader is Potree1Reader ? Probes : reader is Potree2Reader ? reader.BlockCount : 0);
    }

    [TestCase("demo.las")]
    [TestCase("demo.laz")]
    public void Preview_OfASmallFile_IsThatOfTheDisk(string name)
    {
        string path = Demo(name, 60_000);
        Assert.That(SampleOf(AddressOf(path), 10_000, out _), Is.EqualTo(SampleOf(path, 10_000, out _)));
        Assert.That(RemoteStatistics.Waits, Is.Zero);
    }

    [TestCase("demo.las")]
    [TestCase("demo.laz")]
    public void Preview_OfALargeFile_ReadsFewRangesSpreadOverIt(string name)
    {
        const int Points = 400_000, Wanted = 50_000, Parts = 8;
        string path = Demo(name, Points);
        RemoteFile.MaxSmallFileBytes = 0;
        RemoteAccess.CacheBytes = 0;
        SampleOf(AddressOf(path), Wanted, out var sample);
        // Where there are few blocks, short ones give less than their share.
        Assert.That(sample, Has.Count.InRange(Wanted * 9 / 10, Wanted));
        Assert.That(RemoteStatistics.Waits, Is.Zero);
        Assert.That(Server.Requests.Count, Is.LessThanOrEqualTo(380));
        long length = new FileInfo(path).Length;
        bool Touches(RangeRequest request, int part) => request.TryRange(length, out long from, out long bytes)
            && from < (part + 1) * length / Parts && from + bytes > part * length / Parts;
        foreach (int part in Enumerable.Range(0, Parts))
            Assert.That(Server.Requests.Any(r => Touches(r, part)), Is.True, "part " + part);

        var all = new HashSet<(double, double, double)>();
        using var local = Open(path);
        var summary = new SummariseCloud(local) { BlockCompleted = read => all.UnionWith(PositionsOf(read.Points)) };
        JobCoroutine.RunToEnd(summary.Run(null));
        Assert.That(sample.Where(p => !all.Contains(p)), Is.Empty);
        Assert.That(sample.Distinct().Count(), Is.GreaterThan(sample.Count * 9 / 10));
    }

    static List<(double, double, double)> PositionsOf(PointBatch batch)
    {
        var columns = new[] { AttributeNames.X, AttributeNames.Y, AttributeNames.Z }
            .Select(name => batch.Column(batch.Schema.IndexOf(name))).ToArray();
        return Enumerable.Range(0, batch.Count).Select(i =>
        {
            unsafe double At(PointColumn column) => ColumnValues.ToDouble((byte*)batch.Bytes.GetUnsafeReadOnlyPtr()
                + column.OffsetBytes, column.Type, i);
            return (At(columns[0]), At(columns[1]), At(columns[2]));
        }).ToList();
    }

    static ulong SampleOf(string path, int points, out List<(double, double, double)> positions)
    {
        using var reader = Open(path);
        using var sampling = new PreviewSampling(reader, new SampleOptions { Points = points });
        JobCoroutine.RunToEnd(sampling.Run(null));
        positions = PositionsOf(sampling.Sample.Points);
        return HashOf(sampling.Sample.Points);
    }

    [Test]
    public void Scan_OfTilesHereAndThere_IsThatOfTheDisk()
    {
        string first = Scratch.Demo("served/a.las", 40_000), second = Scratch.Demo("served/b.las", 30_000);
        using var local = PointReaders.Open([first, second]);
        using var remote = PointReaders.Open([AddressOf(first), AddressOf(second)]);
        using var mixed = PointReaders.Open([first, AddressOf(second)]);
        var wanted = HashesOf(local);
        Assert.That(HashesOf(remote), Is.EqualTo(wanted));
        Assert.That(HashesOf(mixed), Is.EqualTo(wanted));
        Assert.That(RemoteStatistics.Waits, Is.Zero);
        Assert.That(remote.Info.Path, Does.Not.Contain("secret"));
    }

    [Test]
    public void Scan_OfAFileThatChangesMeanwhile_EndsInOneLine()
    {
        RemoteAccess.CacheBytes = 0;
        string path = Scratch.Demo("served/demo.las", 100_000);
        using var reader = Open(AddressOf(path));
        byte[] bytes = File.ReadAllBytes(path);
        File.WriteAllBytes(path, bytes.Append((byte)0).ToArray());
        AssertOneLine(Try(() => HashesOf(reader)), AddressOf(path));
    }

    [Test]
    public void Read_ThatNobodyFetched_WaitsAndCounts()
    {
        string path = Scratch.Demo("served/demo.las", 20_000);
        using var local = Open(path);
        using var remote = Open(AddressOf(path));
        ulong HashOfBlock(PointReader reader)
        {
            using var read = reader.CreateRead(reader.Info.Schema, reader.MaxPointsPerBlock, Allocator.Persistent);
            read.Begin(new BlockRange(0, 0, reader.PointsInBlock(0)));
            read.Complete();
            return HashOf(read.Points);
        }
        Assert.That(HashOfBlock(remote), Is.EqualTo(HashOfBlock(local)));
        Assert.That(RemoteStatistics.Waits, Is.EqualTo(1));
    }
}
