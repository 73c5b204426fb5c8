namespace FastPoints.RepoTools.Behaviour;

public static class BehaviourCommand
{
    private static readonly Regex s_step = new Regex(@"^\| (\d+) \|", RegexOptions.Multiline);
    private static readonly Regex s_table = new Regex(@"\| what \| step that shows it \|\n(?:\|.*\n)*");

    public static ToolResult Run(Repository repository, bool check)
    {
        string file = repository.Behaviour;
        string folder = Path.Combine(repository.PackageRoot, "Documentation~", "internals");
        string page = Path.Combine(folder, "unverified.md");
        string text = File.ReadAllText(file);
        string manual = File.ReadAllText(page);
        if (!s_table.IsMatch(manual))
            throw new ToolException("unverified.md has no table of what could not be verified");

        BehaviourLedger ledger = BehaviourLedger.Parse(text);
        HashSet<string> steps = s_step.Matches(File.ReadAllText(Path.Combine(folder, "try-in-unity.md")))
            .Select(m => m.Groups[1].Value).ToHashSet();
        string[] folders = { repository.StandIns, Path.Combine(repository.Root, "UnityOutside"), repository.Headless };
        List<string> problems = ledger.Problems(folders, Tests(repository), steps).ToList();
        string made = s_table.Replace(manual, ledger.UnverifiedTable().Replace("$", "$$"), 1);
        if (check && (made != manual || ledger.Text() != text))
            problems.Add("behaviour.tsv is not in order, or unverified.md is not made from it (RepoTools "
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
