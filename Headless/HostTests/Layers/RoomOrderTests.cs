using FastPoints.RepoTools.Layers;

namespace FastPoints.HostTests.Layers;

public sealed class RoomOrderTests
{
    [Test]
    public void Sources_OfThePackage_KeepTheOrder() => Assert.That(
        RoomOrder.Assemblies.SelectMany(a =>
            RoomOrder.CheckSources(Path.Combine(Checkout.Repository.PackageRoot, "Runtime", a), a)),
        Is.Empty);

    [Test]
    public void Il_OfThePackage_KeepsTheOrder(
        [ValueSource(typeof(RepoTools.Repository), nameof(RepoTools.Repository.Generations))]
        string generation)
    {
        using GenerationBuilds builds = Checkout.Builds(generation);

        Assert.That(builds.Package.SelectMany(RoomOrder.CheckIl), Is.Empty);
    }

    [TestCase("FastPoints", "Points/A.cs", "using FastPoints.Base;\nnamespace FastPoints.Points { }")]
    [TestCase("FastPoints.Import", "Nodes/A.cs", "using FastPoints.Store;\nnamespace FastPoints.Nodes { }")]
    [TestCase("FastPoints", "Base/A.cs", "// after FastPoints.Points\nnamespace FastPoints.Base { }")]
    [TestCase("FastPoints", "AssemblyInfo.cs", "")]
    public void CheckSource_OwnAndEarlierRooms_NoProblem(string assembly, string path, string text) =>
        Assert.That(RoomOrder.CheckSource(assembly, path, text), Is.Empty);

    [TestCase("FastPoints", "Base/A.cs", "using FastPoints.Points;\nnamespace FastPoints.Base { }", "uses FastPoints.Points")]
    [TestCase("FastPoints", "Picture/A.cs", "namespace FastPoints.Picture { class A : FastPoints.Files.B { } }",
        "uses FastPoints.Files")]
    [TestCase("FastPoints.Import", "Files/A.cs", "using FastPoints.Nodes;\nnamespace FastPoints.Files { }", "comes after Files")]
    [TestCase("FastPoints", "Base/A.cs", "namespace FastPoints.Points { }", "wanted FastPoints.Base")]
    [TestCase("FastPoints", "Attic/A.cs", "namespace FastPoints.Attic { }", "no room Attic")]
    [TestCase("FastPoints", "A.cs", "namespace FastPoints { }", "is in no room")]
    public void CheckSource_PlantedFault_IsReported(string assembly, string path, string text, string reported) =>
        Assert.That(RoomOrder.CheckSource(assembly, path, text), Has.Some.Contains(reported));

    [Test]
    public void CheckIl_EarlierRoomNamesLaterOne_IsReported()
    {
        using AssemblyDefinition planted = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("FastPoints", new System.Version(1, 0)), "FastPoints", ModuleKind.Dll);
        ModuleDefinition module = planted.MainModule;
        var late = new TypeDefinition("FastPoints.Picture", "Late", TypeAttributes.Public, module.TypeSystem.Object);
        var early = new TypeDefinition("FastPoints.Base", "Early", TypeAttributes.Public, module.TypeSystem.Object);
        early.Fields.Add(new FieldDefinition("Lates", FieldAttributes.Public, new ArrayType(late)));
        module.Types.Add(late);
        module.Types.Add(early);

        Assert.That(RoomOrder.CheckIl(module),
            Has.Some.Contains("FastPoints.Base.Early.Lates (Base) names FastPoints.Picture.Late"));
    }
}
