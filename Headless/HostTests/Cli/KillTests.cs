using Random = System.Random;

namespace FastPoints.HostTests.Cli;

public sealed class KillTests
{
    const string LittleMemory = "160MiB";
    const string EnoughMemory = "300MiB";
    const string MuchMemory = "1GiB";

    static Process Convert(string source, string target, string memory, string sampler, string summary = null)
    {
        var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "FastPoints.Cli"))
        {
            RedirectStandardError = true,
            RedirectStandardOutput = true,
        };
        foreach (string arg in new[] { "convert", source, "-o", target, "--memory", memory, "--sampler", sampler, "--quiet" })
            start.ArgumentList.Add(arg);
        if (summary != null)
        {
            start.ArgumentList.Add("--json");
            start.ArgumentList.Add(summary);
        }
        return Process.Start(start);
    }

    static JsonElement ConvertToEnd(string source, string target, string memory, string sampler, string summary)
    {
        using var process = Convert(source, target, memory, sampler, summary);
        string error = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.EqualTo(ExitStatus.Done), error);
        return JsonDocument.Parse(File.ReadAllText(summary)).RootElement;
    }

    static void MakeCloud(ScratchFolder scratch, int points, int times)
    {
        Assert.That(CliCall.Of("demo-cloud", "-o", scratch["one.las"], "--points", points.ToString(), "--quiet").Status, Is.Zero);
        Assert.That(CliCall.Of("demo-cloud", "-o", scratch["cloud.las"], "--tile", scratch["one.las"], "--times",
            times.ToString(),
            "--quiet").Status, Is.Zero);
        File.Delete(scratch["one.las"]);
    }

    [TestCase(100_000, 12, 3, LittleMemory, "random")]
    [TestCase(500_000, 40, 20, EnoughMemory, "random", Category = "Long")]
    [TestCase(100_000, 12, 20, LittleMemory, "poisson", Category = "Long")]
    [TestCase(100_000, 12, 20, MuchMemory, "random", Category = "Long")]
    [TestCase(100_000, 12, 20, MuchMemory, "poisson", Category = "Long")]
    public void Kill_AtRandomTimes_SameCommandResumesToTheSameBytes(int points, int times, int kills,
        string memory, string sampler)
    {
        using var scratch = new ScratchFolder();
        MakeCloud(scratch, points, times);
        var watch = Stopwatch.StartNew();
        var whole = ConvertToEnd(scratch["cloud.las"], scratch["whole.fastpoints"], memory, sampler, scratch["whole.json"]);
        double seconds = watch.Elapsed.TotalSeconds;
        if (memory != MuchMemory)
        {
            Assert.That(whole.GetProperty("temporaryBytesPeak").GetInt64(), Is.GreaterThan(0));
            long limit = memory == LittleMemory ? 160 : 300;
            Assert.That(whole.GetProperty("peakResidentBytes").GetInt64(), Is.LessThanOrEqualTo(limit << 20));
        }
        else
        {
            Assert.That(whole.GetProperty("temporaryBytesPeak").GetInt64(), Is.Zero);
        }

        var random = new Random(points);
        int killed = 0;
        for (int i = 0; i < kills; i++)
        {
            using var process = Convert(scratch["cloud.las"], scratch["killed.fastpoints"], memory, sampler);
            if (process.WaitForExit((int)(1000 * seconds * random.NextDouble())))
            {
                Directory.Delete(scratch["killed.fastpoints"], true);
                continue;
            }
            process.Kill();
            process.WaitForExit();
            killed++;
        }
        Assert.That(killed, Is.GreaterThan(0));
        ConvertToEnd(scratch["cloud.las"], scratch["killed.fastpoints"], memory, sampler, scratch["killed.json"]);
        AssertSame(scratch["killed.fastpoints"], scratch["whole.fastpoints"]);
        var verified = CliCall.Of("verify", scratch["killed.fastpoints"], "--against", scratch["cloud.las"], "--quiet");
        Assert.That(verified.Status, Is.Zero, verified.Error + verified.Output);
        Assert.That(Directory.GetDirectories(scratch.Root), Has.Length.EqualTo(2), "nothing is left beside the clouds");
    }

    [Test]
    public void Convert_LockedByAnotherProcess_IsRefusedUntilThatIsKilled()
    {
        using var scratch = new ScratchFolder();
        MakeCloud(scratch, 500_000, 8);
        string target = scratch["cloud.fastpoints"], part = target + ".part", held = Path.Combine(part, "build.lock");
        using (var process = Convert(scratch["cloud.las"], target, LittleMemory, "poisson"))
        {
            // The lock comes first: killed right then, it leaves nothing else.
            while (!process.HasExited && (!File.Exists(held) || new FileInfo(held).Length == 0 ||
                Directory.GetDirectories(part).Length == 0))
                System.Threading.Thread.Yield();
            var refused = CliCall.Of("convert", scratch["cloud.las"], "-o", target, "--quiet");
            Assert.That(refused.Status, Is.EqualTo(ExitStatus.Failed));
            Assert.That(refused.Error, Does.Contain("is being built by process " + process.Id + " on "));
            process.Kill();
            process.WaitForExit();
        }
        using (var next = new CloudFolderWriter(target))
            Assert.That(next.HasLeftovers, Is.True);
        Assert.That(Directory.Exists(part), Is.False);
    }

    [TestCase(500_000, 42, Category = "Long")]
    public void Memory_AnyNumberOfPoints_IsNeverExceeded(int points, int times)
    {
        using var scratch = new ScratchFolder();
        MakeCloud(scratch, points, times);
        var made = ConvertToEnd(scratch["cloud.las"], scratch["cloud.fastpoints"], EnoughMemory, "random", scratch["cloud.json"]);
        Assert.That(made.GetProperty("points").GetInt64(), Is.EqualTo((long)points * times));
        Assert.That(made.GetProperty("peakResidentBytes").GetInt64(), Is.LessThanOrEqualTo(300L << 20));
    }

    static void AssertSame(string got, string wanted)
    {
        string[] files = Directory.GetFiles(wanted, "*", SearchOption.AllDirectories);
        Assert.That(Directory.GetFiles(got, "*", SearchOption.AllDirectories), Has.Length.EqualTo(files.Length));
        foreach (string file in files)
            Assert.That(File.ReadAllBytes(got + file.Substring(wanted.Length)).AsSpan().SequenceEqual(
                File.ReadAllBytes(file)), file);
    }
}
