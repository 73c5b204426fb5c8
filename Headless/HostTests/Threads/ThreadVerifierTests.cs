namespace FastPoints.HostTests.Threads;

public sealed class ThreadVerifierTests
{
    private ModuleDefinition m_module;
    private ThreadVerifier m_verifier;

    [OneTimeSetUp]
    public void ReadOwnIl()
    {
        string file = typeof(ThreadVerifierTests).Assembly.Location;
        var resolver = new DefaultAssemblyResolver();
        resolver.AddSearchDirectory(Path.GetDirectoryName(file));
        m_module = ModuleDefinition.ReadModule(file, new ReaderParameters { AssemblyResolver = resolver, ReadSymbols = true });
        m_verifier = new ThreadVerifier(new[] { m_module }, ThreadTable.Load(Checkout.Repository.UsedThreads), "6000.0",
            ThreadCommand.NestedWork);
    }

    [OneTimeTearDown]
    public void Close() => m_module.Dispose();

    private static IEnumerable<TestCaseData> Planted() => PlantedAttribute.In(typeof(PlantedThreads)).Select(p =>
        new TestCaseData(p.Type.FullName.Replace('+', '/'), p.Reported).SetName($"Verify_{p.Type.Name}"));

    [TestCaseSource(nameof(Planted))]
    public void Verify_PlantedThread_IsReportedOrNot(string type, string reported)
    {
        IReadOnlyCollection<string> problems = Verify(type);

        if (reported != null)
        {
            Assert.That(problems, Has.Some.Contains(reported));
            return;
        }
        Assert.That(problems, Is.Empty);
        Assert.That(m_verifier.WalkedCount, Is.Positive);
    }

    [Test]
    public void Verify_FaultInACalledMethod_NamesRootCallsPlaceAndMember()
    {
        string problem = Verify(typeof(PlantedThreads.ThroughAnIterator).FullName.Replace('+', '/')).Single();

        Assert.That(problem, Does.Match(
            @"^Task\.Run \(PlantedThreads\.cs:\d+\): ThroughAnIterator\.Begin > " +
            @"PlantedThreads\.Count > PlantedThreads\.Ask \(PlantedThreads\.cs:\d+\): " +
            @"uses UnityEngine\.Application\.get_isPlaying, which is for the main thread \(extern\)$"));
    }

    private IReadOnlyCollection<string> Verify(string type) => m_verifier.Verify(
        t => t.FullName == type || t.FullName.StartsWith(type + "/", StringComparison.Ordinal));
}
