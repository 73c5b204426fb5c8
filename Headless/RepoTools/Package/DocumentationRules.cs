namespace FastPoints.RepoTools.Package;

/// <summary>What a user may put on a GameObject or find on an entity is on some page of the manual, and links of pages lead
/// somewhere.</summary>
public static class DocumentationRules
{
    private const string Folder = "Documentation~/";

    private static readonly Regex s_component = new Regex(
        @"public (?:sealed |abstract )?(?:partial )?(?:class|struct) (\w+) : "
        + @"[^{\n]*\b(?:MonoBehaviour|ScriptableObject|I(?:Cleanup)?ComponentData)\b");
    private static readonly Regex s_link = new Regex(@"\]\((?!\w+:|#)([^)#\s]+)(?:#[^)]*)?\)");

    public static IEnumerable<string> Check(PackageFiles files)
    {
        List<string> pages = files.With(".md").Where(f => f.StartsWith(Folder, StringComparison.Ordinal)).ToList();
        string manual = string.Join("\n", pages.Select(files.Read));
        foreach (string file in files.With(".cs").Where(f => f.StartsWith("Runtime/", StringComparison.Ordinal)))
            foreach (Match component in s_component.Matches(files.Read(file)))
                if (!Regex.IsMatch(manual, $@"\b{component.Groups[1].Value}\b"))
                    yield return $"{component.Groups[1].Value} ({file}) is on no page of {Folder}";
        foreach (string page in pages.Concat(files.All.Where(f => f is "README.md" or "CHANGELOG.md")))
        {
            string folder = page[..(page.LastIndexOf('/') + 1)];
            foreach (Match link in s_link.Matches(files.Read(page)))
                if (!System.IO.Path.Exists(files.PathOf(folder + link.Groups[1].Value)))
                    yield return $"{page}: the link to {link.Groups[1].Value} leads nowhere";
        }
    }
}
