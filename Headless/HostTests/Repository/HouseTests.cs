namespace FastPoints.HostTests.Repository;

public sealed class HouseTests
{
    private const string Header = "measure\twhere\teach\tlimit\tgoal\twhy\n";
    private const string Room = "Packages/com.fastpoints.dots/Runtime/FastPoints/Room/";
    private const string Manual = "Packages/com.fastpoints.dots/Documentation~/";

    private static readonly string[] s_measures =
    {
        "product-lines", "csharp-lines", "outside-lines", "rooms", "public-types", "small-files", "folders", "parameters",
        "methods", "wide-lines", "manual-words", "readme-words", "long-pages", "not-words",
    };

    private static readonly SourceFile s_glossary = new SourceFile(Manual + "internals/glossary.md",
        "| Word | Meaning | Not |\n|---|---|---|\n| **run** | points in a row | span, `slice` (of a file), page |\n" +
        "| page | a part of the view | bare cell, Sees, `TryPredictView`, Most... |\n\n| other | table | heap |\n");

    private static readonly Ceilings s_ceilings = new Ceilings("# remark\npart\tproduct\tall\toutside\n1\t9\t6\t-\n", "a.tsv");

    [TestCase("product-lines", 3)]
    [TestCase("csharp-lines", 6)]
    [TestCase("outside-lines", 1)]
    [TestCase("public-types", 2)]
    [TestCase("small-files", 2)]
    [TestCase("manual-words", 3)]
    [TestCase("readme-words", 2)]
    public void Figure_FewFiles_IsTheirSum(string measure, int figure)
    {
        SourceFile[] files =
        {
            new SourceFile(Room + "A.cs", "namespace A { public partial class B<T> { public class Inner { } } " +
                "public enum C { }\n}\n"),
            new SourceFile(Room + "A.More.cs", "namespace A { public partial class B<T> { } internal struct D { } }"),
            new SourceFile("Headless/Cli/A.cs", "public class E\n{ }"),
            new SourceFile("UnityOutside/A/A.cs", "class F { }"),
            new SourceFile(Manual + "a.md", "Three small\n\nwords.\n"),
            new SourceFile(Manual + "internals/b.md", "Of developers.\n"),
            new SourceFile("README.md", "Two words.\n"),
            new SourceFile("Projects/README.md", "Another.\n"),
        };

        Assert.That(Report(files).Figures[measure], Is.EqualTo(figure));
    }

    [TestCase(1, "Runtime/A/Base/A.cs", "Runtime/A/Base/In/B.cs", "Runtime/A/AssemblyInfo.cs")]
    [TestCase(2, "Runtime/A/Base/A.cs", "Runtime/A/Store/A.cs")]
    [TestCase(2, "Runtime/A/Base/A.cs", "Runtime/B/Base/A.cs")]
    [TestCase(2, "Runtime/A/A.cs", "Runtime/A/Urp/A.cs")]
    [TestCase(1, "Runtime/FastPoints.Entities/Systems/A.cs", "Runtime/FastPoints.Entities/Components/A.cs")]
    [TestCase(2, "Editor/Scene/A.cs", "Editor/Player/In/A.cs", "Editor/AssemblyInfo.cs", "Tests/A/A.cs")]
    public void Figure_Rooms_AreFirstFoldersOfAssemblies(int figure, params string[] paths) => Assert.That(
        Report(paths.Select(p => new SourceFile("Packages/com.fastpoints.dots/" + p, "")).ToArray()).Figures["rooms"],
        Is.EqualTo(figure));

    [Test]
    public void Figure_FolderOfThirtyOneFiles_IsCounted()
    {
        IEnumerable<SourceFile> thirty = Enumerable.Range(0, 30).Select(i => new SourceFile($"{Room}{i}.cs", ""));

        Assert.That(Report(thirty.ToArray()).Figures["folders"], Is.EqualTo(0));
        Assert.That(Report(thirty.Append(new SourceFile(Room + "a.hlsl", "")).ToArray()).Figures["folders"], Is.EqualTo(1));
        Assert.That(Report(thirty.Append(new SourceFile(Room + "In/a.cs", "")).ToArray()).Figures["folders"], Is.EqualTo(0));
    }

