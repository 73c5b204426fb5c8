namespace FastPoints.HostTests.Repository;

public sealed class FlowReportTests
{
    private const string Runtime = "Packages/com.fastpoints.dots/Runtime/FastPoints/";

    private static readonly SourceFile[] s_files =
    {
        File("A/Flow.cs", "namespace N { class Flow { } }"),
        File("A/More.cs", "namespace N { class More<T> { } struct FillJob { } }"),
        File("B/Reader.cs", "namespace N { partial class Reader { } }"),
        File("B/In/Reader.Part.cs", "namespace N { partial class Reader { } }"),
        File("C/Las.cs", "namespace N { class Las { } }"),
        File("D/Ply.cs", "namespace N { class Ply { } }"),
    };

    [TestCase("N.Flow.Run", "A/Flow.cs B/In/Reader.Part.cs B/Reader.cs", TestName = "a base does not reach its kinds")]
    [TestCase("N.Flow.Run, N.Las.Run", "A/Flow.cs B/In/Reader.Part.cs B/Reader.cs C/Las.cs", TestName = "a kind that is named")]
    [TestCase("N.Las.Run", "B/In/Reader.Part.cs B/Reader.cs C/Las.cs", TestName = "a kind reaches its base")]
    [TestCase("N.Ply.Run", "A/More.cs B/In/Reader.Part.cs B/Reader.cs D/Ply.cs", TestName = "code in a type within")]
    public void FilesOf_Functions_AreReachableFiles(string functions, string files)
    {
        FlowGraph graph = Graph();

        Assert.That(graph.FilesOf(graph.Reach(functions.Split(", "))).Select(f => f.Path[Runtime.Length..]),
            Is.EqualTo(files.Split(' ')));
    }

    [TestCase("N.Flow.Walk")]
    [TestCase("N.None.Run")]
    public void Reach_UnknownFunction_Throws(string function) =>
        Assert.That(() => Graph().Reach(new[] { function }), Throws.TypeOf<ToolException>());

    [Test]
    public void Report_OfAFlow_ShowsFigureLimitAndCycle()
    {
        var report = new FlowReport(Table(3, 2), Graph("Flow"));

        Assert.That(report.Problems, Is.Empty);
        Assert.That(report.Figures["flow-files a flow"], Is.EqualTo(3));
        Assert.That(report.Figures["flow-rooms a flow"], Is.EqualTo(2));
        Assert.That(report.Text, Does.Match(@"\na flow +3 +3 +1 +2 +2 +1 +3 +3\n"));
        Assert.That(report.Text, Does.Contain("  in a circle of rooms: FastPoints/A -> FastPoints/B: N.Flow names N.Reader\n"));
        Assert.That(report.Text, Does.Contain("  in a circle of rooms: FastPoints/B -> FastPoints/A: N.Reader names N.Flow\n"));
        Assert.That(report.List("a flow"), Is.EqualTo(new[]
        {
            "FastPoints/A: 1 files, 1 lines", $"  {Runtime}A/Flow.cs",
            "FastPoints/B: 2 files, 2 lines", $"  {Runtime}B/In/Reader.Part.cs", $"  {Runtime}B/Reader.cs",
        }));
    }

    [Test]
    public void Report_RoomsDependingOneWay_HaveNoCycle() =>
        Assert.That(new FlowReport(Table(3, 2), Graph()).Text, Does.Not.Contain("circle"));

    [TestCase(2, 2, "flow-files a flow: 3, the limit is 2")]
    [TestCase(3, 1, "flow-rooms a flow: 2, the limit is 1")]
    public void Report_FlowOverALimit_IsRefused(int files, int rooms, string problem) =>
        Assert.That(new FlowReport(Table(files, rooms), Graph()).Problems, Is.EqualTo(new[] { problem }));

    [Test]
    public void Lowered_LimitsOfAFlow_FallToTheFigures() => Assert.That(
        Table(9, 9).Lowered(new FlowReport(Table(9, 9), Graph()).Figures), Is.EqualTo(Text(3, 2)));

    [TestCase("flow-files\ta\t\t1\t2\tN.A.B\n", "limit below its goal")]
    [TestCase("flow-rooms\ta\t\t1\t\t\n", "no goal")]
    public void Problems_RowOfAFlow_WithoutAGoalBelowItsLimit(string row, string problem) => Assert.That(
        HouseTable.Parse(Text(1, 1) + row).Problems(Array.Empty<string>()), Has.One.Contains(problem));

    private static HouseTable Table(int files, int rooms) => HouseTable.Parse(Text(files, rooms));

    private static string Text(int files, int rooms) => "measure\twhere\teach\tlimit\tgoal\twhy\n" +
        $"flow-files\ta flow\t\t{files}\t1\tN.Flow.Run\nflow-rooms\ta flow\t\t{rooms}\t1\t\n";

    private static SourceFile File(string path, string text) => new SourceFile(Runtime + path, text);

    private static FlowGraph Graph(string readerNames = null)
    {
        using AssemblyDefinition planted = AssemblyDefinition.CreateAssembly(
            new AssemblyNameDefinition("FastPoints", new System.Version(1, 0)), "FastPoints", ModuleKind.Dll);
        ModuleDefinition module = planted.MainModule;
        Dictionary<string, TypeDefinition> types = new[] { "Flow", "More`1", "FillJob", "Reader", "Las", "Ply", "Unknown" }
            .ToDictionary(n => n, n => new TypeDefinition("N", n, TypeAttributes.Public, module.TypeSystem.Object));
        foreach (TypeDefinition type in types.Values)
            module.Types.Add(type);
        types["Las"].BaseType = types["Ply"].BaseType = types["Reader"];
        AddCode(types["Flow"], types["Reader"]);
        AddCode(types["Las"], types["Unknown"]);
        AddCode(types["Unknown"], types["Flow"]);
        AddCode(types["Ply"]);
        var iterator = new TypeDefinition("", "<Run>d__0", TypeAttributes.NestedPrivate, module.TypeSystem.Object);
        types["Ply"].NestedTypes.Add(iterator);
        AddCode(iterator, types["FillJob"]);
        if (readerNames != null)
            AddCode(types["Reader"], types[readerNames]);
        return new FlowGraph(new[] { module }, new HouseSources(s_files).FilesOfTypes());
    }

    private static void AddCode(TypeDefinition type, params TypeDefinition[] named)
    {
        var method = new MethodDefinition("Run", MethodAttributes.Public, type.Module.TypeSystem.Void);
        foreach (TypeDefinition other in named)
            method.Body.Instructions.Add(Instruction.Create(OpCodes.Ldtoken, other));
        type.Methods.Add(method);
    }
}
