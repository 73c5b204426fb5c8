namespace FastPoints.HostTests.Remote;

sealed class RemoteCacheTests : RemoteFixture
{
    [Test]
    public void SecondVisit_WithoutTheServer_HasWhatTheFirstRead()
    {
        byte[] bytes = Make("a.bin", 600_000);
        string address = Server.Of("a.bin");
        Read(RemoteFile.Open(address), 100_000, 200_000);
        Server.Dispose();
        StartAnew();

        var file = RemoteFile.Open(address);
        Assert.That(Read(file, 0, 1000), Is.EqualTo(bytes[..1000]));
        Assert.That(Read(file, 150_000, 100_000), Is.EqualTo(bytes[150_000..250_000]));
        Assert.That(RemoteStatistics.CacheHits, Is.EqualTo(2));
        AssertOneLine(Try(() => Read(file, 400_000, 1000)), address);
        AssertOneLine(Try(() => RemoteFile.Open(Server.Of("b.bin"))), Server.Of("b.bin"));
    }

    [Test]
    public void SecondVisit_WithTheServer_AsksOnlyWhetherTheFileIsTheSame()
    {
        byte[] bytes = Make("a.bin", 600_000);
        Read(RemoteFile.Open(Server.Of("a.bin")), 0, 600_000);
        StartAnew();
        Server.ResetCounts();

        Assert.That(Read(RemoteFile.Open(Server.Of("a.bin") + "?X-Amz-Signature=other"), 0, 600_000), Is.EqualTo(bytes));

        Assert.That(Server.Requests, Has.Count.EqualTo(1));
        Assert.That(Server.Bytes, Is.LessThanOrEqualTo(1));
    }

    [Test]
    public void Cache_OfMoreThanItsLimit_KeepsWhatWasUsedLast()
    {
        byte[] bytes = Make("a.bin", 20_000_000);
        RemoteAccess.CacheBytes = 4 << 20;
        var file = RemoteFile.Open(Server.Of("a.bin"));
        long most = 0;
        for (int at = 0; at < bytes.Length; at += 100_000)
        {
            Assert.That(Read(file, at, 100_000).AsSpan().SequenceEqual(bytes.AsSpan(at, 100_000)));
            AwaitCache();
            most = Math.Max(most, CacheFiles().Sum(f => f.Length));
        }

        Assert.That(most, Is.InRange(3 << 20, (4 << 20) + 200_000));
        Server.ResetCounts();
        Read(file, 19_000_000, 1_000_000);
        Assert.That(Server.Requests, Is.Empty);
        Read(file, 10_000_000, 1000);
        Assert.That(Server.Requests, Has.Count.EqualTo(1));
    }

    [Test]
    public void CacheFiles_Damaged_AreNotUsed([Values(0, 1, 2, 3)] int kind, [Values(1, 2, 3)] int seed)
    {
        byte[] bytes = Make("a.bin", 600_000);
        var file = RemoteFile.Open(Server.Of("a.bin"));
        for (int at = 0; at < bytes.Length; at += 50_000)
            Read(file, at, 50_000);
        StartAnew();
        var random = new System.Random(seed);
        foreach (FileInfo cached in CacheFiles())
            File.WriteAllBytes(cached.FullName, Damage(File.ReadAllBytes(cached.FullName), kind, random));

        file = RemoteFile.Open(Server.Of("a.bin"));
        for (int at = 0; at < bytes.Length; at += 50_000)
            Assert.That(Read(file, at, 50_000), Is.EqualTo(bytes[at..(at + 50_000)]));
        Assert.That(Server.Requests, Has.Count.GreaterThan(13));
    }

    [Test]
    public void Find_TwiceOfADamagedRecord_HasNothing()
    {
        var key = FileVersionKey.Of("a");
        RangeCache.Current.Add(key, 0, new byte[100]);
        StartAnew();
        string path = CacheFiles().Single().FullName;
        byte[] bytes = File.ReadAllBytes(path);
        bytes[^1] ^= 1;
        File.WriteAllBytes(path, bytes);
        _ = RangeCache.Current.ReadLastRange(key);
        Assert.That(RangeCache.Current.ReadLastRange(key), Is.Null);
    }

    [Test]
    public void Find_OfWhatSeveralRunsWrote_HasTheLast()
    {
        var key = FileVersionKey.Of("a");
        for (byte run = 0; run < 20; run++)
        {
            RangeCache.Current.Add(key, 0, new[] { run });
            StartAnew();
        }
        Assert.That(RangeCache.Current.ReadLastRange(key), Is.EqualTo(new byte[] { 19 }));
    }

