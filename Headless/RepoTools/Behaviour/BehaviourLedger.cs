namespace FastPoints.RepoTools.Behaviour;

/// <summary>Headless/Api/behaviour.tsv: what Unity does, beyond its signatures, that the package relies on. A row has its
/// evidence, and either the stand-in and the test that hold it, or the step of the manual's page that would show it in an
/// editor.</summary>
public sealed class BehaviourLedger
{
    private const string Header = "behaviour\twhat\tevidence\tsure\theld by\ttest\tstep";
    private const string Unverified = "unverified";
    private static readonly string[] s_sureties = { "source", "manual", "run", "older", "experience" };
    private static readonly Regex s_key = new Regex("^[a-z0-9]+(-[a-z0-9]+)+$");
    private static readonly Regex s_olderBurst = new Regex(@"com\.unity\.burst (?!1\.8)");
    private static readonly Regex s_test = new Regex(@"^(\w+)\.(\w+)$");

    private readonly List<string[]> m_rows;

    private BehaviourLedger(List<string[]> rows) => m_rows = rows;

    public int Count => m_rows.Count;
    public int UnverifiedCount => m_rows.Count(r => r[5] == Unverified);

    public static BehaviourLedger Parse(string text)
    {
        string[] lines = text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        if (lines.Length == 0 || lines[0] != Header)
            throw new ToolException("behaviour.tsv: the first line is not its header");
        var rows = new List<string[]>();
        foreach (string line in lines.Skip(1))
        {
            string[] cells = line.Split('\t').Select(c => c.Trim()).ToArray();
            if (cells.Length == 6)
                cells = cells.Append("").ToArray();
            if (cells.Length != 7)
                throw new ToolException($"behaviour.tsv: {cells.Length} columns in the row of {cells[0]}");
            rows.Add(cells);
        }
        return new BehaviourLedger(rows.OrderBy(r => r[0], StringComparer.Ordinal).ToList());
    }

    public string Text() => string.Join("\n", m_rows.Select(r => string.Join("\t", r)).Prepend(Header)) + "\n";

    public IEnumerable<string> Problems(IReadOnlyCollection<string> folders, ILookup<string, string> tests,
        IReadOnlySet<string> steps)
    {
        foreach (IGrouping<string, string[]> twice in m_rows.GroupBy(r => r[0]).Where(g => g.Count() > 1))
            yield return $"{twice.Key}: {twice.Count()} rows";
        foreach (string[] row in m_rows)
            foreach (string problem in ProblemsOf(row, folders, tests, steps))
                yield return $"{row[0]}: {problem}";
    }

    public string UnverifiedTable()
    {
        var table = new StringBuilder("| what | step that shows it |\n|---|---|\n");
        foreach (string[] row in m_rows.Where(r => r[5] == Unverified).OrderBy(r => FirstStep(r[6])))
            table.Append(CultureInfo.InvariantCulture, $"| {row[1].Replace("|", "\\|")} | {row[6]} |\n");
        return table.ToString();
    }

    private static int FirstStep(string steps) =>
        int.TryParse(steps.Split(',')[0], NumberStyles.None, CultureInfo.InvariantCulture, out int step) ? step : 0;

    private static IEnumerable<string> ProblemsOf(string[] row, IReadOnlyCollection<string> folders,
        ILookup<string, string> tests, IReadOnlySet<string> steps)
    {
        if (!s_key.IsMatch(row[0]))
            yield return "the key is not of two or more small words joined by '-'";
        if (row[1].Length == 0 || row[2].Length == 0)
            yield return "no behaviour or no evidence";
        if (!s_sureties.Contains(row[3]))
            yield return $"sure is '{row[3]}', not one of {string.Join(", ", s_sureties)}";
        if (row[3] == "source" && s_olderBurst.IsMatch(row[2]) && !row[2].Contains("1.8", StringComparison.Ordinal))
            yield return "sources of a Burst before 1.8 are sure as 'older'";
        if (row[4] != "-" && !folders.Any(f => File.Exists(Path.Combine(f, row[4]))))
            yield return $"there is no {row[4]} in {string.Join(", ", folders.Select(Path.GetFileName))}";
        if (row[5] == Unverified)
        {
            string[] named = row[6].Split(new[] { ',', ' ' }, StringSplitOptions.RemoveEmptyEntries);
            if (named.Length == 0)
                yield return "unverified, and no step of try-in-unity.md shows it";
            foreach (string step in named.Where(s => !steps.Contains(s)))
                yield return $"try-in-unity.md has no step {step}";
            yield break;
        }
        if (row[3] == "experience")
            yield return "nobody looked it up, so no stand-in can hold it: it is unverified";
        if (row[4] == "-")
            yield return "a test without a stand-in or a check that behaves so";
        if (row[6].Length > 0)
            yield return "a test holds it, so it has no step";
        Match test = s_test.Match(row[5]);
        if (!test.Success ||
            !tests[test.Groups[1].Value].Any(t => t.Contains($" {test.Groups[2].Value}(", StringComparison.Ordinal)))
            yield return $"there is no test {row[5]}";
    }
}
