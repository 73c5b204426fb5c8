namespace FastPoints.HostTests.Cli;

public sealed class StopTests : ScratchPerTest
{
    const string LittleMemory = "160MiB";

    string m_cloud, m_target, m_part;

    [SetUp]
    public void MakeCloud()
    {
        m_cloud = Scratch.Demo("cloud.las", 20_000);
        m_target = Scratch["cloud.fastpoints"];
        m_part = m_target + ".part";
    }

    string[] Convert(params string[] more) => ["convert", m_cloud, "-o", m_target, "--memory", LittleMemory, "--quiet", .. more];

    void LeaveABuild()
    {
        Directory.CreateDirectory(m_part);
        File.WriteAllText(Path.Combine(m_part, "build.json"), "{}");
    }

    [Test]
    public void Stop_ResumableBuild_KeepsItAndNamesTheCommand()
    {
        LeaveABuild();
        var call = CliCall.Of(new CancellationToken(true), Convert());
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Cancelled));
        Assert.That(call.Error, Does.Contain(m_target + " is kept, and this goes on: ./fastpoints "
            + string.Join(" ", Convert())));
        Assert.That(File.Exists(Path.Combine(m_part, "build.json")), Is.True);
        Assert.That(CliCall.Of(Convert()).Status, Is.Zero, "the same command");
        Assert.That(Directory.Exists(m_part), Is.False);
    }

    [Test]
    public void Stop_WithDiscard_KeepsNothing()
    {
        LeaveABuild();
        var call = CliCall.Of(new CancellationToken(true), Convert("--discard"));
        Assert.That(call.Status, Is.EqualTo(ExitStatus.Cancelled));
        Assert.That(call.Error, Is.EqualTo("fastpoints: cancelled" + Environment.NewLine));
        Assert.That(Directory.Exists(m_part), Is.False);
    }

    [Test]
    public void Stop_DuringAReport_LeavesNothing([Values(false, true)] bool wasThere)
    {
        string folder = Scratch["report"];
        if (wasThere)
            Assert.That(CliCall.Of(m_cloud, "-o", folder, "--quiet").Status, Is.Zero);
        var before = wasThere ? Directory.GetFileSystemEntries(folder) : [];
        string summary = wasThere ? File.ReadAllText(Path.Combine(folder, "report.json")) : null;
        using var stop = new CancellationTokenSource();
        var began = DateTime.UtcNow;
        bool isDone = false;
        var watch = Task.Run(() =>
        {
            while (!Volatile.Read(ref isDone) && !(File.GetLastWriteTimeUtc(Path.Combine(folder, "preview.png")) > began))
                Thread.Yield();
            stop.Cancel();
        });

        var call = CliCall.Of(stop.Token, m_cloud, "-o", folder, "--quiet");
        Volatile.Write(ref isDone, true);
        watch.Wait();

        Assert.That(call.Status, Is.EqualTo(ExitStatus.Cancelled), call.Error);
        string[] left = Directory.Exists(folder) ? Directory.GetFileSystemEntries(folder) : [];
        // A build that took long goes on; it needs the name of its source.
        if (left.Any(path => path.EndsWith(StoreFormat.UnfinishedSuffix)))
            left = left.Where(path => before.Contains(path)).ToArray();
        Assert.That(left, Is.EquivalentTo(before));
        if (wasThere)
            Assert.That(File.ReadAllText(Path.Combine(folder, "report.json")), Is.EqualTo(summary));
    }

    [Test]
    public void Stop_Twice_KeepsNothing()
    {
        LeaveABuild();
        using var error = new StringWriter();
        var stopped = new CancellationToken(true);
        int status = CommandLine.Run(Convert(), TextWriter.Null, error, false, stopped, stopped);
        Assert.That(status, Is.EqualTo(ExitStatus.Cancelled));
        Assert.That(error.ToString(), Is.EqualTo("fastpoints: cancelled" + Environment.NewLine));
        Assert.That(Directory.Exists(m_part), Is.False);
    }

    [Test]
    [Platform(Exclude = "Win")]
    public void Sigterm_WithTemporaryFiles_KeepsThemForTheSameCommand()
    {
        for (int times = 40; ; times *= 2)
        {
            Assert.That(CliCall.Of("demo-cloud", "-o", Scratch["many.las"], "--tile", m_cloud, "--times", times.ToString(),
                "--quiet").Status, Is.Zero);
            string[] args = ["convert", Scratch["many.las"], "-o", m_target, "--memory", LittleMemory, "--quiet"];
            using var process = Process.Start(new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"), args)
            {
                RedirectStandardError = true,
            });
            while (!process.HasExited && !File.Exists(Path.Combine(m_part, "build.json")))
                Thread.Yield();
            using (var kill = Process.Start("kill", new[] { "-TERM", process.Id.ToString() }))
                kill.WaitForExit();
            string said = process.StandardError.ReadToEnd();
            process.WaitForExit();
            if (process.ExitCode == ExitStatus.Done && times < 1000)
            {
                Directory.Delete(m_target, true);
                continue;
            }
            Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Cancelled), said);
            Assert.That(said, Does.Contain("this goes on: ./fastpoints convert " + Scratch["many.las"]));
            var next = CliCall.Of(args.Where(a => a != "--quiet").ToArray());
            Assert.That(next.Status, Is.Zero, next.Error);
            Assert.That(next.Output, Does.Contain("continued a build that was broken off"));
            return;
        }
    }
}
