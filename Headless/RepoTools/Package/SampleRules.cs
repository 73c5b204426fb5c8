namespace FastPoints.RepoTools.Package;

/// <summary>package.json's samples and the folders of Samples~ are the same (US-0116 of the validation suite), each with a
/// name and a word on what it is.</summary>
public static class SampleRules
{
    private const string Folder = "Samples~";

    public static IEnumerable<string> Check(PackageFiles files, IReadOnlyList<PackageSample> samples)
    {
        List<string> folders = files.FoldersIn(Folder).ToList();
        foreach (PackageSample sample in samples)
        {
            if (sample.DisplayName.Length == 0 || sample.Description.Length == 0)
                yield return $"package.json: sample \"{sample.Path}\": wanted a displayName and a description";
            if (!sample.Path.StartsWith(Folder + "/", StringComparison.Ordinal) ||
                !folders.Contains(sample.Path[(Folder.Length + 1)..]))
                yield return $"package.json: sample \"{sample.Path}\": there is no such folder in {Folder}";
        }
        foreach (string folder in folders.Where(f => samples.All(s => s.Path != Folder + "/" + f)))
            yield return $"{Folder}/{folder} is not among the samples of package.json";
        foreach (string same in samples.GroupBy(s => s.DisplayName).Where(g => g.Count() > 1).Select(g => g.Key))
            yield return $"package.json: two samples are called \"{same}\"";
    }
}
