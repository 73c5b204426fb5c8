namespace FastPoints.HostTests.Layers;

public sealed class AssemblyReferencesTests
{
    [Test]
    public void Asmdefs_OfThePackage_FollowTheTable() =>
        Assert.That(Table().All.SelectMany(AssemblyReferences.CheckTable), Is.Empty);

    [Test]
    public void Projects_OfThePackage_MatchTheAsmdefs()
    {
        string folder = Path.Combine(Checkout.Repository.Headless, "Package");

        Assert.That(Directory.GetDirectories(folder).Select(Path.GetFileName),
            Is.EquivalentTo(Table().All.Where(a => File.Exists(ProjectOf(a))).Select(a => a.Name)));
        Assert.That(Table().All.Where(a => File.Exists(ProjectOf(a)))
            .SelectMany(a => AssemblyReferences.CheckProject(a, ProjectOf(a))), Is.Empty);
    }

    [TestCase("FastPoints", "FastPoints.Import", "must not reference FastPoints.Import")]
    [TestCase("FastPoints.Entities", "FastPoints.Import", "must not reference FastPoints.Import")]
    [TestCase("FastPoints", "GUID:d8b63aba1907145bea998dd612889d6b", "by name, please")]
    [TestCase("FastPoints.Unheard", "Unity.Burst", "not in the table")]
    public void CheckTable_PlantedReference_IsReported(string assembly, string reference, string reported) => Assert.That(
        AssemblyReferences.CheckTable(new Asmdef(assembly, "", new[] { reference }, false)), Has.Some.Contains(reported));

    [Test]
    public void CheckProject_PlantedDifference_IsReported()
    {
        Asmdef asmdef = Table().All.Single(a => a.Name == "FastPoints");
        var planted = asmdef with
        {
            References = asmdef.References.Where(r => r != "Unity.Burst").Append("Unity.Entities").ToArray(),
        };

        Assert.That(AssemblyReferences.CheckProject(planted, ProjectOf(asmdef)), Is.EqualTo(new[]
        {
            "FastPoints.csproj does not reference Unity.Entities, the asmdef does",
            "FastPoints.csproj references Unity.Burst, the asmdef does not",
        }));
    }

    [Test]
    public void Asmdefs_OfThePackage_AreNamedAfterTheirFolders() => Assert.That(
        Table().All.Where(a => a.File.Length > 0).Where(a => Path.GetFileNameWithoutExtension(a.File) != a.Name
            || (!FoldersOf(a.File).Contains(a.Name) && a.Name != "FastPoints.Editor")).Select(a => a.File),
        Is.Empty);

    static string[] FoldersOf(string file)
    {
        string folder = Path.GetDirectoryName(file);
        string name = Path.GetFileName(folder);
        return new[] { name, Path.GetFileName(Path.GetDirectoryName(folder)) + "." + name };
    }

    [Test]
    public void Samples_OfThePackage_AreCompiledByProjects() =>
        Assert.That(SampleAssemblies.Check(SampleAssemblies.Load(Checkout.Repository.PackageRoot)), Is.Empty);

    [Test]
    public void Samples_PlantedReference_IsReported()
    {
        var samples = SampleAssemblies.Load(Checkout.Repository.PackageRoot);
        samples[0] = samples[0] with { References = samples[0].References.Append("Unity.Physics").ToArray() };

        Assert.That(SampleAssemblies.Check(samples), Has.Some.Contains("references Unity.Physics, other samples do not"));
    }

    [TestCase("namespace FastPoints.Samples.Second\n", "wanted namespace FastPoints.Samples.First")]
    [TestCase("using FastPoints.Samples.Second;\nnamespace FastPoints.Samples.First\n", "uses FastPoints.Samples.Second")]
    public void Samples_PlantedSource_IsReported(string text, string reported) =>
        Assert.That(SampleAssemblies.CheckSource("A.cs", text, "First"), Has.Some.Contains(reported));

    private static AssemblyTable Table() => SampleAssemblies.LoadAll(Checkout.Repository.PackageRoot);

    private static string ProjectOf(Asmdef asmdef) =>
        Path.Combine(Checkout.Repository.Headless, "Package", asmdef.Name, asmdef.Name + ".csproj");
}
