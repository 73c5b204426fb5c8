namespace FastPoints.RepoTools.Formats;

public static class FormatCommand
{
    public static ToolResult Run(Repository repository)
    {
        using var builds = new GenerationBuilds(repository, Repository.Generations[0]);
        List<TypeDefinition> structs = FieldLayout.Marked(builds.Package, FormatTables.Attribute).ToList();
        string file = Path.Combine(repository.PackageRoot, "Documentation~", "internals", "disk-format.md");
        if (structs.Count > 0 && !File.Exists(file))
            return new ToolResult($"{structs.Count} structs", new[] { "Documentation~/internals/disk-format.md is not there" });
        string text = structs.Count == 0 ? "" : File.ReadAllText(file);
        return new ToolResult($"{structs.Count} structs", FormatTables.Compare(text, structs));
    }
}
