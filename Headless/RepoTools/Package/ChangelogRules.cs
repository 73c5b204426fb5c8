namespace FastPoints.RepoTools.Package;

/// <summary>CHANGELOG.md as US-0039 of the validation suite has it: <c>## [x.y.z] - YYYY-MM-DD</c>, newest first, with
/// <c>## [Unreleased]</c> above them where there is something to release.</summary>
public static class ChangelogRules
{
    private const string File = "CHANGELOG.md";
    private const string Unreleased = "Unreleased";
    private static readonly Regex s_entry =
        new Regex(@"^## \[(?<version>[^\]]*)\](?: - (?<date>.*\S))?\s*$", RegexOptions.Multiline);

    public static IEnumerable<string> Check(PackageFiles files, string version)
    {
        if (!files.Has(File))
        {
            yield return $"{File} is not there";
            yield break;
        }
        List<(string Version, string Date)> entries = Entries(files);
        if (entries.Count == 0 || (entries[0].Version != Unreleased && entries[0].Version != version))
            yield return $"{File}: wanted [{version}] or [{Unreleased}] first, got "
                + $"{(entries.Count == 0 ? "no entry" : $"[{entries[0].Version}]")}";
        for (int i = 0; i < entries.Count; i++)
        {
            (string at, string date) = entries[i];
            if (at == Unreleased)
            {
                if (i > 0)
                    yield return $"{File}: [{Unreleased}] stands below [{entries[0].Version}]";
                continue;
            }
            if (!PackageManifest.IsVersion(at))
                yield return $"{File}: [{at}] is no semantic version";
            if (!DateTime.TryParseExact(date, "yyyy-MM-dd", CultureInfo.InvariantCulture, DateTimeStyles.None, out _))
                yield return $"{File}: [{at}]: wanted a date as YYYY-MM-DD, got \"{date}\"";
            if (i > 0 && entries[i - 1].Version != Unreleased && string.CompareOrdinal(entries[i - 1].Date, date) < 0)
                yield return $"{File}: [{at}] of {date} stands below [{entries[i - 1].Version}] of {entries[i - 1].Date}";
        }
        foreach (IGrouping<string, (string Version, string Date)> same in entries.GroupBy(e => e.Version)
            .Where(g => g.Count() > 1))
            yield return $"{File}: [{same.Key}] is there {same.Count()} times";
    }

    public static IEnumerable<string> CheckRelease(PackageFiles files, string version, string tag)
    {
        if (tag != version && tag != "v" + version)
            yield return $"the tag: wanted {version} or v{version}, got {tag}";
        if (files.Has(File) && Entries(files).FirstOrDefault().Version != version)
            yield return $"{File}: wanted the entry [{version}] with its date first, got "
                + $"[{Entries(files).FirstOrDefault().Version}]";
    }

    private static List<(string Version, string Date)> Entries(PackageFiles files) => s_entry.Matches(files.Read(File))
        .Select(m => (m.Groups["version"].Value, m.Groups["date"].Value)).ToList();
}
