using StandIns.Memory;

namespace FastPoints.HostTests.Remote;

sealed class RemoteFaultTests : RemoteFixture
{
    const double MaxSeconds = 10; // A stalled answer is waited for twice a try at most, three times.

    // One such answer ends a read: asking again would bring the same, or other bytes of another version.
    static readonly Fault[] s_final =
    {
        Fault.WholeBody, Fault.WrongTotal, Fault.OtherTag, Fault.Compressed, Fault.Refused403, Fault.Missing404,
        Fault.RedirectToHttp,
    };

    // What a client cannot know from one answer is no fault to it.
    static readonly Fault[] s_unseen = { Fault.NoTag, Fault.OtherDate };

    static bool IsBorne(Fault fault) => Faults.IsHarmless(fault) || s_unseen.Contains(fault);

    [TestCaseSource(typeof(Faults), nameof(Faults.All))]
    public void Read_WithAFaultOnce_GetsTheBytesOrOneLine(Fault fault)
    {
        byte[] bytes = Make("a.bin", 300_000);
        var file = RemoteFile.Open(Server.Of("a.bin") + Secret);
        int answers = 0;
        Server.Plan = _ => Interlocked.Increment(ref answers) == 1 ? fault : Fault.None;

        byte[] read = null;
        Exception failure = null;
        AssertWithin(MaxSeconds, () => failure = Try(() => read = Read(file, 100_000, 150_000)));

        Assert.That(failure != null, Is.EqualTo(s_final.Contains(fault)), failure?.Message);
        if (failure == null)
            Assert.That(read, Is.EqualTo(bytes[100_000..250_000]));
        else
            AssertOneLine(failure, file.Name);
    }

    [TestCaseSource(typeof(Faults), nameof(Faults.All))]
    public void Read_WithAFaultForEver_EndsInOneLine(Fault fault)
    {
        byte[] bytes = Make("a.bin", 300_000);
        var file = RemoteFile.Open(Server.Of("a.bin") + Secret);
        Server.Plan = request => request.Target.StartsWith("/redirected/", StringComparison.Ordinal) ? Fault.None : fault;

        byte[] read = null;
        Exception failure = null;
        AssertWithin(MaxSeconds, () => failure = Try(() => read = Read(file, 100_000, 150_000)));

        Assert.That(failure == null, Is.EqualTo(IsBorne(fault)), failure?.Message);
        if (failure != null)
            AssertOneLine(failure, file.Name);
        else
            Assert.That(read, Is.EqualTo(bytes[100_000..250_000]));
        if (failure is PointCloudException { Code: FailureCode.ReadFailed } line)
            Assert.That(line.ByteOffset, Is.InRange(100_000, 250_000));
    }

    [TestCaseSource(typeof(Faults), nameof(Faults.All))]
    public void Open_WithAFaultOnce_ReadsTheBytesOrOneLineThenAndLater(Fault fault)
    {
        byte[] bytes = Make("a.bin", 300_000);
        string address = Server.Of("a.bin") + Secret;
        int answers = 0;
        Server.Plan = _ => Interlocked.Increment(ref answers) == 1 ? fault : Fault.None;

        AssertWithin(MaxSeconds, () =>
        {
            Exception failure = Try(() => Assert.That(Read(RemoteFile.Open(address), 200_000, 50_000),
                Is.EqualTo(bytes[200_000..250_000])));
            if (failure != null)
                AssertOneLine(failure, address);
        });

        // What one wrong answer said is believed no longer than until the next.
        Assert.That(Read(RemoteFile.Open(address), 200_000, 50_000), Is.EqualTo(bytes[200_000..250_000]));
        StartAnew();
        Assert.That(Read(RemoteFile.Open(address), 0, 50_000), Is.EqualTo(bytes[..50_000]));
    }

    [TestCaseSource(typeof(Faults), nameof(Faults.All))]
    public void Open_WithAFaultForEver_EndsInTimeWithoutWrongBytes(Fault fault)
    {
        byte[] bytes = Make("a.bin", 300_000);
        string address = Server.Of("a.bin") + Secret;
        Server.Plan = request => request.Target.StartsWith("/redirected/", StringComparison.Ordinal) ? Fault.None : fault;

        AssertWithin(2 * MaxSeconds, () =>
        {
            byte[] read = null;
            Exception failure = Try(() => read = Read(RemoteFile.Open(address), 200_000, 50_000));
            if (failure != null)
                AssertOneLine(failure, address);
            else
                Assert.That(read, Is.EqualTo(bytes[200_000..250_000]));
            if (IsBorne(fault))
                Assert.That(failure, Is.Null);
        });
    }

