using System.IO.Compression;
using UnityOutside.Threads;

namespace UnityOutside.Api;

/// <summary>A list of Unity's signatures, the full one or the committed one. It remembers which lines were asked for, and in
/// which generations: the committed list is what a conformance check of the package touched.</summary>
public sealed class UnityApi
{
    /// <summary>Unity's generations that the lists tell apart, oldest first.</summary>
    public static readonly string[] Generations = { "6000.0", "6000.3", "6000.5" };

    private readonly Dictionary<string, ApiRow> m_rows = new Dictionary<string, ApiRow>(StringComparer.Ordinal);
    private readonly Dictionary<string, List<ApiRow>> m_membersOfType =
        new Dictionary<string, List<ApiRow>>(StringComparer.Ordinal);
    private readonly SortedDictionary<string, ApiRow> m_touched = new SortedDictionary<string, ApiRow>(StringComparer.Ordinal);

    private UnityApi(string name) => Name = name;

    /// <summary>For messages: where a signature that is missing was looked for.</summary>
    public string Name { get; }

    public IEnumerable<ApiRow> Rows => m_rows.Values;

    /// <summary>The lines that were asked for since this list was loaded, in order of their ids.</summary>
    public IEnumerable<ApiRow> Touched => m_touched.Values;

    /// <summary>Every *.tsv.gz of a folder, but for the table of threads, which has columns of its own.</summary>
    public static UnityApi LoadFull(string folder, params string[] more)
    {
        var api = new UnityApi("Unity's published signatures");
        foreach (string file in Directory.GetFiles(folder, "*.tsv.gz").OrderBy(f => f, StringComparer.Ordinal)
            .Where(f => Path.GetFileName(f) != ThreadTable.FullName))
        {
            using var lines = new StreamReader(new GZipStream(File.OpenRead(file), CompressionMode.Decompress));
            api.Add(lines);
        }
        foreach (string file in more)
            api.Add(new StringReader(File.ReadAllText(file)));
        if (api.m_rows.Count == 0)
            throw new FileNotFoundException($"no *.tsv.gz in {folder}");
        return api;
    }

    public static UnityApi LoadUsed(string file) => Read(Path.GetFileName(file), new StringReader(File.ReadAllText(file)));

    public static UnityApi Read(string name, TextReader lines)
    {
        var api = new UnityApi(name);
        api.Add(lines);
        return api;
    }

    public ApiRow? Find(string id, string generation)
    {
        if (!m_rows.TryGetValue(id, out ApiRow? row) || !row.IsIn(generation))
            return null;
        m_touched[id] = row;
        return row.As(generation);
    }

    public ApiRow? FindAny(string id) => m_rows.GetValueOrDefault(id);

    public IEnumerable<ApiRow> Members(string typeId, string generation)
    {
        if (!m_membersOfType.TryGetValue(typeId, out List<ApiRow>? members))
            yield break;
        foreach (ApiRow member in members.Where(m => m.IsIn(generation)))
            yield return Find(member.Id, generation)!;
    }

    private void Add(TextReader lines)
    {
        for (string? line = lines.ReadLine(); line != null; line = lines.ReadLine())
        {
            if (line.Length == 0 || line[0] == '#')
                continue;
            ApiRow row = ApiRow.Parse(line);
            m_rows[row.Id] = row;
            if (row.IsType)
                continue;
            string type = "T:" + DocId.DeclaringTypeOf(row.Id);
            if (!m_membersOfType.TryGetValue(type, out List<ApiRow>? members))
                m_membersOfType.Add(type, members = new List<ApiRow>());
            members.Add(row);
        }
    }
}