    [TestCase("class A { A({7}) { } }", 1)]
    [TestCase("class A { A({6}) { } void B({6}) { } }", 0)]
    [TestCase("class A { void B({7}) { } }", 1)]
    [TestCase("record A { static void B({7}) { } }", 1)]
    [TestCase("class A { void B() { C(); void C({7}) { } } }", 1)]
    [TestCase("class A { struct B { public B({7}) { } } }", 1)]
    [TestCase("class A({7}) { }", 1)]
    [TestCase("record A({7});", 0)]
    [TestCase("record A { A({7}) { } }", 0)]
    [TestCase("readonly struct A { A({7}) { } }", 0)]
    [TestCase("#if ENABLE_UNITY_COLLECTIONS_CHECKS\nclass A { A({7}) { } }\n#endif", 1)]
    public void Figure_MethodOfSevenParameters_IsCounted(string code, int figure)
    {
        string seven = string.Join(", ", Enumerable.Range(0, 7).Select(i => $"int a{i}"));
        code = code.Replace("{7}", seven).Replace("{6}", seven[..^", int a6".Length]);

        Assert.That(Report(new SourceFile("Headless/A.cs", code)).Figures["parameters"], Is.EqualTo(figure));
    }

    [TestCase("[Test]\nvoid B()\n{", 78, 0)]
    [TestCase("[Test]\nvoid B()\n{", 79, 1)]
    [TestCase("int B\n{ get {", 78, 0)]
    [TestCase("int B\n{ get {", 79, 1)]
    public void Figure_MethodOverEightyLines_IsCounted(string head, int lineEnds, int figure)
    {
        string braces = head.StartsWith("int", StringComparison.Ordinal) ? "} }" : "}";
        var file = new SourceFile("Headless/A.cs", "class A\n{\n" + head + new string('\n', lineEnds) + braces + "\n}\n");

        Assert.That(Report(file).Figures["methods"], Is.EqualTo(figure));
    }

    [TestCase("Headless/A.cs", 130, 0)]
    [TestCase("Headless/A.cs", 131, 1)]
    [TestCase("Packages/com.fastpoints.dots/Shaders/A.hlsl", 131, 1)]
    [TestCase("README.md", 131, 0)]
    public void Figure_LineOver130Columns_IsCounted(string path, int columns, int figure)
    {
        string line = "//" + new string('\u00e9', columns - 2);

        Assert.That(Report(new SourceFile(path, "\n" + line + "\n\n")).Figures["wide-lines"], Is.EqualTo(figure));
        Assert.That(Report(new SourceFile(path, line)).Figures["wide-lines"], Is.EqualTo(figure));
    }

    [Test]
    public void Figure_PageOver1500Words_IsCounted()
    {
        string words = string.Concat(Enumerable.Repeat("word ", 1500));

        Assert.That(Report(new SourceFile(Manual + "a.md", words)).Figures["long-pages"], Is.EqualTo(0));
        Assert.That(Report(new SourceFile(Manual + "a.md", words + "more")).Figures["long-pages"], Is.EqualTo(1));
        Assert.That(Report(new SourceFile(Manual + "internals/a.md", words + "more")).Figures["long-pages"], Is.EqualTo(1));
    }

    [Test]
    public void Figure_GeneratedReference_HasNoWords() => Assert.That(Report(new SourceFile(Manual + "api.md",
        "One.\n<!-- RepoTools reference writes what follows -->\ntwo three\n<!-- and this is its end -->\nFour.\n"))
            .Figures["manual-words"], Is.EqualTo(16));

    [TestCase("class FirstSpan { }", 1, TestName = "a type")]
    [TestCase("class A { int m_spanLength; void SpansOf(int span) { int slices = 0; } }", 4, TestName = "members and locals")]
    [TestCase("class A { Span<int> B() => C.Slice(0); }", 0, TestName = "names of others")]
    [TestCase("class A { int Spanned, Lifespan, SpaN; }", 0, TestName = "parts of words")]
    [TestCase("class A { int HTTPSlice, BareCells, Bare, CellBare; }", 2, TestName = "capitals and two words")]
    [TestCase("class A { int Page; } // a page", 0, TestName = "words with a row of their own")]
    [TestCase("class A { int File, Heap; }", 0, TestName = "remarks and other tables")]
    [TestCase("/// <summary>Spans.</summary>\nclass A { } // a slice\n/* bare cells */", 0, TestName = "comments")]
    [TestCase("class A { int MostFrameMs, m_most; bool Sees() { } bool See(); }", 3, TestName = "first words, verbs")]
    [TestCase("class A { void TryPredictView() { } void Try() { } void ForeseeTry() { } }", 1, TestName = "words in their order")]
    [TestCase("class A { string b = \"span\"; }", 0, TestName = "literals")]
    public void Figure_WordRefusedByTheGlossary_IsCounted(string code, int figure) =>
        Assert.That(Report(s_glossary, new SourceFile(Room + "A.cs", code)).Figures["not-words"], Is.EqualTo(figure));

