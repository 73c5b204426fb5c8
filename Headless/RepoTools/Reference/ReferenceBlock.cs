namespace FastPoints.RepoTools.Reference;

public static class ReferenceBlock
{
    private const string Begin = "<!-- RepoTools reference writes what follows -->\n";
    private const string End = "<!-- and this is its end -->\n";

    private static readonly Regex s_examples =
        new Regex(@"^```csharp\n(.*?)^```", RegexOptions.Multiline | RegexOptions.Singleline);

    public static string Replace(string page, string block)
    {
        (int begin, int end) = Find(page);
        return begin < 0
            ? throw new ToolException($"api.md has no reference between {Begin.Trim()} and {End.Trim()}")
            : page[..begin] + block + page[end..];
    }

    public static string Remove(string page)
    {
        (int begin, int end) = Find(page);
        return begin < 0 ? page : page[..begin] + page[end..];
    }

    public static ISet<string> NamesInExamples(string page) => s_examples.Matches(page)
        .SelectMany(m => Regex.Matches(m.Groups[1].Value, @"\w+")).Select(m => m.Value).ToHashSet();

    private static (int Begin, int End) Find(string page)
    {
        int begin = page.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length;
        int end = page.IndexOf(End, StringComparison.Ordinal);
        return begin < Begin.Length || end < begin ? (-1, -1) : (begin, end);
    }
}
