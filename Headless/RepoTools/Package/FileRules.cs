namespace FastPoints.RepoTools.Package;

/// <summary>Which files a package has and where (US-0032, 0040, 0110, 0113 of the validation suite), and that there are no
/// others.</summary>
public static class FileRules
{
    private const int LongestPath = 140;
    private const string Notices = "Third Party Notices.md"; // Required if a package contains the work of others.

    private static readonly string[] s_required =
        { "package.json", "README.md", "LICENSE.md", "CHANGELOG.md", "Documentation~/index.md" };

    /// <summary>Folders that end in '~' are not imported; Unity knows the purpose of these two.</summary>
    private static readonly string[] s_hidden = { "Documentation~", "Samples~" };

    private static readonly string[] s_folders = { "Runtime", "Editor", "Shaders", "Tests", "Benchmarks" };
    private static readonly string[] s_imported = { ".cs", ".asmdef", ".shader", ".compute", ".hlsl", ".asset", ".png",
        ".meta" };

    /// <summary>Extensions in the two folders that Unity does not import; it cannot use vector graphics.</summary>
    private static readonly string[] s_notImported =
        { ".md", ".png", ".webp", ".svg", ".json", ".cs", ".asmdef", ".meta", ".hlsl", ".shader", ".bytes" };

    private static readonly Regex s_direct = new Regex(
        @"(?<![\w.])(System\.IO\.)?File\.(Replace|Move|Delete|Copy|Open\w*|Create\w*)\(|" +
        @"\bDirectory\.(Move|Delete)\(|" +
        @"\bnew (System\.IO\.)?FileStream\(|\bFileUtil\.(Delete|Replace|Move|Copy)\w+\(|" +
        @"\.MoveTo\(|\b(FileInfo|DirectoryInfo)\([^)]*\)\.Delete\(");

    public static IEnumerable<string> Check(PackageFiles files)
    {
        foreach (string missing in s_required.Where(f => !files.Has(f)))
            yield return $"{missing} is not there";
        if (files.Has("LICENSE.md") && files.Read("LICENSE.md").Trim().Length == 0)
            yield return "LICENSE.md is empty";
        foreach (string file in files.All)
        {
            string top = file.Split('/')[0];
            bool isHidden = s_hidden.Contains(top);
            if (!isHidden && file.Length > LongestPath)
                yield return $"{file}: {file.Length} characters in the package; some systems take no more than {LongestPath}";
            if (file.Split('/').Any(part => part.StartsWith('.')))
                yield return $"{file}: a hidden file, which npm or Unity leaves out";
            if (file.Split('/').SkipLast(1).Skip(1).FirstOrDefault(part => part.EndsWith('~')) is { } inner)
                yield return $"{file}: {inner} is not at the package's top, where Unity looks for it";
            if (!IsExpected(file, top, isHidden))
                yield return $"{file}: nobody expects it here";
        }
        foreach (string problem in files.All.Where(IsProduct).SelectMany(f => DirectChanges(f, files.Read(f))))
            yield return problem;
        if (files.Top.Contains("Samples") && files.Top.Contains("Samples~"))
            yield return "Samples and Samples~ are both there";
    }

    /// <summary>One class changes files, so that what Windows refuses is tried again everywhere.</summary>
    private static bool IsProduct(string file) => (file.StartsWith("Runtime/", StringComparison.Ordinal) ||
        file.StartsWith("Editor/", StringComparison.Ordinal)) && file.EndsWith(".cs", StringComparison.Ordinal) &&
        !file.EndsWith("/Core/FileChanges.cs", StringComparison.Ordinal);

    private static IEnumerable<string> DirectChanges(string file, string text) =>
        text.Split('\n').SelectMany((line, i) => s_direct.Matches(line.Split("//")[0]).Select(m =>
            $"{file}:{i + 1}: {m.Value.TrimEnd('(')}: FileChanges does this, and tries again what Windows refuses"));

    private static bool IsExpected(string file, string top, bool isHidden)
    {
        bool IsOf(string[] extensions) => extensions.Any(e => file.EndsWith(e, StringComparison.Ordinal));
        if (!file.Contains('/'))
            return s_required.Append(Notices).Contains(file) || s_required.Append(Notices).Concat(s_folders)
                .Contains(file.EndsWith(".meta", StringComparison.Ordinal) ? file[..^5] : "");
        return isHidden ? IsOf(s_notImported) : s_folders.Contains(top) &&
            (IsOf(s_imported) || top == "Tests" && file.EndsWith(".laz.bytes", StringComparison.Ordinal));
    }
}