    [Test]
    public void Text_WithoutGlossary_ReportsIt()
    {
        Assert.That(Report(new SourceFile(Room + "A.cs", "class Span { }")).Figures["not-words"], Is.EqualTo(0));
        Assert.That(Report().Text(), Does.Contain("glossary.md yet"));
        Assert.That(Report(s_glossary).Text(), Does.Not.Contain("glossary.md yet"));
    }

    [Test]
    public void Problems_FigureOverItsLimit_NamesTheMeasure()
    {
        var files = new[] { new SourceFile("Headless/A.cs", "\n" + new string('/', 131)) };

        Assert.That(Report(files).Problems, Is.Empty);
        Assert.That(Report(HouseTable.Parse(Text().Replace("\t130\t9", "\t130\t0")), files).Problems,
            Is.EqualTo(new[] { "wide-lines: 1, the limit is 0", "  Headless/A.cs: 131 columns, line 2" }));
    }

    [TestCase(6, 0)]
    [TestCase(7, 1)]
    public void Problems_LinesAboveTheCeilingOfThePart_AreRefused(int lines, int problems)
    {
        HouseReport report = Report(new SourceFile("Headless/A.cs", new string('\n', lines)));

        Assert.That(report.Problems, Has.Exactly(problems).EqualTo("csharp-lines: 7, the limit is 6"));
        Assert.That(report.Text(), Does.Contain("part 1 in a.tsv"));
    }

    [TestCase("product-lines", 9)]
    [TestCase("outside-lines", null)]
    [TestCase("folders", null)]
    public void Ceilings_OfAMeasure_AreRead(string measure, long? lines) =>
        Assert.That(s_ceilings.Of(measure, 1), Is.EqualTo(lines));

    [TestCase("")]
    [TestCase("2\t1\t1\t1\n")]
    [TestCase("1\t1\n")]
    public void Ceilings_WithoutThePart_Throw(string text) =>
        Assert.That(() => new Ceilings(text, "a.tsv").Of("folders", 1), Throws.TypeOf<ToolException>());

    [TestCase("1\t2\t3\t4\n", null)]
    [TestCase("1\t5\t3\t4\n", "copy.tsv is no copy of")]
    public void Ceilings_CopyThatDiffers_IsAProblem(string copied, string problem)
    {
        DirectoryInfo root = Directory.CreateTempSubdirectory("fastpoints-house-");
        try
        {
            string given = Path.Combine(root.FullName, "given.tsv"), copy = Path.Combine(root.FullName, "copy.tsv");
            File.WriteAllText(copy, copied);
            Assert.That(Ceilings.Load(given, copy).Source, Is.EqualTo(copy));

            File.WriteAllText(given, "1\t2\t3\t4\n");
            var ceilings = Ceilings.Load(given, copy);
            Assert.That((ceilings.Source, ceilings.Of("product-lines", 1)), Is.EqualTo((given, 2L)));
            Assert.That(ceilings.Problem, problem == null ? Is.Null : Does.Contain(problem));
        }
        finally
        {
            root.Delete(true);
        }
    }

    [TestCase("wide-lines\tHeadless/A.cs\t140\t\t\tA table.\n", 0)]
    [TestCase("wide-lines\tA.cs\t140\t\t\tA table.\n", 0)]
    [TestCase("wide-lines\tHeadless/\t140\t\t\tA table.\n", 0)]
    [TestCase("wide-lines\tA.cs\t139\t\t\tA table.\n", 1)]
    [TestCase("methods\tA.cs\t140\t\t\tA table.\n", 1)]
    [TestCase("wide-lines\ts\t140\t\t\tA table.\n", 1)]
    public void Figure_Exception_CountsBeyondItsOwnLimit(string row, int figure) =>
        Assert.That(Report(Table(row), new SourceFile("Headless/A.cs", new string('/', 140))).Figures["wide-lines"],
            Is.EqualTo(figure));

    [TestCase("wide-lines\tB.cs\t140\t\t\tA table.\n", "wide-lines needs no exception for B.cs")]
    [TestCase("wide-lines\tA.cs\t140\t\t\t\n", "or no reason")]
    [TestCase("wide-lines\tA.cs\t\t\t\tA table.\n", "has no number of its own")]
    [TestCase("width\tA.cs\t140\t\t\tA table.\n", "there is no measure width")]
    [TestCase("width\t*\t\t0\t0\t\n", "there is no measure width")]
    public void Problems_RowOfNoUse_IsReported(string row, string problem) =>
        Assert.That(Report(Table(row), new SourceFile("Headless/A.cs", new string('/', 140))).Problems,
            Has.Some.Contains(problem));

