namespace FastPoints.RepoTools.Hlsl;

public static class HlslCommand
{
    public static ToolResult Run(Repository repository, bool check)
    {
        using var builds = new GenerationBuilds(repository, Repository.Generations[0]);
        return Run(builds.Package, Path.Combine(repository.PackageRoot, "Shaders", "Generated"), check);
    }

    public static ToolResult Run(IEnumerable<ModuleDefinition> modules, string folder, bool check)
    {
        var wanted = new SortedDictionary<string, string>();
        foreach (TypeDefinition type in FieldLayout.Marked(modules, HlslStructs.Attribute))
        {
            if (!wanted.TryAdd(type.Name + ".hlsl", HlslStructs.Compose(type)))
                throw new ToolException($"two structs are called {type.Name}");
        }
        var problems = new List<string>();
        foreach ((string name, string text) in wanted)
        {
            string file = Path.Combine(folder, name);
            if (File.Exists(file) && File.ReadAllText(file) == text)
                continue;
            if (check)
            {
                problems.Add($"Shaders/Generated/{name} is not what its struct says (RepoTools hlsl writes it)");
                continue;
            }
            Directory.CreateDirectory(folder);
            File.WriteAllText(file, text);
        }
        IEnumerable<string> there = Directory.Exists(folder) ? Directory.GetFiles(folder, "*.hlsl") : Enumerable.Empty<string>();
        foreach (string file in there.Where(f => !wanted.ContainsKey(Path.GetFileName(f))))
        {
            if (check)
                problems.Add($"Shaders/Generated/{Path.GetFileName(file)} has no struct (RepoTools hlsl removes it)");
            else
                File.Delete(file);
        }
        return new ToolResult($"{wanted.Count} structs", problems);
    }
}
