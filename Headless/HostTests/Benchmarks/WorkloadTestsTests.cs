using Unity.PerformanceTesting;

namespace FastPoints.HostTests.Benchmarks;

public sealed class WorkloadTestsTests
{
    [TearDown]
    public void EndTest() => PerformanceTest.Active = null;

    [Test]
    public void Run_AWorkload_SavesTheGroupsThatTheCommandLineWrites()
    {
        var test = new PerformanceTest();
        new WorkloadTests().Run("loop over native arrays");

        var all = WorkloadList.All();
        var group = WorkloadTurns.Groups(all, all.Where(w => w.Name == "loop over native arrays")).Single();
        var samples = WorkloadTurns.Run(group, new WorkloadContext { Points = 1000 }, new TurnSettings());
        var written = PerformanceResults.Of(samples).Results.Single(r => r.Name.Contains("native"));

        Assert.That(test.SampleGroups.Select(g => (g.Name, (int)g.Unit, g.IncreaseIsBetter, g.Samples.Count)),
            Is.EqualTo(written.SampleGroups.Select(g => (g.Name, g.Unit, g.IncreaseIsBetter, g.Samples.Count))));
        Assert.That(written.ClassName, Is.EqualTo(typeof(WorkloadTests).FullName));
        Assert.That(written.MethodName, Is.EqualTo(nameof(WorkloadTests.Run)));
    }

    [Test]
    public void CompileBurstFirst_ThenAsBefore_RestoresTheOption([Values] bool was)
    {
        var tests = new WorkloadTests();
        BurstCompiler.Options.EnableBurstCompileSynchronously = was;

        tests.CompileBurstFirst();
        Assert.That(BurstCompiler.Options.EnableBurstCompileSynchronously, Is.True);
        tests.CompileBurstAsBefore();

        Assert.That(BurstCompiler.Options.EnableBurstCompileSynchronously, Is.EqualTo(was));
    }

    [TestCase(SeriesUnit.Millisecond, SampleUnit.Millisecond)]
    [TestCase(SeriesUnit.Byte, SampleUnit.Byte)]
    [TestCase(SeriesUnit.Undefined, SampleUnit.Undefined)]
    public void Units_OfTheSeries_AreThoseOfThePackage(SeriesUnit ours, SampleUnit unitys) =>
        Assert.That((int)ours, Is.EqualTo((int)unitys));
}