    [TestCase("a\tb\n")]
    [TestCase("wide-lines\t*\tmany\t0\t0\t\n")]
    [TestCase("wide-lines\t*\t-1\t0\t0\t\n")]
    public void Parse_InvalidRow_Throws(string row) =>
        Assert.That(() => HouseTable.Parse(Header + row), Throws.TypeOf<ToolException>());

    [Test]
    public void Report_WithoutThePart_Throws() =>
        Assert.That(() => Report(HouseTable.Parse(Text().Replace("part\t*\t1", "part\t*\t"))), Throws.TypeOf<ToolException>());

    [Test]
    public void Report_MeasureWithoutOrWithTwoLimits_Throws()
    {
        string row = "wide-lines\t*\t130\t9\t0\t\n";

        Assert.That(() => Report(HouseTable.Parse(Text().Replace(row, ""))), Throws.TypeOf<ToolException>());
        Assert.That(() => Report(Table(row)), Throws.TypeOf<ToolException>());
    }

    [TestCase(10, 10, TestName = "beyond the limit: it stays")]
    [TestCase(7, 7, TestName = "between goal and limit: it falls")]
    [TestCase(1, 5, TestName = "below the goal: it falls to the goal")]
    public void Lowered_LimitOfNine_FallsToTheFigure(int figure, int limit)
    {
        string text = Header + "folders\t*\t30\t{0}\t5\t\nfolders\tRoom/\t40\t\t\tA room.\n";
        var figures = new Dictionary<string, long> { ["folders"] = figure };

        Assert.That(HouseTable.Parse(text.Replace("{0}", figure == 10 ? "10" : "9")).Lowered(figures),
            Is.EqualTo(text.Replace("{0}", limit.ToString())));
    }

    [Test]
    public void Main_HouseOfAPlantedRepository_PrintsChecksListsAndLowers()
    {
        DirectoryInfo root = Directory.CreateTempSubdirectory("fastpoints-house-");
        try
        {
            string api = Directory.CreateDirectory(Path.Combine(root.FullName, "Headless", "Api")).FullName;
            string table = Path.Combine(api, "house.tsv");
            File.WriteAllText(table, Text());
            File.Copy(Checkout.Repository.Ceilings, Path.Combine(api, "ceilings.tsv"));
            File.WriteAllText(Path.Combine(root.FullName, "A.cs"), new string('/', 131));
            using (Process git = Process.Start("git", new[] { "init", "--quiet", root.FullName }))
                git.WaitForExit();

            Assert.That(RepoToolsTests.Run(Arguments(root, "--check"), out string said), Is.EqualTo(0));
            Assert.That(said, Does.Match(@"\nwide-lines +1 +9 +0  lines of C# and shaders over 130 columns\n"));
            Assert.That(File.ReadAllText(table), Is.EqualTo(Text()));

            Assert.That(RepoToolsTests.Run(Arguments(root), out _), Is.EqualTo(0));
            Assert.That(File.ReadAllText(table), Does.Contain("wide-lines\t*\t130\t1\t0\t"));

            File.WriteAllText(Path.Combine(root.FullName, "B.cs"), new string('/', 132));
            Assert.That(RepoToolsTests.Run(Arguments(root, "--check"), out said), Is.EqualTo(1));
            Assert.That(said, Does.Contain("wide-lines: 2, the limit is 1"));
            Assert.That(RepoToolsTests.Run(Arguments(root, "--list", "wide-lines"), out said), Is.EqualTo(0));
            Assert.That(said, Does.StartWith("B.cs: 132 columns, line 1\nA.cs: 131 columns, line 1\n"));
        }
        finally
        {
            root.Delete(true);
        }
    }

    private static string[] Arguments(DirectoryInfo root, params string[] more) =>
        new[] { "house", "--root", root.FullName }.Concat(more).ToArray();

    private static HouseReport Report(params SourceFile[] files) => Report(Table(), files);

    private static HouseReport Report(HouseTable table, params SourceFile[] files) =>
        new HouseReport(new HouseSources(files), table, s_ceilings);

    private static HouseTable Table(string more = "") => HouseTable.Parse(Text() + more);

    /// <summary>Each measure with a limit of 9 and a goal of 0.</summary>
    private static string Text() => Header + "part\t*\t1\t\t\t\n" +
        string.Concat(s_measures.Select(m => $"{m}\t*\t{Each(m)}\t9\t0\t\n"));

    private static string Each(string measure) => measure switch
    {
        "folders" => "30",
        "parameters" => "6",
        "methods" => "80",
        "wide-lines" => "130",
        "long-pages" => "1500",
        "not-words" => "0",
        _ => "",
    };
}
