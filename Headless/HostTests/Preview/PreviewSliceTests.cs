namespace FastPoints.HostTests.Preview;

[NonParallelizable]
public sealed class PreviewSliceTests
{
    const int MaxEntries = 1 << 17, MaxRuns = 1 << 14, MaxLookedUp = 1 << 16;

    static Dictionary<string, int> RunsOf(Action work)
    {
        JobTimes.Begin();
        try
        {
            work();
        }
        finally
        {
            s_last = JobTimes.End();
        }
        return s_last.ToDictionary(k => k.Key.Name, k => k.Value.Count);
    }

    static Dictionary<Type, JobRuns> s_last = [];

    static int Slices(int count, int max) => (count + max - 1) / max;

    static void AreCut(Dictionary<string, int> runs, int slices, params string[] jobs)
    {
        foreach (string job in jobs)
            Assert.That(runs.GetValueOrDefault(job), Is.GreaterThanOrEqualTo(slices), job);
    }

    [Test]
    public void Preview_ByRanges_IsSliced()
    {
        const int points = 1_000_000;
        string path = Path.Combine(Path.GetTempPath(), $"fastpoints-slices-{Guid.NewGuid():N}.ply");
        byte[] header = Encoding.ASCII.GetBytes("ply\nformat binary_little_endian 1.0\nelement vertex 4000000"
            + "\nproperty int x\nproperty int y\nproperty int z\nend_header\n");
        try
        {
            // Points of zeros, of which the disk has nothing.
            using (var file = File.Create(path))
            {
                file.Write(header);
                file.SetLength(header.Length + 12 * 4_000_000L);
            }
            using var reader = PointReaders.Open(path);
            var runs = RunsOf(() =>
            {
                using var preview = new PreviewPicture(reader, new PreviewOptions { Points = points });
                JobCoroutine.RunToEnd(preview.Run(new StageProgress()));
                Assert.That(preview.Sample.Count, Is.EqualTo(points));
            });
            AreCut(runs, Slices(points, MaxEntries), "CompactSampleJob", "MeasureBoundsJob");
            AreCut(runs, 3 * Slices(points, MaxEntries), "MeasureRangeJob");
            AreCut(runs, Slices(points / 16, MaxRuns), "RankStrataJob", "PlanWaveJob");
        }
        finally
        {
            File.Delete(path);
        }
    }

    [TestCase(20_000)]
    [TestCase(1_000_000)]
    public void Refining_LargePreview_IsSliced(int blockPoints)
    {
        const int points = 1_000_000, all = 3_000_000, waves = 2;
        using var reader = new VirtualReader(all, blockPoints, false);
        var runs = RunsOf(() =>
        {
            using var sampler = new RefiningSampler(reader, points, 1, null, new BoundsGeo(default, new double3(1500, 1500, 1)));
            JobCoroutine.RunToEnd(sampler.Run(0, new StageProgress()));
            Assert.That(sampler.Sample.Count, Is.EqualTo(points));
        });
        // At a fifth and at a half, and in the end.
        AreCut(runs, (waves + 1) * Slices(points, MaxEntries), "CompactSampleJob");
        AreCut(runs, Slices(all, MaxEntries), "SampleBlockJob");
        AreCut(runs, Slices(all / 2, MaxLookedUp), "AppendPlaceholdersJob");
    }
}
