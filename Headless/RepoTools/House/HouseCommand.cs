namespace FastPoints.RepoTools.House;

/// <summary>Prints how large and how plain the house is, and refuses what is beyond the limits of
/// Headless/Api/house.tsv.</summary>
public static class HouseCommand
{
    /// <param name="check">Writes nothing; else limits come down to what has been reached.</param>
    /// <param name="list">A measure all of whose findings are printed in place of the table; null for none.</param>
    public static ToolResult Run(Repository repository, bool check, string? list)
    {
        string file = repository.House;
        HouseTable table = HouseTable.Parse(File.ReadAllText(file));
        List<SourceFile> files = repository.Files().Where(SourceFile.IsWanted).AsParallel()
            .Select(f => new SourceFile(f, File.ReadAllText(Path.Combine(repository.Root, f)))).ToList();
        var report = new HouseReport(new HouseSources(files), table);
        if (list != null)
        {
            List<string> lines = report.List(list).ToList();
            lines.ForEach(Console.WriteLine);
            return new ToolResult($"{lines.Count} of {list}", Array.Empty<string>());
        }
        Console.Write(report.Text());
        if (!check)
            File.WriteAllText(file, table.Lowered(report.Figures));
        return new ToolResult($"{report.GoalsMet} of {report.Figures.Count} figures at their goals", report.Problems);
    }
}