    [Test]
    public void Read_OfAFileThatChanged_FailsAndReopensWhole()
    {
        Make("a.bin", 300_000, seed: 1);
        string address = Server.Of("a.bin");
        RemoteSettings.Current.ConfirmedMs = 60_000;
        var file = RemoteFile.Open(address);
        Read(file, 100_000, 50_000);
        byte[] bytes = Make("a.bin", 300_000, seed: 2);

        Exception failure = Try(() => Read(file, 200_000, 50_000));

        AssertOneLine(failure, address);
        Assert.That(((PointCloudException)failure).Code, Is.EqualTo(FailureCode.Changed));
        Assert.That(Read(RemoteFile.Open(address), 90_000, 200_000), Is.EqualTo(bytes[90_000..290_000]));
    }

    // 10,000 in all kinds, at once: it ends, never with a wrong byte, in the cache neither, and leaves nothing behind.
    [TestCase(400)]
    [TestCase(10_000, Category = "Long")]
    public void Reads_WithSeededFaults_AreRightOrOneLine(int faults)
    {
        const int Files = 8, Length = 400_000;
        RemoteSettings.Current.StallMs = 150;
        byte[][] bytes = Enumerable.Range(0, Files).Select(i => Make(i + ".bin", Length, i)).ToArray();
        int met = 0, right = 0, failed = 0;
        (int Descriptors, int Memory) before = default;
        for (int round = 0; met < faults; round++)
        {
            StartAnew();
            Server.Plan = Faults.Seeded(round, 0.5, Faults.All);
            Parallel.For(0, 64, new ParallelOptions { MaxDegreeOfParallelism = 8 }, i =>
            {
                var random = new System.Random(round * 64 + i);
                int name = random.Next(Files), offset = random.Next(Length), count = random.Next(1, Length - offset + 1);
                string address = Server.Of(name + ".bin") + Secret;
                byte[] read = null;
                Exception failure = Try(() => read = Read(RemoteFile.Open(address), offset, count));
                if (failure != null)
                    AssertOneLine(failure, address);
                else
                    Assert.That(read.AsSpan().SequenceEqual(bytes[name].AsSpan(offset, count)), $"{round} {i}: {offset}");
                Interlocked.Increment(ref failure == null ? ref right : ref failed);
            });
            met += Server.Requests.Count(r => r.Fault != Fault.None);
            Server.ResetCounts();
            if (round == 0)
                before = LeftBehind(0);
        }
        TestContext.Out.WriteLine($"{met} faults, {right} reads right, {failed} failed");
        Server.Plan = null;
        for (int i = 0; i < Files; i++)
        {
            StartAnew();
            Assert.That(Read(RemoteFile.Open(Server.Of(i + ".bin")), 0, Length), Is.EqualTo(bytes[i]));
        }
        Assert.That(right, Is.GreaterThan(failed / 10));
        (int Descriptors, int Memory) after = LeftBehind(before.Descriptors);
        Assert.That(after.Descriptors, Is.LessThanOrEqualTo(before.Descriptors));
        Assert.That(after.Memory, Is.LessThanOrEqualTo(before.Memory));
    }

    // Open files and sockets, of the server's too, and native memory that nobody has freed. Waits for few enough, 2 s at most.
    // The runtime keeps two descriptors of each assembly, some of which are loaded where a rare fault first needs them.
    (int Descriptors, int Memory) LeftBehind(int enough)
    {
        StartAnew();
        int Descriptors() => !Directory.Exists("/proc/self/fd") ? 0 : Directory.GetFileSystemEntries("/proc/self/fd").Count(f =>
            Path.GetExtension(new FileInfo(f).LinkTarget) is not (".dll" or ".pdb"));
        int least = Descriptors();
        for (var watch = Stopwatch.StartNew(); least > enough && watch.ElapsedMilliseconds < 2000;)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            least = Math.Min(least, Descriptors());
        }
        return (least, AllocationLedger.Live(Allocator.Persistent));
    }
}
