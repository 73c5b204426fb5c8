namespace UnityOutside.Tests.Hpc;

public sealed class HpcVerifierTests
{
    private ModuleDefinition m_module;
    private HpcVerifier m_verifier;

    [OneTimeSetUp]
    public void ReadOwnIl()
    {
        string file = typeof(HpcVerifierTests).Assembly.Location;
        var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(Path.GetDirectoryName(file));
        m_module = ModuleDefinition.ReadModule(file, new ReaderParameters { AssemblyResolver = resolver, ReadSymbols = true });
        m_verifier = new HpcVerifier(new[] { m_module });
    }

    [OneTimeTearDown]
    public void Close() => m_module.Dispose();

    private static IEnumerable<TestCaseData> Planted() => PlantedAttribute.In(typeof(PlantedJobs)).Select(p =>
        new TestCaseData(p.Type.FullName.Replace('+', '/'), p.Reported).SetName($"Verify_{p.Type.Name}"));

    [TestCaseSource(nameof(Planted))]
    public void Verify_PlantedJob_IsReportedOrNot(string type, string reported)
    {
        IReadOnlyCollection<string> problems = m_verifier.Verify(t => t.FullName == type);

        if (reported == null)
            Assert.That(problems, Is.Empty);
        else
            Assert.That(problems, Has.Some.Contains(reported));
    }

    [Test]
    public void Verify_FaultInACalledMethod_NamesEntryCallsPlaceAndReason()
    {
        string type = typeof(PlantedJobs.CallsDeepJob).FullName.Replace('+', '/');
        string problem = m_verifier.Verify(t => t.FullName == type).Single();

        Assert.That(problem, Does.Match(
            @"^UnityOutside\.Tests\.Hpc\.PlantedJobs\.CallsDeepJob: " +
            @"CallsDeepJob\.Execute > Helpers\.Outer > Helpers\.Inner \(PlantedJobs\.cs:\d+\): makes a System\.Object$"));
    }

    [Test]
    public void Jobs_WithoutBurstCompile_AreFound() => Assert.That(
        HpcEntries.Jobs(m_module).Where(j => !HpcEntries.IsCompiled(j)).Select(j => j.Name),
        Has.Member(nameof(PlantedJobs.UncompiledJob)));
}
