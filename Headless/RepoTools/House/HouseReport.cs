namespace FastPoints.RepoTools.House;

public sealed class HouseReport
{
    private const int FindingsShown = 20;

    private readonly HouseTable m_table;
    private readonly Ceilings m_ceilings;
    private readonly List<HouseFigure> m_figures = new List<HouseFigure>();
    private readonly List<string> m_problems = new List<string>();
    private readonly bool m_hasGlossary;

    public HouseReport(HouseSources sources, HouseTable table, Ceilings ceilings)
    {
        m_table = table;
        m_ceilings = ceilings;
        m_hasGlossary = sources.HasGlossary;
        m_problems.AddRange(table.Problems(HouseMeasure.All.Select(m => m.Name).ToList()));
        if (ceilings.Problem != null)
            m_problems.Add(ceilings.Problem);
        foreach (HouseMeasure measure in HouseMeasure.All)
            Add(measure, measure.Find(sources));
    }

    public IReadOnlyList<string> Problems => m_problems;
    public IReadOnlyDictionary<string, long> Figures => m_figures.ToDictionary(f => f.Measure.Name, f => f.Value);
    public int GoalsMet => m_figures.Count(f => f.Value <= m_table.Of(f.Measure.Name).Goal);

    public IEnumerable<string> List(string measure)
    {
        HouseFigure figure = m_figures.FirstOrDefault(f => f.Measure.Name == measure)
            ?? throw new ToolException($"there is no measure {measure}; "
                + $"{string.Join(", ", m_figures.Select(f => f.Measure.Name))}");
        return figure.Findings.OrderByDescending(f => f.Amount).Select(Line);
    }

    public string Text()
    {
        var text = new StringBuilder($"{"",-14}{"figure",9}{"limit",9}{"goal",9}\n");
        foreach (HouseFigure figure in m_figures)
        {
            HouseRow row = m_table.Of(figure.Measure.Name);
            string what = string.Format(CultureInfo.InvariantCulture, figure.Measure.What, row.Each);
            text.Append(CultureInfo.InvariantCulture,
                $"{figure.Measure.Name,-14}{figure.Value,9:N0}{LimitOf(row),9:N0}{row.Goal,9:N0}  {what}\n");
        }
        text.Append(CultureInfo.InvariantCulture, $"Ceilings are those of part {m_table.Part} in {m_ceilings.Source}.\n");
        if (!m_hasGlossary)
            text.Append(CultureInfo.InvariantCulture, $"There is no {Glossary.Path} yet, so no words were looked for.\n");
        return text.ToString();
    }

    private void Add(HouseMeasure measure, IEnumerable<Finding> all)
    {
        HouseRow row = m_table.Of(measure.Name);
        List<HouseRow> exceptions = m_table.Exceptions.Where(e => e.Measure == measure.Name).ToList();
        var used = new HashSet<HouseRow>();
        var counted = new List<Finding>();
        foreach (Finding finding in all.Where(f => measure.IsSum || f.Amount > (row.Each ?? 0)))
        {
            HouseRow? exception = exceptions.Find(e => e.IsOf(finding.Path));
            if (exception != null)
                used.Add(exception);
            if (exception == null || measure.IsSum || finding.Amount > exception.Each)
                counted.Add(finding);
        }
        foreach (HouseRow idle in exceptions.Where(e => !used.Contains(e) || measure.IsSum))
            m_problems.Add($"house.tsv: {idle.Measure} needs no exception for {idle.Where}");

        var figure = new HouseFigure(measure, measure.IsSum ? counted.Sum(f => f.Amount) : counted.Count, counted);
        m_figures.Add(figure);
        if (LimitOf(row) is long limit && figure.Value > limit)
            Refuse(figure, limit);
    }

    private long? LimitOf(HouseRow row) =>
        m_ceilings.Of(row.Measure, m_table.Part) is long ceiling && ceiling < row.Limit ? ceiling : row.Limit;

    private void Refuse(HouseFigure figure, long limit)
    {
        m_problems.Add(string.Create(CultureInfo.InvariantCulture,
            $"{figure.Measure.Name}: {figure.Value}, the limit is {limit}"));
        if (figure.Measure.IsSum)
            return;
        foreach (Finding finding in figure.Findings.OrderByDescending(f => f.Amount).Take(FindingsShown))
            m_problems.Add("  " + Line(finding));
        if (figure.Findings.Count > FindingsShown)
            m_problems.Add($"  and others; RepoTools house --list {figure.Measure.Name} names them all");
    }

    private static string Line(Finding finding) => $"{finding.Path}: {finding.What}";

    private sealed record HouseFigure(HouseMeasure Measure, long Value, IReadOnlyList<Finding> Findings);
}
