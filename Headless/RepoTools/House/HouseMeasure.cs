namespace FastPoints.RepoTools.House;

/// <param name="What">A line of the table; {0} is what one thing may have.</param>
/// <param name="IsSum">The figure is the sum of all amounts; else the number of things with a larger one than they may
/// have.</param>
public sealed record HouseMeasure(string Name, string What, bool IsSum, Func<HouseSources, IEnumerable<Finding>> Find)
{
    private const int SmallFileLines = 25;

    public static readonly IReadOnlyList<HouseMeasure> All = new[]
    {
        new HouseMeasure("product-lines", "lines of C# in the package's Runtime and Editor", true,
            s => s.Product.Select(f => new Finding(f.Path, f.LineCount, $"{f.LineCount} lines"))),
        new HouseMeasure("csharp-lines", "lines of C# in the repository", true,
            s => s.CSharp.Select(f => new Finding(f.Path, f.LineCount, $"{f.LineCount} lines"))),
        new HouseMeasure("outside-lines", "of these, lines below UnityOutside", true,
            s => s.CSharp.Where(f => f.IsOutside).Select(f => new Finding(f.Path, f.LineCount, $"{f.LineCount} lines"))),
        new HouseMeasure("rooms", "rooms of Runtime and Editor: first folders below an assembly's, or the assembly", true,
            s => s.Product.Where(f => f.Room.Length > 0).GroupBy(f => f.Room)
                .Select(g => new Finding(g.Key, 1, $"{g.Count()} files"))),
        new HouseMeasure("public-types", "public types of the package's Runtime and Editor, in no other type", true, PublicTypes),
        new HouseMeasure("small-files", $"files of Runtime and Editor with at most {SmallFileLines} lines", true,
            s => s.Product.Where(f => f.LineCount <= SmallFileLines).Select(f => new Finding(f.Path, 1, $"{f.LineCount} lines"))),
        new HouseMeasure("folders", "folders with more than {0} files of C# or shaders", false,
            s => s.Code.GroupBy(f => f.Folder).Select(g => new Finding(g.Key, g.Count(), $"{g.Count()} files"))),
        new HouseMeasure("parameters",
            "methods with more than {0} parameters, but constructors of records and readonly structs", false,
            s => s.CSharp.SelectMany(f => s.ShapeOf(f).Parameters, (f, c) => Of(f, c, "parameters"))),
        new HouseMeasure("methods", "methods of more than {0} lines", false,
            s => s.CSharp.SelectMany(f => s.ShapeOf(f).Methods, (f, m) => Of(f, m, "lines"))),
        new HouseMeasure("wide-lines", "lines of C# and shaders over {0} columns", false, s => s.Code.SelectMany(Widths)),
        new HouseMeasure("manual-words", "words of the manual's pages for users, without internals and generated reference", true,
            s => s.Manual.Where(f => f.IsForUsers).Select(Words)),
        new HouseMeasure("readme-words", "words of README.md", true, s => s.Readme.Select(Words)),
        new HouseMeasure("long-pages", "pages of the manual, internals too, of more than {0} words", false,
            s => s.Manual.Select(Words)),
        new HouseMeasure("not-words", "words in names of Runtime and Editor that the glossary says not to use", false, NotWords),
    };

    private static Finding Words(SourceFile page) => new Finding(page.Path, page.WordCount, $"{page.WordCount} words");

    private static Finding Of(SourceFile file, Counted member, string unit) =>
        new Finding(file.Path, member.Amount, $"{member.Amount} {unit}, {member.Name} in line {member.Line}");

    // A partial type is one type in several files.
    private static IEnumerable<Finding> PublicTypes(HouseSources sources) => sources.Product
        .SelectMany(f => sources.ShapeOf(f).Types.Where(t => t.IsPublic), (f, t) => new Finding(f.Path, 1, t.Name))
        .DistinctBy(f => f.What);

    private static IEnumerable<Finding> Widths(SourceFile file)
    {
        int line = 1, start = 0;
        while (start < file.Text.Length)
        {
            int end = file.Text.IndexOf('\n', start);
            if (end < 0)
                end = file.Text.Length;
            yield return new Finding(file.Path, end - start, $"{end - start} columns, line {line}");
            line++;
            start = end + 1;
        }
    }

    private static IEnumerable<Finding> NotWords(HouseSources sources)
    {
        if (sources.Glossary.Count == 0)
            yield break;
        foreach (SourceFile file in sources.Product)
        {
            foreach (Written name in sources.ShapeOf(file).Names)
            {
                foreach (string word in sources.Glossary.FindIn(name.Text))
                    yield return new Finding(file.Path, 1, $"'{word}' in line {name.Line}: {name.Text}");
            }
        }
    }
}

public sealed record Finding(string Path, long Amount, string What);
