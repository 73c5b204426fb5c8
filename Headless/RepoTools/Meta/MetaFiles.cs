using System.Security.Cryptography;

namespace FastPoints.RepoTools.Meta;

/// <summary>The .meta files of a package: one for every file and folder that Unity imports. A guid is born from the path and then
/// kept for good, since scenes and other projects refer to it: a .meta that moved with its file is left alone, and one that
/// stayed behind follows the file of the same name.</summary>
public sealed class MetaFiles(string packageRoot)
{
    private const string Extension = ".meta";
    private const string Samples = "Samples~";
    private readonly string m_root = packageRoot;

    public ToolResult Run(bool check)
    {
        SortedSet<string> assets = Assets();
        SortedSet<string> metas = Metas();
        var problems = new List<string>();
        var texts = new SortedDictionary<string, MetaText>(StringComparer.Ordinal);
        foreach (string asset in assets.Where(a => metas.Contains(a + Extension)))
            texts[asset] = MetaText.Parse(File.ReadAllText(PathOf(asset + Extension)));
        List<string> missing = assets.Where(a => !metas.Contains(a + Extension)).ToList();
        List<string> orphans = metas.Where(m => !assets.Contains(m[..^Extension.Length])).ToList();
        if (check)
        {
            problems.AddRange(missing.Select(a => $"{a}: no .meta (RepoTools meta writes it)"));
            problems.AddRange(orphans.Select(m => $"{m}: nothing beside it (RepoTools meta removes it)"));
            foreach (KeyValuePair<string, MetaText> pair in texts)
                problems.AddRange(pair.Value.Problems(ImporterOf(pair.Key)).Select(p => $"{pair.Key}.meta: {p}"));
            problems.AddRange(Doubled(texts));
            return new ToolResult($"{assets.Count} files and folders", problems);
        }

        int written = Adopt(missing, orphans, texts);
        foreach (string orphan in orphans)
            File.Delete(PathOf(orphan));
        var taken = new HashSet<string>(texts.Values.Select(t => t.Guid).OfType<string>());
        foreach (string asset in missing)
        {
            Write(asset, Birth(asset, taken));
            written++;
        }
        foreach (KeyValuePair<string, MetaText> pair in texts)
        {
            if (pair.Value.Problems(ImporterOf(pair.Key)).Count == 0)
                continue;
            Write(pair.Key, pair.Value.Guid ?? Birth(pair.Key, taken));
            written++;
        }
        problems.AddRange(Doubled(texts));
        return new ToolResult($"{assets.Count} files and folders, {written} written, {orphans.Count} removed", problems);
    }

    private int Adopt(List<string> missing, List<string> orphans, SortedDictionary<string, MetaText> texts)
    {
        int adopted = 0;
        foreach (string orphan in orphans.ToList())
        {
            string name = Path.GetFileName(orphan[..^Extension.Length]);
            List<string> takers = missing.Where(a => Path.GetFileName(a) == name).ToList();
            if (takers.Count != 1 || orphans.Count(o => Path.GetFileName(o) == name + Extension) != 1)
                continue;
            File.Move(PathOf(orphan), PathOf(takers[0] + Extension));
            texts[takers[0]] = MetaText.Parse(File.ReadAllText(PathOf(takers[0] + Extension)));
            missing.Remove(takers[0]);
            orphans.Remove(orphan);
            adopted++;
        }
        return adopted;
    }

    private static IEnumerable<string> Doubled(SortedDictionary<string, MetaText> texts) =>
        texts.Where(t => t.Value.Guid != null).GroupBy(t => t.Value.Guid).Where(g => g.Count() > 1)
            .Select(g => $"guid {g.Key} is given twice: {string.Join(", ", g.Select(t => t.Key + Extension))}");

    private void Write(string asset, string guid) =>
        File.WriteAllText(PathOf(asset + Extension), MetaText.Compose(guid, ImporterOf(asset)));

    private Importer ImporterOf(string asset) => Importer.Of(asset, Directory.Exists(PathOf(asset)));
    private string PathOf(string asset) => Path.Combine(m_root, asset);

    private static string Birth(string asset, HashSet<string> taken)
    {
        for (int i = 0; ; i++)
        {
            string seed = "com.fastpoints.dots/" + asset + (i == 0 ? "" : "#" + i);
            string guid = Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(seed)).AsSpan(0, 16)).ToLowerInvariant();
            if (taken.Add(guid))
                return guid;
        }
    }

    /// <summary>Paths below the root with '/', of files and of folders that hold a file. Unity skips hidden and ~ names; the
    /// package manager copies what is in <see cref="Samples"/> into a project, .meta files with it.</summary>
    private SortedSet<string> Assets()
    {
        var assets = new SortedSet<string>(StringComparer.Ordinal);
        foreach (string path in Visible(".").Where(p => !p.EndsWith(Extension, StringComparison.Ordinal)))
        {
            for (string? part = path; !string.IsNullOrEmpty(part) && part != Samples; part = ParentOf(part))
                assets.Add(part);
        }
        return assets;
    }

    private SortedSet<string> Metas() => new SortedSet<string>(
        Visible(".").Where(p => p.EndsWith(Extension, StringComparison.Ordinal)), StringComparer.Ordinal);

    private IEnumerable<string> Visible(string folder)
    {
        foreach (string entry in Directory.EnumerateFileSystemEntries(folder == "." ? m_root : PathOf(folder)))
        {
            string name = Path.GetFileName(entry);
            if (name.StartsWith('.') || (name.EndsWith('~') && entry != PathOf(Samples)) ||
                name.EndsWith(".tmp", StringComparison.OrdinalIgnoreCase))
                continue;
            string path = folder == "." ? name : folder + "/" + name;
            if (!Directory.Exists(entry))
                yield return path;
            else
                foreach (string below in Visible(path))
                    yield return below;
        }
    }

    private static string? ParentOf(string path) => path.Contains('/') ? path[..path.LastIndexOf('/')] : null;
}
