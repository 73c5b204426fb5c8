using FastPoints.RepoTools.Formats;
using FastPoints.RepoTools.Structs;

namespace FastPoints.HostTests.Repository;

public sealed class FormatTablesTests
{
    private const string Right = """
        # Format
        ### The head: `PlantedHeader`
        | offset | bytes | field |
        |---|---|---|
        | 0 | 4 | `Magic` |
        | 4 | 2 | `Version` |
        | 6 | 8 | `Points` |

        ### Something else
        | 0 | 100 | `Other` |
        """;

    [Test]
    public void Compare_TableAsStruct_NoProblem() => Assert.That(Compare(Right), Is.Empty);

    [TestCase("| 4 | 2 | `Version` |", "| 4 | 4 | `Version` |", "the struct has Version at 4, 2 bytes")]
    [TestCase("| 6 | 8 | `Points` |", "", "the table ends at 6, the struct has 14 bytes")]
    [TestCase("`Points`", "`Count`", "the table has Count at 6, 8 bytes")]
    [TestCase("`PlantedHeader`", "`Unknown`", "no table under a heading with `PlantedHeader`")]
    public void Compare_TableThatDiffers_IsReported(string part, string changed, string reported) =>
        Assert.That(Compare(Right.Replace(part, changed)), Has.Some.Contains(reported));

    private static IReadOnlyList<string> Compare(string markdown)
    {
        using ModuleDefinition module = ModuleDefinition.ReadModule(typeof(FormatTablesTests).Assembly.Location);
        return FormatTables.Compare(markdown, FieldLayout.Marked(new[] { module }, FormatTables.Attribute));
    }
}
