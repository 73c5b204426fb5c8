namespace FastPoints.HostTests.Manual;

sealed class ManualPage
{
    public ManualPage(string path, string text) => (Path, Text) = (path, text);

    public string Path { get; }
    public string Text { get; }
    public string Name => System.IO.Path.GetFileName(Path);

    public static IReadOnlyList<ManualPage> All() => Checkout.Files().Where(f => f.EndsWith(".md", StringComparison.Ordinal))
        .Select(f => new ManualPage(f, File.ReadAllText(System.IO.Path.Combine(Checkout.Repository.Root, f)))).ToList();

    public static ManualPage Of(string name) =>
        All().Single(p => p.Path.EndsWith("/Documentation~/" + name, StringComparison.Ordinal));

    public IEnumerable<string> Anchors() => Regex.Matches(Text, @"^#+ +(.+?)\s*$", RegexOptions.Multiline)
        .Select(m => Regex.Replace(m.Groups[1].Value.ToLowerInvariant(), @"[^\w\- ]", "").Replace(' ', '-'));

    public IEnumerable<string> Links() => Regex.Matches(WithoutCode(), @"\]\(([^()\s]+)\)").Select(m => m.Groups[1].Value);

    public IReadOnlyList<string[]> TableUnder(string heading)
    {
        int start = Text.IndexOf("\n" + heading + "\n", StringComparison.Ordinal);
        if (start < 0)
            throw new ArgumentException(Path + " has no heading " + heading);
        return Text[(start + 1)..].Split('\n').SkipWhile(l => !l.StartsWith('|')).TakeWhile(l => l.StartsWith('|')).Skip(2)
            .Select(l => l.Trim().Trim('|').Split('|').Select(c => c.Trim()).ToArray()).ToList();
    }

    public static IEnumerable<string> Code(string text) => Regex.Matches(text, "`([^`\n]+)`").Select(m => m.Groups[1].Value);

    string WithoutCode() => Regex.Replace(Text, @"```[\s\S]*?```|`[^`\n]*`|^    [^\n]*$", "", RegexOptions.Multiline);
}
