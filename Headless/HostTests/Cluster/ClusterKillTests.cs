namespace FastPoints.HostTests.Cluster;

/// <summary>Tasks in processes of their own, as schedulers run them: stopped, killed, twice at a time.</summary>
[Platform(Exclude = "Win")]
public sealed class ClusterKillTests
{
    const string LittleMemory = "160MiB";

    ClusterCloud m_cloud;

    [SetUp]
    public void Begin() => m_cloud = new ClusterCloud();

    [TearDown]
    public void End() => m_cloud.Dispose();

    Process Start(params string[] line) => Process.Start(new ProcessStartInfo(
        Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"), [.. line, "--quiet", "--scratch", m_cloud.Scratch["scratch"]])
    {
        RedirectStandardError = true,
        RedirectStandardOutput = true,
    });

    static int End(Process process)
    {
        process.StandardOutput.ReadToEndAsync();
        process.StandardError.ReadToEndAsync();
        process.WaitForExit();
        return process.ExitCode;
    }

    void CommitAndCompare()
    {
        var commit = m_cloud.Commit();
        Assert.That(commit.Status, Is.EqualTo(ExitStatus.Done), commit.Error);
        ClusterCloud.AssertSame(m_cloud.Whole("tiles"), m_cloud.Store);
    }

    [TestCase("--cells", 4)]
    [TestCase("--buckets", 4)]
    [TestCase("--cells", 20, Category = "Long")]
    [TestCase("--buckets", 20, Category = "Long")]
    public void Kill_AtRandomTimes_LosesNoTaskAndNoByte(string mode, int kills)
    {
        m_cloud.MakePlan("tiles", 60_000, mode);
        var random = new System.Random(kills);
        var lines = m_cloud.Stage("bucket").Concat(m_cloud.Stage("build")).Concat(m_cloud.Stage("merge")).ToArray();
        var killed = Enumerable.Range(0, kills).Select(_ => random.Next(lines.Length)).ToList();
        for (int i = 0; i < lines.Length; i++)
        {
            foreach (int _ in killed.Where(k => k == i))
                using (var process = Start(lines[i]))
                {
                    if (!process.WaitForExit(random.Next(50, 900)))
                        process.Kill();
                    End(process);
                }
            using (var process = Start(lines[i]))
                Assert.That(End(process), Is.EqualTo(ExitStatus.Done), string.Join(" ", lines[i]));
        }
        using (var process = Start("commit", m_cloud.Plan))
        {
            if (!process.WaitForExit(400))
                process.Kill();
            End(process);
        }
        CommitAndCompare();
        Assert.That(m_cloud.Scratches.Where(s => !s.EndsWith("-commit", StringComparison.Ordinal)), Is.Empty);
    }

    [Test]
    public void Build_InTwoCopiesAtOnce_IsDoneOnce()
    {
        m_cloud.MakePlan("tiles", 500_000);
        using (var one = Start("build", m_cloud.Plan, "--task", "0"))
        using (var other = Start("build", m_cloud.Plan, "--task", "0"))
            Assert.That((End(one), End(other)), Is.EqualTo((ExitStatus.Done, ExitStatus.Done)));
        Assert.That(m_cloud.Scratches, Is.Empty);
        m_cloud.RunTasks();
        CommitAndCompare();
    }

    // With temporary files, so that what was read is not read again.
    [Test]
    public void Sigterm_WithTemporaryFiles_GoesOnFromThem()
    {
        Directory.CreateDirectory(m_cloud.Scratch["tiles"]);
        ClusterCloud.Done("demo-cloud", "-o", m_cloud.Scratch["tiles/many.las"], "--tile", m_cloud.Sources("las"),
            "--times", "60", "--quiet");
        m_cloud.MakePlan("tiles", 100_000_000);
        string[] line = ["build", m_cloud.Plan, "--task", "0", "--memory", LittleMemory];
        using (var process = Start(line))
        {
            while (!process.HasExited && !m_cloud.Scratches.Any(s => File.Exists(Path.Combine(s, "part.part/build.json"))))
                Thread.Sleep(5);
            using (var kill = Process.Start("kill", ["-TERM", process.Id.ToString()]))
                kill.WaitForExit();
            Assert.That(End(process), Is.EqualTo(ExitStatus.Cancelled));
        }
        Assert.That(m_cloud.Scratches.Length, Is.EqualTo(1));
        Assert.That(File.Exists(Path.Combine(m_cloud.Scratches[0], "part.part/build.json")));
        m_cloud.RunTasks(null, "--memory", LittleMemory);
        Assert.That(m_cloud.Scratches, Is.Empty);
        CommitAndCompare();
    }

    // A file-size limit stands for a disk that is full.
    [Test]
    public void Build_OnAFullDisk_FailsAndMayBeRunAgain()
    {
        m_cloud.MakePlan("tiles", 500_000);
        var start = new ProcessStartInfo("bash", ["-c", "ulimit -f 100; trap '' XFSZ; exec \"$@\"", "bash",
            Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"), "build", m_cloud.Plan, "--task", "0", "--scratch",
            m_cloud.Scratch["scratch"], "--quiet"])
        { RedirectStandardError = true };
        // The runtime's own files would be too large.
        (start.Environment["DOTNET_EnableDiagnostics"], start.Environment["DOTNET_EnableWriteXorExecute"]) = ("0", "0");
        using (var process = Process.Start(start))
        {
            string said = process.StandardError.ReadToEnd();
            process.WaitForExit();
            Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Failed), said);
        }
        Assert.That(File.Exists(Path.Combine(m_cloud.Store, "work/build-000000.json")), Is.False);
        m_cloud.RunTasks();
        CommitAndCompare();
    }
}
