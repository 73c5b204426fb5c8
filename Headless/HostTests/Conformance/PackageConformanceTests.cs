namespace FastPoints.HostTests.Conformance;

[TestFixtureSource(typeof(RepoTools.Repository), nameof(RepoTools.Repository.Generations))]
public sealed class PackageConformanceTests(string generation)
{
    private readonly string m_generation = generation;

    [Test]
    public void Package_AgainstTheFullList_UsesOnlyUnitysApi() => Assert.That(Problems(FullList()), Is.Empty);

    [Test]
    public void Package_AgainstTheCommittedList_UsesOnlyUnitysApi()
    {
        Assert.That(Checkout.Repository.UsedApi, Does.Exist, "RepoTools api writes it");

        Assert.That(Problems(UnityApi.LoadUsed(Checkout.Repository.UsedApi)), Is.Empty);
    }

    /// <summary>Constants, enum values and default arguments leave no name in the IL, so the stand-ins must be right.</summary>
    [Test]
    public void StandIns_PublicApi_IsUnitys()
    {
        var audit = new StandInAudit(FullList());
        using GenerationBuilds builds = Checkout.Builds(m_generation);

        Assert.That(builds.StandIns, Is.Not.Empty);
        Assert.That(builds.StandIns.SelectMany(audit.Check), Is.Empty);
    }

    private List<string> Problems(UnityApi api)
    {
        AssemblyTable assemblies = SampleAssemblies.LoadAll(Checkout.Repository.PackageRoot);
        using GenerationBuilds builds = Checkout.Builds(m_generation);
        var conformance = new UnityOutside.Api.Conformance(api, m_generation, assemblies);
        return builds.Package.SelectMany(conformance.Check).ToList();
    }

    private static UnityApi FullList()
    {
        if (!Directory.Exists(Checkout.Repository.FullApi))
            Assert.Ignore($"no list of Unity's signatures in {Checkout.Repository.FullApi}");
        return UnityApi.LoadFull(Checkout.Repository.FullApi, Checkout.Repository.PhysicsApi);
    }
}
