namespace FastPoints.HostTests.Remote;

sealed class RemoteReadTests : RemoteFixture
{
    [SetUp]
    public void WithoutCache() => RemoteAccess.CacheBytes = 0;

    static void Await(params RemoteRead[] reads)
    {
        foreach (RemoteRead read in reads)
            read.Await();
    }

    static void Dispose(RemoteRead[] reads) => Array.ForEach(reads, read => read.Dispose());

    [Test]
    public unsafe void Reads_ManyAtOnce_UseEightConnectionsAndGetTheirBytes()
    {
        byte[] bytes = Make("a.bin", 8_000_000);
        Server.LatencyMs = 20;
        var file = RemoteFile.Open(Server.Of("a.bin"));
        RemoteRead[] reads = Enumerable.Range(0, 60).Select(i => file.Begin(100_000 * i + 70_000, 10_000, i)).ToArray();

        Await(reads);

        for (int i = 0; i < reads.Length; i++)
        {
            Assert.That(new ReadOnlySpan<byte>(reads[i].Data, 10_000).SequenceEqual(bytes.AsSpan(100_000 * i + 70_000, 10_000)));
            reads[i].Dispose();
        }
        Assert.That(Server.PeakConnections, Is.InRange(2, 8));
    }

    [Test]
    public void Reads_OfLowerRank_GoFirstEvenIfItFellMeanwhile()
    {
        Make("a.bin", 8_000_000);
        RemoteSettings.Current = new RemoteSettings { MaxConnections = 1 };
        var file = RemoteFile.Open(Server.Of("a.bin"));
        Server.ResetCounts();
        var gate = new TaskCompletionSource();
        Server.Gate = gate.Task;
        var queue = RangeQueue.Of(Server.Address);
        RemoteRead[] reads = Enumerable.Range(0, 5).Select(i => new RemoteRead(file, 1_500_000 * i + 100_000, 100, i)).ToArray();
        foreach (RemoteRead read in reads)
            queue.Add(read, new List<RangePiece> { new(0, 0, 100) });
        Array.ForEach(reads, read => read.Rank = -read.Rank);
        gate.SetResult();

        Await(reads);

        long[] offsets = Server.Requests.Skip(1).Select(r => long.Parse(r.Header("Range")[6..].Split('-')[0])).ToArray();
        Assert.That(offsets, Is.Ordered.Descending);
        Dispose(reads);
    }

    // As of an octree of a file a node: nothing of each is kept.
    [Test]
    public void RemoteFetch_OfAFileOfTheirOwn_ForgetIt([Values] bool isGivenUp)
    {
        Make("a.bin", 200_000);
        var gate = new TaskCompletionSource();
        Server.Gate = gate.Task;
        var fetched = new RemoteFetch(new List<FilePiece> { new() { Path = Server.Of("a.bin"), LengthBytes = -1 } }, 0);
        if (isGivenUp)
            fetched.Dispose();
        gate.SetResult();
        if (!isGivenUp)
        {
            Assert.That(SpinWait.SpinUntil(() => fetched.PollIsDone(), 10_000));
            Assert.That(RemoteFile.Find(Server.Of("a.bin")), Is.Not.Null);
            fetched.Dispose();
        }
        Assert.That(() => RemoteStatistics.BytesFetched > 0 && RemoteFile.Find(Server.Of("a.bin")) == null,
            Is.True.After(10_000, 20));
    }

    [Test]
    public unsafe void Reads_Cancelled_NeverWrite()
    {
        Make("a.bin", 4_000_000);
        var file = RemoteFile.Open(Server.Of("a.bin"));
        var random = new System.Random(1);
        for (int round = 0; round < 60; round++)
        {
            const int Bytes = 200_000;
            byte* memory = (byte*)UnsafeUtility.Malloc(Bytes, 16, Allocator.Persistent);
            var command = new ReadCommand { Buffer = memory, Offset = random.Next(4_000_000 - Bytes), Size = Bytes };
            var read = file.Begin(&command, 1);
            Thread.Sleep(random.Next(4));
            read.Cancel();
            new Span<byte>(memory, Bytes).Fill(0xCC);
            Thread.Sleep(10);
            bool isUntouched = new Span<byte>(memory, Bytes).IndexOfAnyExcept((byte)0xCC) < 0;
            UnsafeUtility.Free(memory, Allocator.Persistent);
            Assert.That(isUntouched, $"round {round}");
        }
    }

