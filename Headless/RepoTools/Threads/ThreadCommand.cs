namespace FastPoints.RepoTools.Threads;

/// <summary>Writes Headless/Api/threads.tsv: the lines of the full table for what the package's IL names and for what the
/// stand-ins show. A line whose reason was written by hand stays as it is, also where the table has another.</summary>
public static class ThreadCommand
{
    public static readonly NestedWork NestedWork =
        new NestedWork("FastPoints.Work", "FastPoints.CoroutineStack", "FastPoints.JobCoroutine");

    public static ToolResult Run(Repository repository, bool check)
    {
        string full = Path.Combine(repository.FullApi, ThreadTable.FullName);
        string file = repository.UsedThreads;
        bool hasFull = File.Exists(full);
        if (!hasFull && !check)
            throw new ToolException($"no {full}: set FASTPOINTS_DATA to the folder that has unity-api");
        if (!File.Exists(file) && check)
            return new ToolResult("nothing committed",
                new[] { "Headless/Api/threads.tsv is not there (RepoTools threads writes it)" });

        string committed = File.Exists(file) ? File.ReadAllText(file) : "";
        ThreadTable own = ThreadTable.Read(new StringReader(committed));
        ThreadTable table = hasFull ? ThreadTable.Load(full) : own;
        if (hasFull)
        {
            foreach (ThreadRow row in own.Rows.Where(r => r.IsByHand))
                table.Set(row);
        }
        foreach (string generation in Repository.Generations)
        {
            using var builds = new GenerationBuilds(repository, generation);
            Touch(builds, table);
        }

        string text = Compose(table.Touched);
        var problems = new List<string>();
        if (!check)
            File.WriteAllText(file, text);
        else if (text != committed)
            problems.AddRange(Differences(table, own));
        return new ToolResult($"{table.Touched.Count()} members of Unity, " +
            $"{table.Touched.Count(r => r.Threads != "any")} of them not for any thread", problems);
    }

    private static void Touch(GenerationBuilds builds, ThreadTable table)
    {
        foreach (MemberReference member in builds.Package.SelectMany(IlUses.Of).Select(u => u.Member)
            .Where(m => m.DeclaringType != null && Origins.IsUnity(Origins.AssemblyOf(m.DeclaringType))))
            Touch(member, table);
        foreach (TypeDefinition type in builds.StandIns.SelectMany(m => m.GetTypes()).Where(StandInAudit.IsVisible))
        {
            foreach (MethodDefinition method in type.Methods.Where(m => m.IsPublic || m.IsFamily || m.IsFamilyOrAssembly))
                Touch(method, table);
            foreach (FieldDefinition field in type.Fields.Where(f => StandInAudit.IsVisible(f.Attributes) && !f.HasConstant))
                Touch(field, table);
        }
    }

    private static void Touch(MemberReference member, ThreadTable table)
    {
        if (member is MethodReference method)
            table.Find(method);
        else if (member is FieldReference field)
            table.Find(field);
    }

    private static IEnumerable<string> Differences(ThreadTable table, ThreadTable own)
    {
        Dictionary<string, ThreadRow> wanted = table.Touched.ToDictionary(r => r.Id);
        Dictionary<string, ThreadRow> have = own.Rows.ToDictionary(r => r.Id);
        const string Remedy = "(RepoTools threads writes it)";
        foreach (string id in wanted.Keys.Except(have.Keys))
            yield return $"{id} is used and not in Headless/Api/threads.tsv {Remedy}";
        foreach (string id in have.Keys.Except(wanted.Keys))
            yield return $"{id} is in Headless/Api/threads.tsv and not used {Remedy}";
        foreach (string id in wanted.Keys.Intersect(have.Keys).Where(id => wanted[id] != have[id]))
            yield return $"{id} differs in Headless/Api/threads.tsv {Remedy}";
        if (wanted.Count == have.Count && wanted.All(w => have.TryGetValue(w.Key, out ThreadRow? row) && row == w.Value))
            yield return $"Headless/Api/threads.tsv is not in order, or has a line twice {Remedy}";
    }

    private static string Compose(IEnumerable<ThreadRow> rows) =>
        string.Concat(rows.Select(r => r.Compose()).Prepend(ThreadRow.Header).Select(line => line + "\n"));
}
