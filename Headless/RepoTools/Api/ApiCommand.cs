namespace FastPoints.RepoTools.Api;

public static class ApiCommand
{
    public static ToolResult Run(Repository repository, bool check)
    {
        bool hasFull = Directory.Exists(repository.FullApi);
        if (!hasFull && !check)
            throw new ToolException($"no full list in {repository.FullApi}: set FASTPOINTS_DATA to the "
                + "folder that has unity-api");
        if (!File.Exists(repository.UsedApi) && check)
            return new ToolResult("nothing committed", new[] { "Headless/Api/used.tsv is not there (RepoTools api writes it)" });

        UnityApi api = hasFull ? UnityApi.LoadFull(repository.FullApi, repository.PhysicsApi)
            : UnityApi.LoadUsed(repository.UsedApi);
        List<string> problems = Check(repository, api);
        if (check)
            problems.AddRange(UnusedStandIns.Check(repository));
        if (!check)
        {
            string text = Compose(api.Touched);
            Directory.CreateDirectory(Path.GetDirectoryName(repository.UsedApi)!);
            File.WriteAllText(repository.UsedApi, text);
        }
        else if (hasFull)
        {
            UnityApi used = UnityApi.LoadUsed(repository.UsedApi);
            foreach (ApiRow row in api.Touched)
            {
                ApiRow? committed = used.FindAny(row.Id);
                if (committed == null)
                    problems.Add($"{row.Id} is used and not in Headless/Api/used.tsv (RepoTools api writes it)");
                else if (committed != row)
                    problems.Add($"{row.Id} differs in Headless/Api/used.tsv (RepoTools api writes it)");
            }
        }
        return new ToolResult($"{api.Touched.Count()} signatures of Unity used", problems);
    }

    public static List<string> Check(Repository repository, UnityApi api)
    {
        AssemblyTable assemblies = SampleAssemblies.LoadAll(repository.PackageRoot);
        var problems = new List<string>();
        foreach (string generation in Repository.Generations)
        {
            using var builds = new GenerationBuilds(repository, generation);
            var conformance = new Conformance(api, generation, assemblies);
            problems.AddRange(builds.Package.SelectMany(conformance.Check));
        }
        return problems;
    }

    private static string Compose(IEnumerable<ApiRow> rows) =>
        string.Concat(rows.Select(r => r.Compose()).Prepend(ApiRow.Header).Select(line => line + "\n"));
}
