namespace FastPoints.RepoTools.House;

/// <summary>Headless/Api/house.tsv. A measure's row (its place is '*') has what one thing may have, how many may have more (or,
/// without the first, the whole figure), and the goal of that. The row 'part' has the part of the work whose ceilings hold. A row
/// 'flow-files' or 'flow-rooms' has a flow's name, a limit and a goal, and the former the functions that begin it. Every other
/// row is an exception: a file or a folder, what one thing may have there, and why.</summary>
public sealed class HouseTable
{
    private const string Header = "measure\twhere\teach\tlimit\tgoal\twhy";
    private const string PartName = "part";

    public const string FlowFiles = "flow-files";
    public const string FlowRooms = "flow-rooms";

    private readonly List<HouseRow> m_rows;

    private HouseTable(List<HouseRow> rows) => m_rows = rows;

    public int Part => (int)(Of(PartName).Each ?? throw new ToolException($"house.tsv: {PartName} has no number"));
    public IEnumerable<HouseRow> Flows => m_rows.Where(r => r.Measure == FlowFiles);
    public IEnumerable<HouseRow> Exceptions => m_rows.Where(r => r.Where != HouseRow.Anywhere && !r.IsOfFlow);
    private IEnumerable<HouseRow> Limits => m_rows.Except(Exceptions).Where(r => r.Measure != PartName);

    public static HouseTable Parse(string text)
    {
        string[] lines = text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        if (lines.Length == 0 || lines[0] != Header)
            throw new ToolException("house.tsv: the first line is not its header");
        return new HouseTable(lines.Skip(1).Select(ParseRow).ToList());
    }

    public HouseRow Of(string measure, string where = HouseRow.Anywhere)
    {
        List<HouseRow> found = m_rows.Where(r => r.Measure == measure && r.Where == where).ToList();
        return found.Count == 1
            ? found[0]
            : throw new ToolException($"house.tsv: {found.Count} rows with the limit of {measure}, {where}");
    }

    public IEnumerable<string> Problems(IReadOnlyCollection<string> measures)
    {
        foreach (HouseRow row in m_rows.Where(r => !measures.Contains(r.Measure) && !r.IsOfFlow && r.Measure != PartName))
            yield return $"house.tsv: there is no measure {row.Measure}";
        foreach (HouseRow row in Exceptions.Where(r => r.Each == null || r.Reason.Length == 0))
            yield return $"house.tsv: {row.Measure} of {row.Where} has no number of its own, or no reason";
        foreach (HouseRow row in Limits.Where(r => r.Limit == null || r.Goal == null || r.Limit < r.Goal))
            yield return $"house.tsv: {row.Measure} has no limit, no goal, or a limit below its goal";
    }

    /// <summary>The file with each limit that is above both its goal and its figure brought down to the higher of the
    /// two.</summary>
    public string Lowered(IReadOnlyDictionary<string, long> figures) => string.Join("\n", m_rows
        .Select(r => figures.TryGetValue(r.Key, out long figure) && r.Limit > figure
            ? r with { Limit = Math.Max(figure, r.Goal ?? figure) }
            : r)
        .Select(r => r.Text()).Prepend(Header)) + "\n";

    private static HouseRow ParseRow(string line)
    {
        string[] cells = line.Split('\t').Select(c => c.Trim()).ToArray();
        if (cells.Length != 6)
            throw new ToolException($"house.tsv: {cells.Length} columns in '{line}'");
        return new HouseRow(cells[0], cells[1], Number(cells[2], line), Number(cells[3], line), Number(cells[4], line), cells[5]);
    }

    private static long? Number(string cell, string line)
    {
        if (cell.Length == 0)
            return null;
        return long.TryParse(cell, NumberStyles.None, CultureInfo.InvariantCulture, out long number)
            ? number
            : throw new ToolException($"house.tsv: '{cell}' is no number in '{line}'");
    }
}

public sealed record HouseRow(string Measure, string Where, long? Each, long? Limit, long? Goal, string Reason)
{
    public const string Anywhere = "*";

    public bool IsOfFlow => Measure is HouseTable.FlowFiles or HouseTable.FlowRooms;
    public string Key => Where == Anywhere ? Measure : $"{Measure} {Where}";

    /// <summary>Whether a place is this row's: a folder ends with '/', a file may be named by the end of its path.</summary>
    public bool IsOf(string path) => Where.EndsWith('/')
        ? path.StartsWith(Where, StringComparison.Ordinal) || path + "/" == Where
        : path == Where || path.EndsWith("/" + Where, StringComparison.Ordinal);

    public string Text() => string.Create(CultureInfo.InvariantCulture, $"{Measure}\t{Where}\t{Each}\t{Limit}\t{Goal}\t{Reason}");
}
