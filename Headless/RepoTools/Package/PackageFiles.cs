namespace FastPoints.RepoTools.Package;

public sealed class PackageFiles
{
    private readonly string m_root;

    public PackageFiles(string root)
    {
        m_root = root;
        All = Directory.EnumerateFiles(root, "*", SearchOption.AllDirectories)
            .Select(f => Path.GetRelativePath(root, f).Replace('\\', '/')).OrderBy(f => f, StringComparer.Ordinal).ToList();
    }

    public IReadOnlyList<string> All { get; }
    public IEnumerable<string> Top => All.Select(f => f.Split('/')[0]).Distinct();

    public bool Has(string file) => All.Contains(file);
    public string Read(string file) => File.ReadAllText(Path.Combine(m_root, file));
    public string PathOf(string file) => Path.Combine(m_root, file);

    public IEnumerable<string> With(string extension) =>
        All.Where(f => f.EndsWith(extension, StringComparison.OrdinalIgnoreCase));

    public IEnumerable<string> FoldersIn(string folder) =>
        All.Where(f => f.StartsWith(folder + "/", StringComparison.Ordinal))
        .Select(f => f[(folder.Length + 1)..].Split('/')).Where(parts => parts.Length > 1)
        .Select(parts => parts[0]).Distinct();
}
