using FastPoints.Cli.Stability;

namespace FastPoints.HostTests.Cli;

public sealed class StabilityTests
{
    const int Points = 4000;

    static IEnumerable<TestCaseData> Cases()
    {
        foreach (var stabilityCase in StabilityCases.All)
            yield return new TestCaseData(stabilityCase).SetName("Stability_" + stabilityCase.Name);
    }

    [TestCaseSource(nameof(Cases))]
    public void Stability_Case_Holds(StabilityCase stabilityCase)
    {
        string scratch = Directory.CreateTempSubdirectory("fastpoints-stability-").FullName;
        try
        {
            Assert.That(StabilityRun.Run(stabilityCase, Points, scratch, Sampler.Poisson).Problems, Is.Empty);
        }
        finally
        {
            Directory.Delete(scratch, true);
        }
    }
}
