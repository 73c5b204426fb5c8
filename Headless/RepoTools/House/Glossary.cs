namespace FastPoints.RepoTools.House;

public sealed class Glossary
{
    public const string Path = "Packages/com.fastpoints.dots/Documentation~/internals/glossary.md";

    private static readonly Regex s_part = new Regex("[A-Z]+(?![a-z])|[A-Z]?[a-z]+");
    private static readonly Regex s_mark = new Regex(@"\([^)]*\)|[*_`""]");

    private readonly List<string[]> m_phrases;

    private Glossary(IEnumerable<string> phrases) =>
        m_phrases = phrases.Select(p => Parts(p).ToArray()).Where(p => p.Length > 0).ToList();

    public int Count => m_phrases.Count;

    public static Glossary Parse(string page)
    {
        var defined = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        var refused = new HashSet<string>(StringComparer.OrdinalIgnoreCase);
        bool isInTable = false;
        foreach (string line in page.Split('\n'))
        {
            string[] cells = line.Trim().Trim('|').Split('|').Select(c => s_mark.Replace(c, "").Trim()).ToArray();
            if (!line.StartsWith('|') || cells.Length != 3)
                isInTable = false;
            else if (cells.SequenceEqual(new[] { "word", "meaning", "not" }, StringComparer.OrdinalIgnoreCase))
                isInTable = true;
            else if (isInTable && cells[0].Trim('-', ':').Length > 0)
            {
                defined.UnionWith(Words(cells[0]));
                refused.UnionWith(Words(cells[2]));
            }
        }
        return new Glossary(refused.Except(defined, StringComparer.OrdinalIgnoreCase));
    }

    /// <summary>The refused words in a name in PascalCase, each as often as it is there; several are found where they follow one
    /// another. Comments are for a person to read.</summary>
    public IEnumerable<string> FindIn(string name)
    {
        List<string> parts = Parts(name);
        for (int i = 0; i < parts.Count; i++)
        {
            foreach (string[] phrase in m_phrases)
            {
                if (IsAt(phrase, parts, i))
                    yield return string.Join(' ', phrase);
            }
        }
    }

    private static bool IsAt(string[] phrase, List<string> parts, int at)
    {
        if (at + phrase.Length > parts.Count)
            return false;
        for (int i = 0; i < phrase.Length; i++)
        {
            string part = parts[at + i];
            bool isLast = i == phrase.Length - 1;
            if (part != phrase[i] && !(isLast && part == phrase[i] + "s"))
                return false;
        }
        return true;
    }

    private static IEnumerable<string> Words(string cell) =>
        cell.Split(',').Select(w => w.Trim()).Where(w => w.Any(char.IsLetter));

    private static List<string> Parts(string text) => s_part.Matches(text).Select(m => m.Value.ToLowerInvariant()).ToList();
}
