namespace FastPoints.RepoTools.House;

/// <summary>How many lines of C# there may be at most, by the part of the work: a given table, of which the repository has a
/// copy.</summary>
/// <param name="problem">What is wrong with the copy; null if nothing is.</param>
public sealed class Ceilings(string text, string source, string? problem = null)
{
    private static readonly string[] s_measures = { "product-lines", "csharp-lines", "outside-lines" };

    private readonly Dictionary<int, string[]> m_cellsOfPart = text.Split('\n').Select(l => l.Split('\t'))
        .Where(c => int.TryParse(c[0], out _)).ToDictionary(c => int.Parse(c[0], CultureInfo.InvariantCulture));

    public string Source => source;
    public string? Problem => problem;

    public static Ceilings Load(string given, string copy)
    {
        string copied = File.ReadAllText(copy);
        if (!File.Exists(given))
            return new Ceilings(copied, copy);
        string text = File.ReadAllText(given);
        return new Ceilings(text, given, text == copied ? null : $"{copy} is no copy of {given}");
    }

    public long? Of(string measure, int part)
    {
        if (!m_cellsOfPart.TryGetValue(part, out string[]? cells) || cells.Length <= s_measures.Length)
            throw new ToolException($"{source}: no ceilings of part {part}");
        int column = Array.IndexOf(s_measures, measure) + 1;
        return column > 0 && cells[column] != "-" ? long.Parse(cells[column], CultureInfo.InvariantCulture) : null;
    }
}
