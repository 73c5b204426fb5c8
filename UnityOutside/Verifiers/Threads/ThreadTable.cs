using System.IO.Compression;

namespace UnityOutside.Threads;

/// <summary>On which threads Unity's members may be called: the full table or the committed one. It remembers which lines
/// were asked for.</summary>
public sealed class ThreadTable
{
    public const string FullName = "threads.tsv.gz";

    private readonly Dictionary<string, ThreadRow> m_rows = new Dictionary<string, ThreadRow>(StringComparer.Ordinal);
    private readonly SortedDictionary<string, ThreadRow> m_touched =
        new SortedDictionary<string, ThreadRow>(StringComparer.Ordinal);

    private ThreadTable() { }

    public IEnumerable<ThreadRow> Rows => m_rows.Values;

    /// <summary>The lines that were asked for since this table was loaded, in order of their ids.</summary>
    public IEnumerable<ThreadRow> Touched => m_touched.Values;

    public static ThreadTable Load(string file)
    {
        using Stream bytes = File.OpenRead(file);
        using var lines = new StreamReader(file.EndsWith(".gz", StringComparison.Ordinal)
            ? new GZipStream(bytes, CompressionMode.Decompress) : bytes);
        return Read(lines);
    }

    public static ThreadTable Read(TextReader lines)
    {
        var table = new ThreadTable();
        for (string? line = lines.ReadLine(); line != null; line = lines.ReadLine())
        {
            if (line.Length > 0 && line[0] != '#')
                table.Set(ThreadRow.Parse(line));
        }
        return table;
    }

    public void Set(ThreadRow row) => m_rows[row.Id] = row;

    public ThreadRow? Find(string id)
    {
        if (!m_rows.TryGetValue(id, out ThreadRow? row))
            return null;
        m_touched[id] = row;
        return row;
    }

    public ThreadRow? Find(FieldReference field) => Find(DocId.OfField(field));
    public ThreadRow? Find(MethodReference method) => Find(method.DeclaringType, method);

    public ThreadRow? Find(TypeReference type, MethodReference method)
    {
        for (TypeReference? at = type; at != null; at = Resolution.Of(at)?.BaseType)
        {
            string name = DocId.DefinitionName(at);
            ThreadRow? row = Find(DocId.OfMethod(name, method));
            if (row == null && DocId.OfAccessor(name, method) is { } accessor)
                row = Find(accessor);
            if (row != null || method.Name == ".ctor")
                return row;
        }
        return null;
    }
}
