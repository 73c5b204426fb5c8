namespace FastPoints.RepoTools.Layers;

/// <summary>The assemblies of <c>Samples~</c>. In Unity each sample has its own, since it is imported by itself; here one project
/// has the scripts of all, and another their menu commands. That proves the same where all samples refer to the same assemblies,
/// and none uses another: which <see cref="Check"/> holds.</summary>
public static class SampleAssemblies
{
    public const string Folder = "Samples~";
    private const string Joined = "FastPoints.Samples";
    private const string EditorSuffix = ".Editor";

    public static List<Asmdef> Load(string packageRoot)
    {
        string folder = Path.Combine(packageRoot, Folder);
        return Directory.Exists(folder)
            ? Directory.EnumerateFiles(folder, "*.asmdef", SearchOption.AllDirectories).Order(StringComparer.Ordinal)
                .Select(Asmdef.Load).ToList()
            : new List<Asmdef>();
    }

    public static AssemblyTable LoadAll(string packageRoot)
    {
        string samples = Path.Combine(packageRoot, Folder) + Path.DirectorySeparatorChar;
        return new AssemblyTable(Directory.EnumerateFiles(packageRoot, "*.asmdef", SearchOption.AllDirectories)
            .Where(f => !f.StartsWith(samples, StringComparison.Ordinal)).Select(Asmdef.Load).Concat(Join(Load(packageRoot))));
    }

    public static IEnumerable<Asmdef> Join(IReadOnlyList<Asmdef> samples)
    {
        foreach (IGrouping<bool, Asmdef> group in samples.GroupBy(a => a.IsEditor))
        {
            List<string> common = group.Select(Shared).Aggregate((a, b) => a.Intersect(b)).ToList();
            if (group.Key)
                common.Add(Joined);
            yield return new Asmdef(Joined + (group.Key ? EditorSuffix : ""), "", common, group.Key);
        }
    }

    public static IEnumerable<string> Check(IReadOnlyList<Asmdef> samples)
    {
        Dictionary<bool, IReadOnlyList<string>> wanted = Join(samples).ToDictionary(a => a.IsEditor, a => a.References);
        foreach (Asmdef asmdef in samples)
        {
            string sample = SampleOf(asmdef);
            string name = Joined + "." + sample + (asmdef.IsEditor ? EditorSuffix : "");
            if (asmdef.Name != name || Path.GetFileNameWithoutExtension(asmdef.File) != name)
                yield return $"{asmdef.File}: wanted {name}";
            foreach (string extra in Shared(asmdef).Except(wanted[asmdef.IsEditor]))
                yield return $"{asmdef.Name} references {extra}, other samples do not";
            foreach (string source in Directory.EnumerateFiles(Path.GetDirectoryName(asmdef.File)!, "*.cs"))
                foreach (string problem in CheckSource(source, File.ReadAllText(source), sample))
                    yield return problem;
        }
    }

    public static IEnumerable<string> CheckSource(string path, string text, string sample)
    {
        if (!Regex.IsMatch(text, @"^namespace " + Regex.Escape(Joined + "." + sample) + @"\s*$", RegexOptions.Multiline))
            yield return $"{path}: wanted namespace {Joined}.{sample}";
        foreach (Match used in Regex.Matches(text, Regex.Escape(Joined) + @"\.(\w+)").Where(m => m.Groups[1].Value != sample))
            yield return $"{path} uses {used.Value}, another sample";
    }

    private static IEnumerable<string> Shared(Asmdef asmdef) =>
        asmdef.References.Where(r => r != Joined + "." + SampleOf(asmdef));

    private static string SampleOf(Asmdef asmdef)
    {
        string folder = Path.GetDirectoryName(asmdef.File)!;
        return Path.GetFileName(asmdef.IsEditor ? Path.GetDirectoryName(folder)! : folder);
    }
}
