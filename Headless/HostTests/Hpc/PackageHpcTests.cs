using UnityOutside.Hpc;

namespace FastPoints.HostTests.Hpc;

[TestFixtureSource(typeof(RepoTools.Repository), nameof(RepoTools.Repository.Generations))]
public sealed class PackageHpcTests(string generation)
{
    private readonly string m_generation = generation;

    [Test]
    public void Jobs_OfThePackage_AreAcceptedByBurst()
    {
        using GenerationBuilds builds = Checkout.Builds(m_generation);
        var verifier = new HpcVerifier(builds.Package);

        Assert.That(verifier.Verify(_ => true), Is.Empty);
        Assert.That(verifier.WalkedCount, Is.GreaterThan(builds.Package.SelectMany(HpcEntries.Jobs).Count()));
    }

    // They call what only managed code can.
    private static readonly string[] s_managedJobs = { "FastPoints.Reading.DecompressJob", "FastPoints.Surface.BakeMeshJob" };

    /// <summary>A job without the attribute runs, slowly, and no walk starts at it. Tests may have such.</summary>
    [Test]
    public void Jobs_OfThePackage_AllHaveBurstCompile()
    {
        using GenerationBuilds builds = Checkout.Builds(m_generation);
        IEnumerable<string> without = builds.Package.Where(m => m.Assembly.Name.Name != "FastPoints.Tests")
            .SelectMany(HpcEntries.Jobs).Where(j => !HpcEntries.IsCompiled(j)).Select(j => j.FullName);

        Assert.That(without, Is.EquivalentTo(s_managedJobs));
    }

    /// <summary>ARMv7 faults on some loads of eight bytes that are not aligned.</summary>
    [Test]
    public void PackedColumns_AreReadWordByWord()
    {
        using GenerationBuilds builds = Checkout.Builds(m_generation);
        MethodDefinition reads = builds.Package.Select(m => m.GetType(typeof(BlockCodec).FullName)).Single(t => t != null)
            .Methods.Single(m => m.Name == "OffsetAt");

        Assert.That(reads.Body.Instructions.Select(i => i.OpCode.Code),
            Has.None.EqualTo(Code.Ldind_I8).And.Some.EqualTo(Code.Ldind_U4));
    }
}
