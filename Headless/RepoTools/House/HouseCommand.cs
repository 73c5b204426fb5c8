namespace FastPoints.RepoTools.House;

/// <summary>Prints how large and how plain the house is, or how far its flows reach, and refuses what is beyond the limits of
/// Headless/Api/house.tsv.</summary>
public static class HouseCommand
{
    public static ToolResult Run(Repository repository, bool check, string? list)
    {
        HouseTable table = TableOf(repository);
        var report = new HouseReport(HouseSources.Of(repository), table,
            Ceilings.Load(repository.GivenCeilings, repository.Ceilings));
        if (list != null)
            return Print(report.List(list), list);
        Console.Write(report.Text());
        if (!check)
            File.WriteAllText(repository.House, table.Lowered(report.Figures));
        return new ToolResult($"{report.GoalsMet} of {report.Figures.Count} figures at their goals", report.Problems);
    }

    public static ToolResult RunFlows(Repository repository, bool check, string? list)
    {
        HouseTable table = TableOf(repository);
        using var builds = new GenerationBuilds(repository, Repository.Generations[^1]);
        var report = new FlowReport(table, new FlowGraph(builds.Package, HouseSources.Of(repository).FilesOfTypes()));
        if (list != null)
            return Print(report.List(list), list);
        Console.Write(report.Text);
        if (!check)
            File.WriteAllText(repository.House, table.Lowered(report.Figures));
        return new ToolResult($"{table.Flows.Count()} flows", report.Problems);
    }

    private static HouseTable TableOf(Repository repository) => HouseTable.Parse(File.ReadAllText(repository.House));

    private static ToolResult Print(IEnumerable<string> found, string name)
    {
        List<string> lines = found.ToList();
        lines.ForEach(Console.WriteLine);
        return new ToolResult($"{lines.Count} of {name}", Array.Empty<string>());
    }
}
