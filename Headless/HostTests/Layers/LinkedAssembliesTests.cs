namespace FastPoints.HostTests.Layers;

public sealed class LinkedAssembliesTests
{
    [Test]
    public void Assemblies_ThatInitializeThemselves_AreKeptByCodeStripping()
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);
        var beginning = builds.Package.Where(m => m.Types.SelectMany(t => t.Methods).Any(IsCalledAtTheStart)).ToList();

        Assert.That(beginning.Select(m => m.Assembly.Name.Name),
            Is.SupersetOf(new[] { "FastPoints.Rendering.BuiltIn", "FastPoints.Rendering.Urp", "FastPoints.Rendering.Hdrp" }));
        // A player has readers where something refers to them: they register themselves then.
        Assert.That(
            beginning.Where(m => !m.Assembly.CustomAttributes.Any(a => a.AttributeType.Name == "AlwaysLinkAssemblyAttribute"))
            .Select(m => m.Assembly.Name.Name), Is.EqualTo(new[] { "FastPoints.Import" }));
    }

    static bool IsCalledAtTheStart(MethodDefinition method) =>
        method.CustomAttributes.Any(a => a.AttributeType.Name == "RuntimeInitializeOnLoadMethodAttribute");
}
