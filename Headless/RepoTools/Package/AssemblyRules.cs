namespace FastPoints.RepoTools.Package;

/// <summary>Scripts and their assemblies (US-0038 of the validation suite), and that no player's code names the editor.</summary>
public static class AssemblyRules
{
    private static readonly string[] s_forPlayers = { "Runtime/", "Samples~/" };
    private static readonly Regex s_editorPart = new Regex(@"#if UNITY_EDITOR\b.*?#(else|elif|endif)", RegexOptions.Singleline);
    private static readonly Regex s_comment = new Regex(@"//[^\n]*");

    public static IEnumerable<string> Check(PackageFiles files)
    {
        var assemblies = new List<(string Folder, bool IsEditor)>();
        foreach (string file in files.With(".asmdef"))
        {
            using JsonDocument json = JsonDocument.Parse(files.Read(file));
            string[] platforms = Strings(json.RootElement, "includePlatforms");
            bool isEditor = platforms.SequenceEqual(new[] { "Editor" });
            bool isTest = Strings(json.RootElement, "precompiledReferences").Contains("nunit.framework.dll");
            string name = json.RootElement.GetProperty("name").GetString()!;
            assemblies.Add((file[..(file.LastIndexOf('/') + 1)], isEditor));
            if (Path.GetFileNameWithoutExtension(file) != name)
                yield return $"{file}: the assembly is called {name}";
            if (file.StartsWith("Editor/", StringComparison.Ordinal) && !isEditor)
                yield return $"{file}: wanted Editor and nothing else in includePlatforms";
            if (file.StartsWith("Tests/", StringComparison.Ordinal) && !isTest)
                yield return $"{file}: no test assembly, as it has no nunit.framework.dll";
            bool isForTests = Strings(json.RootElement, "defineConstraints").Contains("UNITY_INCLUDE_TESTS");
            if (isTest && !isForTests)
                yield return $"{file}: a test assembly without UNITY_INCLUDE_TESTS would be in players";
            else if (!isEditor && !isForTests && !s_forPlayers.Any(f => file.StartsWith(f, StringComparison.Ordinal)))
                yield return $"{file}: every player would have it, used or not: wanted "
                    + "UNITY_INCLUDE_TESTS in defineConstraints";
            string[] references = Strings(json.RootElement, "references");
            if (references.Contains("Unity.Entities") && !references.Contains("Unity.Collections"))
                yield return $"{file}: references Unity.Entities and not Unity.Collections: its source "
                    + "generator ends with DC0061";
            if (file.StartsWith("Runtime/", StringComparison.Ordinal) && (isEditor || isTest))
                yield return $"{file}: only an editor or a test would have it";
        }
        foreach (string file in files.With(".cs"))
        {
            (string Folder, bool IsEditor) of = assemblies.Where(a => file.StartsWith(a.Folder, StringComparison.Ordinal))
                .OrderBy(a => a.Folder.Length).LastOrDefault();
            if (of.Folder == null)
                yield return $"{file}: in no assembly: there is no .asmdef above it";
            else if (!of.IsEditor && NamesEditor(files.Read(file)))
                yield return $"{file}: names UnityEditor, and players have this assembly";
        }
    }

    private static bool NamesEditor(string text) =>
        Regex.IsMatch(s_comment.Replace(s_editorPart.Replace(text, ""), ""), @"\bUnityEditor\b");

    private static string[] Strings(JsonElement of, string field) => of.TryGetProperty(field, out JsonElement list)
        ? list.EnumerateArray().Select(e => e.GetString()!).ToArray() : Array.Empty<string>();
}
