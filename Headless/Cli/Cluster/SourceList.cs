using System.IO.Enumeration;

namespace FastPoints.Cli.Cluster;

/// <summary>Sources by name, by pattern, or in a list: more of them than a command line holds.</summary>
static class SourceList
{
    public static IEnumerable<string> Of(IEnumerable<string> words) => words.SelectMany(Expand);

    static IEnumerable<string> Expand(string word)
    {
        if (SourcePath.IsRemote(word) || Path.Exists(word))
            return [word];
        if (word.StartsWith('@'))
            return Lines(word[1..]);
        string pattern = Path.GetFileName(word);
        return pattern.AsSpan().IndexOfAny('*', '?') < 0 ? [word] : Matches(word, pattern);
    }

    static IEnumerable<string> Lines(string path)
    {
        var lines = StoreFile.ReadText(path, int.MaxValue - 1).Split('\n').Select(l => l.Trim())
            .Where(l => l.Length > 0).ToList();
        return lines.Count == 0
            ? throw new PointCloudException(FailureCode.BadInput, path, -1, "wanted a source a line, got none")
            : lines.SelectMany(l => S3Addresses.IsS3(l) ? [S3Addresses.Add(l)] : l.StartsWith('@') ? [l] : Expand(l));
    }

    static IEnumerable<string> Matches(string word, string pattern)
    {
        string folder = Path.GetDirectoryName(word) is { Length: > 0 } named ? named : ".";
        var found = !Directory.Exists(folder) ? [] : Directory.EnumerateFileSystemEntries(folder)
            .Where(path => FileSystemName.MatchesSimpleExpression(pattern, Path.GetFileName(path), ignoreCase: false))
            .Order(StringComparer.Ordinal).ToList();
        return found.Count > 0 ? found : throw new PointCloudException(FailureCode.NotFound, word, -1, "no file is called so");
    }
}
