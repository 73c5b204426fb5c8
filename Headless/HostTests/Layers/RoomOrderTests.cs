namespace FastPoints.HostTests.Layers;

public sealed class RoomOrderTests
{
    [Test]
    public void Sources_OfThePackage_KeepTheOrder() => Assert.That(
        RoomOrder.Assemblies.SelectMany(a =>
            RoomOrder.CheckSources(Path.Combine(Checkout.Repository.PackageRoot, "Runtime", a), a)),
        Is.Empty);

    [Test]
    public void Il_OfThePackage_KeepsTheRoomOrder(
        [ValueSource(typeof(RepoTools.Repository), nameof(RepoTools.Repository.Generations))]
        string generation)
    {
        using GenerationBuilds builds = Checkout.Builds(generation);

        Assert.That(builds.Package.SelectMany(RoomOrder.CheckIl), Is.Empty);
    }

    [TestCase("FastPoints", "Store/A.cs", "using FastPoints;\nnamespace FastPoints.Store { }")]
    [TestCase("FastPoints.Import", "Nodes/A.cs", "using FastPoints.Store;\nnamespace FastPoints.Nodes { }")]
    [TestCase("FastPoints", "Core/A.cs", "// after FastPoints.Store\nnamespace FastPoints { }")]
    [TestCase("FastPoints", "AssemblyInfo.cs", "")]
    [TestCase("FastPoints.Picture", "A.cs", "using FastPoints.Sources;\nnamespace FastPoints.Picture { }")]
    public void CheckSource_OwnAndEarlierRooms_NoProblem(string assembly, string path, string text) =>
        Assert.That(RoomOrder.CheckSource(assembly, path, text), Is.Empty);

    [TestCase("FastPoints", "Core/A.cs", "using FastPoints.Store;\nnamespace FastPoints { }", "uses FastPoints.Store")]
    [TestCase("FastPoints", "Queries/A.cs", "namespace FastPoints.Queries { class A : FastPoints.Reading.B { } }",
        "uses FastPoints.Reading")]
    [TestCase("FastPoints.Import", "Reading/A.cs", "using FastPoints.Nodes;\nnamespace FastPoints.Reading { }",
        "comes after Reading")]
    [TestCase("FastPoints", "Core/A.cs", "namespace FastPoints.Store { }", "wanted FastPoints")]
    [TestCase("FastPoints", "Attic/A.cs", "namespace FastPoints.Attic { }", "no room Attic")]
    [TestCase("FastPoints", "A.cs", "namespace FastPoints { }", "has no room FastPoints")]
    public void CheckSource_PlantedViolation_IsReported(string assembly, string path, string text, string reported) =>
        Assert.That(RoomOrder.CheckSource(assembly, path, text), Has.Some.Contains(reported));

    [Test]
    public void CheckIl_EarlierRoomNamesLaterOne_IsReported()
    {
        using AssemblyDefinition planted = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("FastPoints", new System.Version(1, 0)), "FastPoints", ModuleKind.Dll);
        ModuleDefinition module = planted.MainModule;
        var late = new TypeDefinition("FastPoints.Queries", "Late", TypeAttributes.Public, module.TypeSystem.Object);
        var early = new TypeDefinition("FastPoints", "Early", TypeAttributes.Public, module.TypeSystem.Object);
        early.Fields.Add(new FieldDefinition("Lates", FieldAttributes.Public, new ArrayType(late)));
        module.Types.Add(late);
        module.Types.Add(early);

        Assert.That(RoomOrder.CheckIl(module),
            Has.Some.Contains("FastPoints.Early.Lates (Core) names FastPoints.Queries.Late"));
    }

    [Test]
    public void Files_OfARoom_HaveNoCycles(
        [Values("FastPoints", "FastPoints.Import", "FastPoints.Picture", "FastPoints.Surface", "FastPoints.Rendering",
            "FastPoints.Entities")]
        string assembly)
    {
        using GenerationBuilds builds = Checkout.Builds(RepoTools.Repository.Generations[0]);

        Assert.That(FileCycles.Check(builds.Package.Single(m => m.Assembly.Name.Name == assembly),
            Path.Combine(Checkout.Repository.PackageRoot, "Runtime", assembly)), Is.Empty);
    }

    [TestCase("Core/A.cs", "Core/B.cs", "Core/C.cs", "",
        "Core/A.cs, Core/B.cs, Core/C.cs name one another: B.cs in FastPoints.A.B")]
    [TestCase("Core/A.cs", "Core/B.cs", "Core/A.cs", "", "Core/A.cs, Core/B.cs name one another")]
    [TestCase("Core/A.cs", "Core/B.cs", "Core/A.cs", "Core/A.cs, Core/B.cs", null)]
    [TestCase("Core/A.cs", "Core/B.cs", "Store/C.cs", "", null)]
    [TestCase("Core/A.cs", "Core/A.cs", "Core/A.cs", "", null)]
    [TestCase("Core/A.cs", "Core/A.cs", "Core/A.cs", "Core/A.cs, Core/B.cs", "Core/A.cs, Core/B.cs need no exception")]
    public void FileCycles_ThreeTypesInACircle_AreFound(string a, string b, string c, string kept, string reported)
    {
        using AssemblyDefinition planted = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("FastPoints", new System.Version(1, 0)), "FastPoints", ModuleKind.Dll);
        ModuleDefinition module = planted.MainModule;
        TypeDefinition[] types = new[] { "A", "B", "C" }.Select(n => new TypeDefinition("FastPoints", n,
            TypeAttributes.Public, module.TypeSystem.Object)).ToArray();
        for (int i = 0; i < types.Length; i++)
        {
            TypeDefinition next = types[(i + 1) % types.Length];
            types[i].Fields.Add(new FieldDefinition(next.Name, FieldAttributes.Public, new ArrayType(next)));
            module.Types.Add(types[i]);
        }
        var files = new Dictionary<string, string>
        {
            ["FastPoints.A"] = a,
            ["FastPoints.B"] = b,
            ["FastPoints.C"] = c,
        };

        IEnumerable<string> problems = FileCycles.Check(module, files, kept.Length > 0 ? new[] { kept } : Array.Empty<string>());

        Assert.That(problems, reported == null ? Is.Empty : Has.One.StartsWith(reported));
    }
}
