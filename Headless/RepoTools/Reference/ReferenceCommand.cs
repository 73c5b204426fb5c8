namespace FastPoints.RepoTools.Reference;

public static class ReferenceCommand
{
    private static readonly string[] s_assemblies =
    {
        "FastPoints", "FastPoints.Import", "FastPoints.Picture", "FastPoints.Rendering", "FastPoints.Rendering.BuiltIn",
        "FastPoints.Rendering.Urp", "FastPoints.Rendering.Hdrp", "FastPoints.Entities", "FastPoints.Surface", "FastPoints.Editor",
    };

    public static ToolResult Run(Repository repository, bool check)
    {
        string file = Path.Combine(repository.PackageRoot, "Documentation~", "api.md");
        string page = File.ReadAllText(file);
        using var builds = new GenerationBuilds(repository, Repository.Generations[0]);
        Summaries summaries = Summaries.Load(repository.PackageRoot);
        List<List<TypeDefinition>> assemblies = s_assemblies
            .Select(a => builds.Package.Single(m => m.Assembly.Name.Name == a)).Select(PublicTypes)
            .Where(t => t.Count > 0).ToList();

        List<string> problems = assemblies.SelectMany(t => t).Where(t => summaries.Of(t) == null)
            .Select(t => $"{t.FullName}: public, and its source has no summary").ToList();
        string made = ReferenceBlock.Replace(page, Compose(assemblies, summaries, ReferenceBlock.NamesInExamples(page)));
        if (!check)
            File.WriteAllText(file, made);
        else if (made != page)
            problems.Add("Documentation~/api.md: its reference is not of the compiled package "
                + "(RepoTools reference writes it)");
        return new ToolResult($"{assemblies.Sum(a => a.Count)} public types", problems);
    }

    public static List<TypeDefinition> PublicTypes(ModuleDefinition assembly) => assembly.Types.Where(t => t.IsPublic)
        .OrderBy(t => t.Namespace, StringComparer.Ordinal).ThenBy(t => t.Name, StringComparer.Ordinal).ToList();

    private static string Compose(IEnumerable<List<TypeDefinition>> assemblies, Summaries summaries, ISet<string> inExamples)
    {
        var text = new StringBuilder();
        foreach (List<TypeDefinition> types in assemblies)
        {
            text.Append($"\n### {types[0].Module.Assembly.Name.Name}\n\n");
            text.Append("| type | namespace | what | begin with |\n|---|---|---|---|\n");
            foreach (TypeDefinition type in types)
            {
                string members = string.Join(", ", Beginning.Of(type, inExamples).Select(m => $"`{m}`"));
                text.Append($"| `{Signature.Name(type)}` | `{type.Namespace}` | {summaries.Of(type)} | {members} |\n");
            }
        }
        return text.Append('\n').ToString();
    }
}
