namespace FastPoints.HostTests.Cli;

public sealed class SignalTests
{
    const int MaxSeconds = 60;

    static Process Start(params string[] args)
    {
        string name = Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli");
        var start = new ProcessStartInfo { RedirectStandardError = true, RedirectStandardOutput = true };
        if (OperatingSystem.IsLinux())
        {
            start.FileName = "env";
            start.ArgumentList.Add("--default-signal=INT");
            start.ArgumentList.Add(name);
        }
        else
        {
            start.FileName = name;
        }
        foreach (string arg in args)
            start.ArgumentList.Add(arg);
        return Process.Start(start);
    }

    [TestCase("INT")]
    [TestCase("TERM")]
    [Platform(Exclude = "Win")]
    public void Signal_WhileWriting_ExitsWith130AndLeavesNothing(string signal)
    {
        using var scratch = new ScratchFolder();
        using var process = Start("demo-cloud", "-o", scratch["big.las"], "--points", "400000000");
        using var limit = new Timer(_ => process.Kill(), null, MaxSeconds * 1000, Timeout.Infinite);
        // The first line of progress: the file is being written.
        string line = process.StandardError.ReadLine();
        Assert.That(line, Does.Contain("points/s"));
        Assert.That(Directory.GetFiles(scratch.Root), Is.Not.Empty);
        using (var kill = Process.Start("kill", new[] { "-" + signal, process.Id.ToString() }))
            kill.WaitForExit();
        string rest = process.StandardError.ReadToEnd();
        Assert.That(process.WaitForExit(20_000), Is.True);
        Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Cancelled), rest);
        Assert.That(rest, Does.EndWith("fastpoints: cancelled\n"));
        Assert.That(Directory.GetFiles(scratch.Root), Is.Empty);
    }

    /// <summary>As from a scheduler that signals all processes of a job, and from the job's shell.</summary>
    [Test]
    [Platform(Exclude = "Win")]
    public void Terminate_SeveralTimes_KeepsWhatIsBuilt()
    {
        using var scratch = new ScratchFolder();
        scratch.Demo("one.las", 500_000);
        CliCall.Of("demo-cloud", "-o", scratch["cloud.las"], "--tile", scratch["one.las"], "--times", "16", "--quiet");
        string target = scratch["cloud.fastpoints"], part = target + ".part";
        using var process = Start("convert", scratch["cloud.las"], "-o", target, "--memory", "300MiB", "--sampler", "poisson",
            "--quiet");
        using var limit = new Timer(_ => process.Kill(), null, MaxSeconds * 1000, Timeout.Infinite);
        while (!process.HasExited && !File.Exists(Path.Combine(part, BuildFiles.JournalName)))
            Thread.Sleep(5);
        // More than two, since those that come before the first is handled are one.
        using (var kill = Process.Start("sh", new[] { "-c", "for i in 1 2 3 4 5 6 7 8; do kill -TERM " + process.Id + "; done" }))
            kill.WaitForExit();
        Assert.That(process.WaitForExit(20_000), Is.True);
        Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Cancelled), process.StandardError.ReadToEnd());
        Assert.That(Directory.EnumerateFiles(part), Is.Not.Empty);
    }
}
