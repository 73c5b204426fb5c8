namespace FastPoints.HostTests.Benchmarks;

[NonParallelizable]
public sealed class SimulatedWorkersTests
{
    const int Points = 1_000_000;

    static readonly int[] s_workers = [1, 2, 4, 8];

    string m_folder;
    string m_source;
    int m_made;

    [OneTimeSetUp]
    public void MakeSource()
    {
        m_folder = Directory.CreateTempSubdirectory("fastpoints-workers").FullName;
        m_source = TerrainBenchmarkFile.Make(new WorkloadContext { ScratchFolder = m_folder, Points = Points });
    }

    [OneTimeTearDown]
    public void DeleteFolder() => Directory.Delete(m_folder, true);

    /// <param name="max60Ms">Time limits at 60 Hz: ratios would fall if fewer jobs did the same.</param>
    /// <param name="max10Ms">At 10 Hz.</param>
    [TestCase(Sampler.Random, new[] { 1, 1.6, 2.5, 3.3 }, new[] { 834.0, 534, 400, 334 }, new[] { 1300.0, 1100, 1000, 900 })]
    [TestCase(Sampler.Poisson, new[] { 1, 1.6, 2.5, 3.3 }, new[] { 884.0, 567, 417, 350 }, new[] { 1300.0, 1100, 1000, 900 })]
    public void Convert_DuringPlayMode_FollowsTheNumberOfWorkers(Sampler sampler, double[] speedups, double[] max60Ms,
        double[] max10Ms)
    {
        double first = 0;
        for (int i = 0; i < s_workers.Length; i++)
        {
            double alone = ConvertMs(sampler, s_workers[i], 0, 1e9, 50);
            double at60 = ConvertMs(sampler, s_workers[i], 1000.0 / 60, 2, 50);
            first = i == 0 ? alone : first;
            double at10 = ConvertMs(sampler, s_workers[i], 100, 4, 250);
            TestContext.Out.WriteLine(s_workers[i] + FormattableString.Invariant($" workers: {alone:0} ms, {at60:0}, {at10:0}"));
            Assert.That(first / alone, Is.GreaterThanOrEqualTo(speedups[i]), s_workers[i] + " workers");
            Assert.That(at60, Is.LessThanOrEqualTo(max60Ms[i]), s_workers[i] + " workers, at 60 Hz");
            // Eight phases await one another, a frame each: with a million points more workers gain little.
            Assert.That(at10, Is.LessThanOrEqualTo(max10Ms[i] + 0.5), s_workers[i] + " workers, at 10 Hz");
        }
    }

    /// <param name="frameMs">0 to run to the end.</param>
    double ConvertMs(Sampler sampler, int workers, double frameMs, double tickMs, double inFlightMs)
    {
        SimulatedWorkers.Begin(workers, 1, 0.005);
        try
        {
            using var reader = PointReaders.Open(m_source);
            var settings = new ConvertSettings
            {
                Sampler = sampler,
                // Many chunks, so that eight workers have several each.
                PointsPerChunk = 50000,
                Workers = workers,
                InFlightMs = inFlightMs,
                SecondsToFirstGeneration = 1e9,
                SecondsPerGeneration = 1e9,
            };
            var work = ConvertCloud.Run([reader], Path.Combine(m_folder, "c" + m_made++), settings, r => { }, null);
            var coroutine = new JobCoroutine(work, () => SimulatedWorkers.NowMs);
            for (double frame = frameMs; !coroutine.Tick(tickMs); frame = Math.Max(frame, SimulatedWorkers.NowMs) + frameMs)
                if (frameMs > 0)
                    SimulatedWorkers.AdvanceTo(frame);
                else
                    SimulatedWorkers.EndNext();
            return SimulatedWorkers.NowMs;
        }
        finally
        {
            SimulatedWorkers.End();
        }
    }
}
