using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace FastPoints.HostTests.Manual;

/// <summary>C# on the pages, compiled as a user's assembly would be: it sees what is public.</summary>
public sealed class ManualExamplesTests
{
    const int MinLines = 5;
    const int MaxLines = 16;

    static readonly string[] s_package =
    {
        "FastPoints", "FastPoints.Import", "FastPoints.Picture", "FastPoints.Rendering", "FastPoints.Entities",
        "FastPoints.Editor", "FastPoints.Surface",
    };

    // As Unity compiles it.
    static readonly CSharpParseOptions s_parse = new CSharpParseOptions(LanguageVersion.CSharp9);
    static readonly Lazy<List<MetadataReference>> s_references = new(() => References().ToList());

    [Test]
    public void Examples_OfAllPages_Compile() => Assert.That(ManualPage.All().SelectMany(Problems), Is.Empty);

    [Test]
    public void Beginnings_OnTheApiPage_HaveAnExampleOnSomePage()
    {
        string code = string.Concat(ManualPage.All().SelectMany(Examples).Select(e => e.Code));

        Assert.That(ManualPage.Of("api.md").TableUnder("## Where to begin")
            .Select(r => ManualPage.Code(r[1]).First().Split('.')[0]).Where(n => !Regex.IsMatch(code, @"\b" + n + @"\b")),
            Is.Empty);
    }

    [Test]
    public void Examples_OnTheApiPage_AreShort() => Assert.That(Examples(ManualPage.Of("api.md"))
        .Select(e => (e.Line, Lines: e.Code.Count(c => c == '\n')))
        .Where(e => e.Lines < MinLines || e.Lines > MaxLines), Is.Empty);

    [TestCase("using FastPoints.Sources;\nPointReaders.Opens(\"a\");\n", "'Opens'", TestName = "a member that is not there")]
    [TestCase("PointReaders.Open(\"a\");\n", "'PointReaders' does not exist", TestName = "a namespace that is not named")]
    [TestCase("using FastPoints;\nnew CoroutineStack(null).Dispose();\n", "inaccessible", TestName = "what is internal")]
    [TestCase("pump.Tick(4);\n", "'pump' does not exist", TestName = "a variable from nowhere")]
    [TestCase("class A\n{\n    int B() => \"c\";\n}\n", "'string' to 'int'", TestName = "a type")]
    public void Problems_PlantedExample_IsFound(string code, string problem) =>
        Assert.That(Problems(new ManualPage("a.md", "Text.\n\n```csharp\n" + code + "```\n")), Has.Some.Contains(problem));

    [TestCase("using FastPoints.Sources;\n\nusing var reader = PointReaders.Open(\"a\");\n", TestName = "statements")]
    [TestCase("class A\n{\n    FastPoints.JobCoroutine m_coroutine = null;\n}\n", TestName = "a type of its own")]
    public void Problems_GoodExample_FindsNone(string code) =>
        Assert.That(Problems(new ManualPage("a.md", "```csharp\n" + code + "```\n")), Is.Empty);

    static IEnumerable<(int Line, string Code)> Examples(ManualPage page) =>
        Regex.Matches(page.Text, @"^```csharp\n([\s\S]*?)^```", RegexOptions.Multiline)
            .Select(m => (page.Text[..m.Index].Count(c => c == '\n') + 2, m.Groups[1].Value));

    static IEnumerable<string> Problems(ManualPage page) => Examples(page).SelectMany(e => Compile(e.Code)
        .Select(d => page.Path + " line " + (e.Line + d.Location.GetLineSpan().StartLinePosition.Line) + ": " + d.GetMessage()));

    static IEnumerable<Diagnostic> Compile(string code)
    {
        var tree = CSharpSyntaxTree.ParseText(code, s_parse);
        bool hasStatements = tree.GetRoot().ChildNodes().Any(n => n is GlobalStatementSyntax);
        var options = new CSharpCompilationOptions(
            hasStatements ? OutputKind.ConsoleApplication : OutputKind.DynamicallyLinkedLibrary, allowUnsafe: true);
        return CSharpCompilation.Create("UsersAssembly", new[] { tree }, s_references.Value, options).GetDiagnostics()
            .Where(d => d.Severity == DiagnosticSeverity.Error);
    }

    static IEnumerable<MetadataReference> References()
    {
        string here = AppContext.BaseDirectory;
        var standIns = Directory.GetFiles(here, "Unity*.dll");
        var framework = Directory.GetFiles(Path.GetDirectoryName(typeof(object).Assembly.Location), "*.dll")
            .Where(f => Regex.IsMatch(Path.GetFileName(f), @"^(System\..*|netstandard|mscorlib)\.dll$|^System\.dll$"));
        return s_package.Select(a => Path.Combine(here, a + ".dll")).Concat(standIns).Concat(framework)
            .Select(f => MetadataReference.CreateFromFile(f));
    }
}
