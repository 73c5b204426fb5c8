namespace UnityOutside.Api;

public sealed class AssemblyTable
{
    private readonly Dictionary<string, Asmdef> m_asmdefs;

    public AssemblyTable(IEnumerable<Asmdef> asmdefs) => m_asmdefs = asmdefs.ToDictionary(a => a.Name);

    public IEnumerable<Asmdef> All => m_asmdefs.Values.OrderBy(a => a.Name, StringComparer.Ordinal);

    public bool Has(string assembly) => m_asmdefs.ContainsKey(assembly);

    public IReadOnlyCollection<string> References(string assembly) =>
        m_asmdefs.TryGetValue(assembly, out Asmdef? asmdef) ? asmdef.References : Array.Empty<string>();

    public bool IsEditor(string assembly) => m_asmdefs.TryGetValue(assembly, out Asmdef? asmdef) && asmdef.IsEditor;
}

public sealed record Asmdef(string Name, string File, IReadOnlyList<string> References, bool IsEditor)
{
    public static Asmdef Load(string file)
    {
        using JsonDocument json = JsonDocument.Parse(System.IO.File.ReadAllText(file));
        JsonElement root = json.RootElement;
        return new Asmdef(root.GetProperty("name").GetString()!, file, Strings(root, "references"),
            Strings(root, "includePlatforms").SequenceEqual(new[] { "Editor" }));
    }

    private static List<string> Strings(JsonElement root, string name) => root.TryGetProperty(name, out JsonElement list)
        ? list.EnumerateArray().Select(e => e.GetString()!).ToList()
        : new List<string>();
}
