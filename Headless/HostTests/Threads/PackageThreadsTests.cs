namespace FastPoints.HostTests.Threads;

[TestFixtureSource(typeof(RepoTools.Repository), nameof(RepoTools.Repository.Generations))]
public sealed class PackageThreadsTests(string generation)
{
    private readonly string m_generation = generation;

    [Test]
    public void OtherThreads_OfThePackage_UseThreadSafeMembersOnly()
    {
        using GenerationBuilds builds = Checkout.Builds(m_generation);
        IEnumerable<ModuleDefinition> modules = builds.Package.Where(m => !m.Assembly.Name.Name.Contains("Tests"));
        var verifier = new ThreadVerifier(modules, ThreadTable.Load(Checkout.Repository.UsedThreads), m_generation,
            ThreadCommand.NestedWork);

        Assert.That(verifier.Verify(_ => true), Is.Empty);
        Assert.That(verifier.Roots, Has.Some.StartsWith("Task.Run ").And.Some.StartsWith("Thread.ctor ")
            .And.Some.StartsWith("job ").And.Some.StartsWith("constructor of "));
        Assert.That(verifier.WalkedCount, Is.GreaterThan(verifier.Roots.Count()));
    }
}
