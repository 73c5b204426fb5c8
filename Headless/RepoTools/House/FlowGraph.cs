namespace FastPoints.RepoTools.House;

/// <summary>Which types of the product name which others, so which files one may have to read to follow a flow. A type is reached
/// with all its members, and with the types within it; a job with the code that schedules it. A base or an interface reaches
/// itself alone: what derives from it is reached where code of the flow names it. Constants are not in the IL, so what only they
/// join is not.</summary>
public sealed class FlowGraph
{
    private readonly Dictionary<string, HashSet<string>> m_namedBy = new Dictionary<string, HashSet<string>>();
    private readonly HashSet<string> m_functions = new HashSet<string>();
    private readonly ILookup<string, SourceFile> m_filesOf;

    public FlowGraph(IEnumerable<ModuleDefinition> modules, ILookup<string, SourceFile> filesOf)
    {
        m_filesOf = filesOf;
        foreach (ModuleDefinition module in modules)
        {
            m_functions.UnionWith(module.Types.SelectMany(t => t.Methods, (t, m) => $"{t.FullName}.{m.Name}"));
            foreach (IlUse use in IlUses.Of(module).Where(u => u.Within != null))
            {
                string from = OuterOf(use.Within!);
                if (filesOf.Contains(from))
                    NamedBy(from).UnionWith(RoomOrder.Types(use.Member).Select(OuterOf).Where(filesOf.Contains));
            }
        }
    }

    public IReadOnlyCollection<string> Reach(IEnumerable<string> functions)
    {
        var reached = new HashSet<string>();
        var open = new Stack<string>();
        foreach (string function in functions)
        {
            if (!m_functions.Contains(function))
                throw new ToolException($"house.tsv: no function {function}");
            open.Push(function[..function.LastIndexOf('.')]);
        }
        while (open.TryPop(out string? type))
        {
            if (reached.Add(type))
                NamedBy(type).ToList().ForEach(open.Push);
        }
        return reached;
    }

    public IReadOnlyList<SourceFile> FilesOf(IEnumerable<string> types) =>
        types.SelectMany(t => m_filesOf[t]).Distinct().OrderBy(f => f.Path, StringComparer.Ordinal).ToList();

    public IEnumerable<string> Circles(IReadOnlyCollection<string> types)
    {
        Dictionary<string, Dictionary<string, string>> edges = new();
        foreach (string from in types)
        {
            foreach (string to in NamedBy(from).Where(t => RoomOf(t) != RoomOf(from)))
            {
                edges.TryAdd(RoomOf(from), new Dictionary<string, string>());
                edges[RoomOf(from)].TryAdd(RoomOf(to), $"{from} names {to}");
            }
        }
        return edges.SelectMany(from => from.Value
            .Where(to => FileCycles.Reach(to.Key, edges).Contains(from.Key))
            .Select(to => $"{from.Key} -> {to.Key}: {to.Value}"));
    }

    private string RoomOf(string type) => m_filesOf[type].First().Room;

    private HashSet<string> NamedBy(string type) =>
        m_namedBy.TryGetValue(type, out HashSet<string>? named) ? named : m_namedBy[type] = new HashSet<string>();

    private static string OuterOf(TypeReference type)
    {
        TypeReference outer = type.GetElementType();
        while (outer.DeclaringType != null)
            outer = outer.DeclaringType;
        return outer.FullName;
    }
}
