namespace FastPoints.RepoTools.House;

public sealed class FlowReport
{
    private readonly FlowGraph m_graph;
    private readonly HouseTable m_table;
    private readonly Dictionary<string, long> m_figures = new Dictionary<string, long>();
    private readonly List<string> m_problems = new List<string>();
    private readonly StringBuilder m_text = new StringBuilder(
        $"{"",-22}{"files",6}{"limit",6}{"goal",6}{"rooms",7}{"limit",6}{"goal",6}{"folders",9}{"lines",8}\n");

    public FlowReport(HouseTable table, FlowGraph graph)
    {
        m_table = table;
        m_graph = graph;
        foreach (HouseRow flow in table.Flows)
            Add(flow, table.Of(HouseTable.FlowRooms, flow.Where));
    }

    public IReadOnlyDictionary<string, long> Figures => m_figures;
    public IReadOnlyList<string> Problems => m_problems;
    public string Text => m_text.ToString();

    public IEnumerable<string> List(string flow) => m_graph
        .FilesOf(m_graph.Reach(Functions(m_table.Of(HouseTable.FlowFiles, flow)))).GroupBy(f => f.Room)
        .SelectMany(r => r.Select(f => "  " + f.Path)
            .Prepend($"{r.Key}: {r.Count()} files, {r.Sum(f => f.LineCount)} lines"));

    private void Add(HouseRow ofFiles, HouseRow ofRooms)
    {
        IReadOnlyCollection<string> types = m_graph.Reach(Functions(ofFiles));
        IReadOnlyList<SourceFile> files = m_graph.FilesOf(types);
        int rooms = files.Select(f => f.Room).Distinct().Count();
        int folders = files.Select(f => f.Folder).Distinct().Count();
        m_text.Append(CultureInfo.InvariantCulture,
            $"{ofFiles.Where,-22}{files.Count,6}{ofFiles.Limit,6}{ofFiles.Goal,6}{rooms,7}{ofRooms.Limit,6}{ofRooms.Goal,6}" +
            $"{folders,9}{files.Sum(f => f.LineCount),8:N0}\n");
        foreach (string edge in m_graph.Circles(types))
            m_text.Append(CultureInfo.InvariantCulture, $"  in a circle of rooms: {edge}\n");
        Hold(ofFiles, files.Count);
        Hold(ofRooms, rooms);
    }

    private void Hold(HouseRow row, int figure)
    {
        m_figures[row.Key] = figure;
        if (figure > row.Limit)
            m_problems.Add($"{row.Key}: {figure}, the limit is {row.Limit}");
    }

    private static string[] Functions(HouseRow flow) => flow.Reason.Split(", ");
}
