using System.Diagnostics;

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
}