    [Test]
    public unsafe void Take_AfterCancel_WritesNothing()
    {
        byte* memory = stackalloc byte[8];
        var command = new ReadCommand { Buffer = memory, Offset = 0, Size = 8 };
        using var read = new RemoteRead(null, &command, 1, 0);
        read.Receive(0, 0, new byte[] { 1, 2 });
        read.Cancel();
        read.Receive(0, 2, new byte[] { 3, 4, 5, 6, 7, 8 });

        Assert.That(new ReadOnlySpan<byte>(memory, 8).ToArray(), Is.EqualTo(new byte[] { 1, 2, 0, 0, 0, 0, 0, 0 }));
        Assert.That(read.IsDone && read.IsCancelled);
    }

    [Test]
    public void Reads_CancelledBeforeTheyWereAsked_AreNotAsked()
    {
        Make("a.bin", 4_000_000);
        var file = RemoteFile.Open(Server.Of("a.bin"));
        Server.ResetCounts();
        var gate = new TaskCompletionSource();
        Server.Gate = gate.Task;
        RemoteRead[] reads = Enumerable.Range(0, 30).Select(i => file.Begin(100_000 * i + 70_000, 100, i)).ToArray();
        Assert.That(SpinWait.SpinUntil(() => Server.Requests.Count > 0, 10_000));
        Dispose(reads);
        gate.SetResult();
        using RemoteRead last = file.Begin(3_900_000, 100);
        Await(last);

        Assert.That(Server.Requests, Has.Count.LessThanOrEqualTo(9));
    }

    [Test]
    public void Reads_OfNeighbours_AreFewRequests()
    {
        Make("a.bin", 4_000_000);
        RemoteSettings.Current = new RemoteSettings(); // Such an answer does not count as stalled.
        Server.LatencyMs = 1600; // A hundred to gather them.
        var file = RemoteFile.Open(Server.Of("a.bin"));
        Server.LatencyMs = 0;
        Server.ResetCounts();
        RemoteRead[] reads = Enumerable.Range(0, 100).Select(i => file.Begin(100_000 + 10_000 * i, 9_900, i)).ToArray();

        Await(reads);

        Assert.That(Server.Requests, Has.Count.LessThanOrEqualTo(4));
        Dispose(reads);
    }

    [Test]
    public void Sign_WhereTheServerRefuses_IsAskedAgain()
    {
        byte[] bytes = Make("a.bin", 300_000);
        var asked = new List<bool>();
        RemoteAccess.Sign = (uri, wasRefused) =>
        {
            lock (asked)
                asked.Add(wasRefused);
            return new Uri(uri.GetLeftPart(UriPartial.Path) + (wasRefused ? "?sig=new-secret" : "?sig=old-secret"));
        };
        try
        {
            var file = RemoteFile.Open(Server.Of("a.bin"));
            Server.Plan = request => request.Target.EndsWith("new-secret") ? Fault.None : Fault.Refused403;
            Assert.That(Read(file, 200_000, 1000), Is.EqualTo(bytes[200_000..201_000]));
            Assert.That(asked, Is.EqualTo(new[] { false, true }));

            Server.Plan = _ => Fault.Refused403;
            Exception failure = Try(() => Read(file, 210_000, 1000));
            AssertOneLine(failure, Server.Of("a.bin"));
            Assert.That(((PointCloudException)failure).Code, Is.EqualTo(FailureCode.AccessDenied));
        }
        finally
        {
            RemoteAccess.Sign = null;
        }
    }

    [Test]
    public void Headers_OfTheUser_AreNotSentToWhereARedirectLeads()
    {
        Make("a.bin", 300_000);
        using var other = new RangeServer(Scratch["served"]);
        RemoteAccess.AddHeaders = (_, headers) => headers["Authorization"] = "Bearer secret";
        try
        {
            Server.RedirectsTo = other.Address;
            Read(RemoteFile.Open(Server.Of("a.bin")), 100_000, 1000);

            Assert.That(Server.Requests.Select(r => r.Header("Authorization")), Is.All.EqualTo("Bearer secret"));
            Assert.That(other.Requests.Select(r => r.Header("Authorization")), Is.All.Null);
            Assert.That(other.Requests, Is.Not.Empty);
        }
        finally
        {
            RemoteAccess.AddHeaders = null;
        }
    }

    [Test]
    public void Open_OfHttpBeyondThisMachine_IsRefusedUnlessAllowed()
    {
        Exception failure = Try(() => RemoteFile.Open("http://nowhere.invalid/a.bin" + Secret));

        AssertOneLine(failure, "http://nowhere.invalid/a.bin");
        Assert.That(((PointCloudException)failure).Code, Is.EqualTo(FailureCode.AccessDenied));
    }
}
