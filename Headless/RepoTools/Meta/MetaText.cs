namespace FastPoints.RepoTools.Meta;

/// <summary>What matters of a .meta file's text: its guid, whose block follows, and whether Unity would read it.</summary>
public sealed class MetaText
{
    private readonly string m_text;

    private MetaText(string text, string? guid) => (m_text, Guid) = (text, guid);

    /// <summary>32 lower-case hex digits; null where the file has none that Unity would take.</summary>
    public string? Guid { get; }

    public static MetaText Parse(string text)
    {
        Match guid = Regex.Match(text, @"^guid: ([0-9a-f]{32})\r?$", RegexOptions.Multiline);
        return new MetaText(text, guid.Success ? guid.Groups[1].Value : null);
    }

    public static string Compose(string guid, Importer importer) =>
        "fileFormatVersion: 2\nguid: " + guid + "\n" + (importer.IsFolder ? "folderAsset: yes\n" : "") +
        importer.Name + ":\n  externalObjects: {}\n" + importer.Settings +
        "  userData:\n  assetBundleName:\n  assetBundleVariant:\n";

    public IReadOnlyList<string> Problems(Importer importer)
    {
        var problems = new List<string>();
        string[] lines = m_text.Split('\n');
        if (lines[0] != "fileFormatVersion: 2")
            problems.Add("does not start with 'fileFormatVersion: 2'");
        if (Guid == null)
            problems.Add("has no guid of 32 lower-case hex digits");
        if (m_text.Contains('\r'))
            problems.Add("has CR line ends");
        if (!m_text.EndsWith('\n'))
            problems.Add("does not end with a line end");
        if (lines.Contains("folderAsset: yes") != importer.IsFolder)
            problems.Add(importer.IsFolder ? "is a folder's and does not say 'folderAsset: yes'" : "is no folder's");
        string? block = lines.FirstOrDefault(l => Regex.IsMatch(l, @"^\w+Importer:$"));
        if (block != importer.Name + ":")
            problems.Add($"has {(block == null ? "no importer's block" : block.TrimEnd(':'))}, wanted {importer.Name}");
        return problems;
    }
}
