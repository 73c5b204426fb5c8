namespace FastPoints.RepoTools.Behaviour;

public static class BehaviourCommand
{
    private const string Heading = "\n## What could not be verified without an editor\n";

    private static readonly Regex s_step = new Regex(@"^\| (\d+) \|", RegexOptions.Multiline);
    private static readonly Regex s_table = new Regex(@"\| what \| step that shows it \|\n(?:\|.*\n)*");

    public static ToolResult Run(Repository repository, bool check)
    {
        string file = repository.Behaviour;
        string page = Path.Combine(repository.PackageRoot, "Documentation~", "try-in-unity.md");
        string text = File.ReadAllText(file);
        string manual = File.ReadAllText(page);
        int heading = manual.IndexOf(Heading, System.StringComparison.Ordinal);
        if (heading < 0 || !s_table.IsMatch(manual, heading))
            throw new ToolException("try-in-unity.md has no table of what could not be verified");

        BehaviourLedger ledger = BehaviourLedger.Parse(text);
        HashSet<string> steps = s_step.Matches(manual[..heading]).Select(m => m.Groups[1].Value).ToHashSet();
        string[] folders = { repository.StandIns, Path.Combine(repository.Root, "UnityOutside"), repository.Headless };
        List<string> problems = ledger.Problems(folders, Tests(repository), steps).ToList();
        string made = s_table.Replace(manual, ledger.UnverifiedTable().Replace("$", "$$"), 1, heading);
        if (check && (made != manual || ledger.Text() != text))
            problems.Add("behaviour.tsv is not in order, or try-in-unity.md is not made from it (RepoTools "
                + "behaviour writes both)");
        if (!check)
        {
            File.WriteAllText(file, ledger.Text());
            File.WriteAllText(page, made);
        }
        return new ToolResult($"{ledger.Count} behaviours, {ledger.UnverifiedCount} of them unverified", problems);
    }

    private static ILookup<string, string> Tests(Repository repository) =>
        new[] { "Headless/HostTests", "UnityOutside/Tests", "Packages/com.fastpoints.dots/Tests" }
            .Select(folder => Path.Combine(repository.Root, folder))
            .SelectMany(folder => Directory.EnumerateFiles(folder, "*.cs", SearchOption.AllDirectories))
            .ToLookup(f => Path.GetFileNameWithoutExtension(f), File.ReadAllText);
}
