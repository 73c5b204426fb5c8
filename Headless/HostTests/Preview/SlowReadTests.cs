namespace FastPoints.HostTests.Preview;

/// <summary>Previews where each read takes 10 ms, or as good as nothing, which are counted and not waited for. Two are under
/// way at once, as the host has two threads for them.</summary>
[NonParallelizable]
public sealed class SlowReadTests
{
    const double SecondsPerRead = 0.01, SecondsPerQuickRead = 1e-6;
    const int AtOnce = 2;

    string m_path = "";

    [SetUp]
    public void NamePath() => m_path = Path.Combine(Path.GetTempPath(), $"fastpoints-slow-{Guid.NewGuid():N}");

    [TearDown]
    public void End()
    {
        SimulatedLatency.Begin(0);
        File.Delete(m_path);
    }

    void WriteSparsePly(int points)
    {
        byte[] header = Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex " + points
            + "\nproperty int x\nproperty int y\nproperty int z\nproperty float intensity\nend_header\n");
        using var file = File.Create(m_path);
        file.Write(header);
        file.SetLength(header.Length + 16L * points);
    }

    void WriteText(int lines)
    {
        using var writer = new StreamWriter(m_path += ".xyz");
        for (int i = 0; i < lines; i++)
            writer.Write(i + " " + i % 1000 + " 7                              \n");
    }

    /// <summary>Waves, and the virtual seconds at which each was there.</summary>
    static List<(int Points, double Seconds)> Take(string path, int wanted, double secondsPerRead, out PreviewSample sample)
    {
        SimulatedLatency.Begin(secondsPerRead);
        using var reader = PointReaders.Open(path);
        if (reader is IPrefixSource { HasPrefixes: true } prefixes)
            JobCoroutine.RunToEnd(prefixes.FindPrefixes(1));
        var waves = new List<(int, double)>();
        using var sampler = new PreviewWaveSampler(reader, wanted, 1);
        sampler.WaveReady += wave => waves.Add((wave.Points, SimulatedLatency.Reads * SecondsPerRead / AtOnce));
        JobCoroutine.RunToEnd(sampler.Run(0, new StageProgress()));
        sample = sampler.TakeSample();
        TestContext.Out.WriteLine(string.Join(", ", waves.Select(w => w.Item1 + " points after " + w.Item2 + " s")));
        return waves;
    }

    [Test]
    public void Ranges_SlowReads_AreFewerAndLonger()
    {
        WriteSparsePly(100_000_000);
        var waves = Take(m_path, 200_000, SecondsPerRead, out var slow);
        Assert.That(slow.Method, Does.Contain("long runs"));
        Assert.That(waves[0].Seconds, Is.LessThan(0.2));
        Assert.That(waves[1].Seconds, Is.LessThan(1));
        Assert.That(waves[2].Seconds, Is.LessThan(9));
        waves = Take(m_path, 200_000, SecondsPerQuickRead, out var quick);
        Assert.That(quick.Method, Does.Not.Contain("long runs"));
        Assert.That(waves[2].Seconds, Is.GreaterThan(60), "what this would have taken with as many reads");
        Assert.That(slow.Count, Is.EqualTo(quick.Count));
        slow.Dispose();
        quick.Dispose();
    }

    [Test]
    public void Ranges_SmallFile_AreTheDefault()
    {
        WriteSparsePly(1_000_000);
        Take(m_path, 20_000, SecondsPerRead, out var sample);
        Assert.That(sample.Method, Does.Not.Contain("long runs"));
        sample.Dispose();
    }

    [Test]
    public void Text_FirstWave_FindsNoMoreThanItShows()
    {
        WriteText(1_600_000);
        var waves = Take(m_path, 200_000, SecondsPerRead, out var sample);
        Assert.That(waves[0].Points, Is.EqualTo(2000));
        Assert.That(waves[0].Seconds, Is.LessThan(0.5));
        Assert.That(waves[1].Seconds, Is.LessThan(5));
        double[] x = Xs(sample);
        sample.Dispose();
        Take(m_path, 200_000, SecondsPerQuickRead, out var quick);
        Assert.That(Xs(quick), Is.EqualTo(x), "what reads take changes nothing about it");
        quick.Dispose();

        static double[] Xs(PreviewSample sample) =>
            sample.Points.Column<long>(AttributeNames.X).ToArray().Take(sample.Count).Select(v => (double)v).ToArray();
    }

    [TestCase("ca13_d.laz")]
    [TestCase("lion.laz")]
    public void Laz_FirstWave_TakesFewReads(string name)
    {
        var waves = Take(TestData.PathOrIgnore("data/" + name), 20_000, SecondsPerRead, out var sample);
        Assert.That(waves[0].Seconds, Is.LessThan(1));
        sample.Dispose();
    }
}
