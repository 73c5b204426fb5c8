using System.Text.RegularExpressions;

namespace StandIns.Graphics;

sealed class ShaderFiles
{
    static readonly Regex s_include = new Regex(@"^[ \t]*#[ \t]*include[ \t]+[""<]([^"">]+)["">]", RegexOptions.Multiline);
    static readonly Regex s_line = new Regex(@"^[ \t]*#[ \t]*line[ \t]+(\d+)");
    internal readonly string Root;
    readonly string m_folder;

    internal ShaderFiles(string path)
    {
        m_folder = Path.GetDirectoryName(Path.GetFullPath(path));
        for (Root = m_folder; Root != null
            && !Directory.Exists(Path.Combine(Root, "Packages")); Root = Path.GetDirectoryName(Root))
        {
        }
        Root ??= FromHere() ?? m_folder;
    }

    internal IEnumerable<string> Folders
    {
        get
        {
            yield return m_folder;
            yield return Root;
            yield return Path.Combine(Root, "UnityOutside", "StandIns", "ShaderIncludes");
        }
    }

    internal IEnumerable<string> Includes(string text)
    {
        var found = new HashSet<string>();
        var waiting = new Stack<(string Text, string Folder)>();
        waiting.Push((text, m_folder));
        while (waiting.Count > 0)
        {
            (string at, string folder) = waiting.Pop();
            foreach (Match match in s_include.Matches(at))
            {
                string file = Find(match.Groups[1].Value, folder);
                if (file == null || !found.Add(file))
                    continue;
                waiting.Push((File.ReadAllText(file), Path.GetDirectoryName(file)));
                yield return file;
            }
        }
    }

    internal string Flat(string text, string name) => Flat(text, name, m_folder);

    string Flat(string text, string name, string folder)
    {
        var flat = new StringBuilder();
        int next = 1;
        foreach (string line in text.Split('\n'))
        {
            next = s_line.Match(line) is { Success: true } renumbered ? int.Parse(renumbered.Groups[1].Value) : next + 1;
            string file = s_include.Match(line) is { Success: true } include ? Find(include.Groups[1].Value, folder) : null;
            if (file == null)
                flat.Append(line).Append('\n');
            else
                flat.Append($"#line 1 \"{Path.GetFileName(file)}\"\n")
                    .Append(Flat(File.ReadAllText(file), Path.GetFileName(file), Path.GetDirectoryName(file)))
                    .Append($"#line {next} \"{name}\"\n");
        }
        return flat.ToString();
    }

    string Find(string name, string folder)
    {
        string beside = Path.GetFullPath(Path.Combine(folder, name));
        if (File.Exists(beside))
            return beside;
        foreach (string root in Folders)
            if (File.Exists(Path.Combine(root, name)))
                return Path.GetFullPath(Path.Combine(root, name));
        return null;
    }

    // A shader outside of any project, in a test's folder: the repository that this runs from.
    static string FromHere()
    {
        string folder = AppContext.BaseDirectory;
        while (folder != null && !Directory.Exists(Path.Combine(folder, "Packages")))
            folder = Path.GetDirectoryName(folder);
        return folder;
    }
}
