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

    [Test]
    public void Files_OfARoom_NameOneAnotherInNoCircle(
        [Values("FastPoints", "FastPoints.Import", "FastPoints.Rendering", "FastPoints.Entities")] string assembly)
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);

        Assert.That(FileCycles.Check(builds.Package.Single(m => m.Assembly.Name.Name == assembly),
            Path.Combine(Checkout.Repository.PackageRoot, "Runtime", assembly)), Is.Empty);
    }

    [TestCase("Base/A.cs", "Base/B.cs", "Base/C.cs", "",
        "Base/A.cs, Base/B.cs, Base/C.cs name one another: B.cs in FastPoints.Base.A.B")]
    [TestCase("Base/A.cs", "Base/B.cs", "Base/A.cs", "", "Base/A.cs, Base/B.cs name one another")]
    [TestCase("Base/A.cs", "Base/B.cs", "Base/A.cs", "Base/A.cs, Base/B.cs", null)]
    [TestCase("Base/A.cs", "Base/B.cs", "Points/C.cs", "", null)]
    [TestCase("Base/A.cs", "Base/A.cs", "Base/A.cs", "", null)]
    [TestCase("Base/A.cs", "Base/A.cs", "Base/A.cs", "Base/A.cs, Base/B.cs", "Base/A.cs, Base/B.cs need no exception")]
    public void FileCycles_OfThreeTypesInACircle(string a, string b, string c, string kept, string reported)
    {
        using AssemblyDefinition planted = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("FastPoints", new System.Version(1, 0)), "FastPoints", ModuleKind.Dll);
        ModuleDefinition module = planted.MainModule;
        TypeDefinition[] types = new[] { "A", "B", "C" }.Select(n => new TypeDefinition("FastPoints.Base", n,
            TypeAttributes.Public, module.TypeSystem.Object)).ToArray();
        for (int i = 0; i < types.Length; i++)
        {
            TypeDefinition next = types[(i + 1) % types.Length];
            types[i].Fields.Add(new FieldDefinition(next.Name, FieldAttributes.Public, new ArrayType(next)));
            module.Types.Add(types[i]);
        }
        var files = new Dictionary<string, string>
        {
            ["FastPoints.Base.A"] = a,
            ["FastPoints.Base.B"] = b,
            ["FastPoints.Base.C"] = c,
        };

        IEnumerable<string> problems = FileCycles.Check(module, files, kept.Length > 0 ? new[] { kept } : Array.Empty<string>());

        Assert.That(problems, reported == null ? Is.Empty : Has.One.StartsWith(reported));
    }
}
