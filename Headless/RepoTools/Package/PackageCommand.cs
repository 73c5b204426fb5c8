namespace FastPoints.RepoTools.Package;

/// <summary>What Unity's package validation suite (0.86) and npm ask of a package, as far as it can be told without an editor,
/// and what a user gets who installs it.</summary>
public static class PackageCommand
{
    /// <param name="pack">Lists what npm would pack; null if it does not.</param>
    public static ToolResult Run(Repository repository, string? tag, NpmPack? pack)
    {
        var files = new PackageFiles(repository.PackageRoot);
        var manifest = PackageManifest.Load(files);
        var problems = new List<string>();
        problems.AddRange(manifest.Check());
        if (File.Exists(repository.UsedApi))
            problems.AddRange(manifest.CheckModules(File.ReadLines(repository.UsedApi).Select(l => l.Split('\t')[1]),
                files.With(".asmdef").Select(files.Read)));
        problems.AddRange(ChangelogRules.Check(files, manifest.Version));
        problems.AddRange(FileRules.Check(files));
        problems.AddRange(SampleRules.Check(files, manifest.Samples));
        problems.AddRange(AssemblyRules.Check(files));
        problems.AddRange(DocumentationRules.Check(files));
        if (tag != null)
            problems.AddRange(ChangelogRules.CheckRelease(files, manifest.Version, tag));
        string packed = "";
        if (pack != null)
        {
            problems.AddRange(pack.Check(files.All));
            packed = $", packed {pack.PackedBytes / 1e6:0.0} MB, installed {pack.InstalledBytes / 1e6:0.0} MB";
        }
        return new ToolResult($"{manifest.Name} {manifest.Version}, {files.All.Count} files" + packed +
            (pack == null ? "; not packed: npm is not there" : ""), problems.Distinct().ToList());
    }
}