    static byte[] Damage(byte[] bytes, int kind, System.Random random)
    {
        switch (kind)
        {
            case 0:
                bytes[random.Next(bytes.Length)] ^= 1;
                return bytes;
            case 1:
                for (int i = 0; i < bytes.Length; i += random.Next(1, 20_000))
                    bytes[i] = (byte)random.Next(256);
                return bytes;
            case 2: return bytes[..random.Next(bytes.Length)];
            default: return bytes[random.Next(1, bytes.Length)..];
        }
    }

    [Test]
    public void Cache_OfManyShortRuns_HasFewFiles()
    {
        byte[] bytes = Make("a.bin", 2_000_000);
        for (int run = 0; run < 300; run++)
        {
            StartAnew();
            RemoteFile file = RemoteFile.Open(Server.Of("a.bin"));
            Read(file, run * 5000, 5000);
        }

        Assert.That(CacheFiles(), Has.Length.LessThanOrEqualTo(161));
        Server.ResetCounts();
        Assert.That(Read(RemoteFile.Open(Server.Of("a.bin")), 0, 1_500_000), Is.EqualTo(bytes[..1_500_000]));
        Assert.That(Server.Bytes, Is.LessThan(150_000));
    }

    [TestCase(3), TestCase(20, Category = "Long")]
    public void Process_KilledWhileItFillsTheCache_LeavesWhatIsWhole(int kills)
    {
        byte[] bytes = Make("a.bin", 100_000_000);
        RemoteAccess.CacheBytes = 1L << 30;
        string address = Server.Of("a.bin");
        var random = new System.Random(1);
        for (int kill = 0; kill < kills; kill++)
        {
            List<string> lines = FillUntilKilled(address, kill, random.Next(300));
            TestContext.Out.WriteLine($"killed after {lines.Count} ranges, {CacheFiles().Sum(f => f.Length)} bytes");

            StartAnew();
            var file = RemoteFile.Open(address);
            Server.ResetCounts();
            foreach (string[] line in lines.Select(line => line.Split(' ')))
            {
                (int offset, int count) = (int.Parse(line[0]), int.Parse(line[1]));
                Assert.That(Read(file, offset, count).AsSpan().SequenceEqual(bytes.AsSpan(offset, count)));
            }
            Assert.That(Server.Requests, Is.Empty, $"kill {kill}");
        }
        Assert.That(Read(RemoteFile.Open(address), 0, bytes.Length).AsSpan().SequenceEqual(bytes));
    }

    List<string> FillUntilKilled(string address, int seed, int ms)
    {
        using Process process = Fill(address, 1 << 20, seed);
        var lines = new List<string> { process.StandardOutput.ReadLine() };
        Thread.Sleep(ms);
        process.Kill();
        while (process.StandardOutput.ReadLine() is { } line)
            lines.Add(line);
        process.WaitForExit();
        // A line that was cut is none.
        return lines.Where(line => line?.Split(' ').Length == 2).SkipLast(1).ToList();
    }

    [Test]
    public void Cache_OfTwoProcessesAtOnce_GivesNoWrongByteAndKeepsItsLimit()
    {
        byte[] bytes = Make("a.bin", 6_000_000);
        RemoteAccess.CacheBytes = 4 << 20;
        Process[] processes = { Fill(Server.Of("a.bin"), 300, 1), Fill(Server.Of("a.bin"), 300, 2) };
        foreach (Process process in processes)
        {
            string lines = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.Zero, lines + process.StandardError.ReadToEnd());
            process.Dispose();
        }

        // Each knows the other's files as they were when it last looked.
        Assert.That(CacheFiles().Sum(f => f.Length), Is.LessThan((4 << 20) + (1 << 20)));
        var file = RemoteFile.Open(Server.Of("a.bin"));
        Assert.That(Read(file, 0, bytes.Length), Is.EqualTo(bytes));
    }

    Process Fill(string address, int reads, int seed)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        string[] args =
        {
            "exec", typeof(CacheFiller).Assembly.Location, Scratch["cache"], address, Scratch["served/a.bin"],
            RemoteAccess.CacheBytes.ToString(), reads.ToString(), seed.ToString(),
        };
        foreach (string arg in args)
            start.ArgumentList.Add(arg);
        return Process.Start(start);
    }

    FileInfo[] CacheFiles() => new DirectoryInfo(Scratch["cache"]).GetFiles();
}
