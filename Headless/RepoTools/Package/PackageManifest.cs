namespace FastPoints.RepoTools.Package;

/// <summary>package.json, checked by US-0005, 0006 and 0007 of the validation suite, except the names that are Unity's
/// own.</summary>
public sealed class PackageManifest
{
    private const int LongestDisplayName = 50;
    private const int ShortestDescription = 50;
    private static readonly Regex s_version =
        new Regex(@"^(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)(-[0-9A-Za-z-]+(\.[0-9A-Za-z-]+)*)?$");

    private readonly JsonElement m_root;

    private PackageManifest(JsonElement root)
    {
        m_root = root;
        Samples = root.TryGetProperty("samples", out JsonElement samples)
            ? samples.EnumerateArray()
                .Select(s => new PackageSample(Text(s, "displayName"), Text(s, "description"), Text(s, "path"))).ToList()
            : new List<PackageSample>();
    }

    public string Name => Text(m_root, "name");
    public string Version => Text(m_root, "version");
    public IReadOnlyList<PackageSample> Samples { get; }

    public static PackageManifest Load(PackageFiles files)
    {
        if (!files.Has("package.json"))
            throw new ToolException("package.json is not there");
        try
        {
            return new PackageManifest(JsonDocument.Parse(files.Read("package.json")).RootElement);
        }
        catch (JsonException e)
        {
            throw new ToolException("package.json: " + e.Message);
        }
    }

    public static bool IsVersion(string text) => s_version.IsMatch(text);

    public IEnumerable<string> Check()
    {
        if (!Regex.IsMatch(Name, @"^[a-z0-9][a-z0-9._-]{0,213}$") || !Name.Contains('.') ||
            Regex.IsMatch(Name, @"\.(framework|bundle|plugin)$"))
            yield return Wanted("name", "lower case with a dot, and no .framework, .bundle or .plugin", Name);
        if (!IsVersion(Version))
            yield return Wanted("version", "a semantic version", Version);
        string displayName = Text(m_root, "displayName");
        if (displayName.Length > LongestDisplayName || !Regex.IsMatch(displayName, "^[a-zA-Z0-9 ]+$"))
            yield return Wanted("displayName", $"at most {LongestDisplayName} letters, digits and spaces", displayName);
        string description = Text(m_root, "description");
        if (description.Length < ShortestDescription)
            yield return Wanted("description", $"at least {ShortestDescription} characters", description);
        if (!Regex.IsMatch(Text(m_root, "unity"), @"^\d{4}\.\d+$"))
            yield return Wanted("unity", "MAJOR.MINOR", Text(m_root, "unity"));
        string release = Text(m_root, "unityRelease");
        if (release.Length > 0 && !Regex.IsMatch(release, @"^\d+[abf]\d+$"))
            yield return Wanted("unityRelease", "a number, a, b or f, and a number", release);
        if (Text(m_root, "license").Length == 0)
            yield return Wanted("license", "its identifier", "");
        if (!m_root.TryGetProperty("dependencies", out JsonElement dependencies))
            yield break;
        foreach (JsonProperty dependency in dependencies.EnumerateObject())
        {
            string version = dependency.Value.GetString() ?? "";
            if (!IsVersion(version))
                yield return Wanted("dependencies." + dependency.Name, "one version, no range", version);
        }
    }

    /// <summary>A project may leave out any module of the engine that no package asks for. Names the modules that are used and
    /// not asked for, and those that are asked for in vain.</summary>
    /// <param name="asmdefs">Modules of their versionDefines may be left out.</param>
    public IEnumerable<string> CheckModules(IEnumerable<string> assemblies, IEnumerable<string> asmdefs)
    {
        var used = assemblies.Where(a => Regex.IsMatch(a, @"^UnityEngine:\w+$") && a != "UnityEngine:Core")
            .Select(a => "com.unity.modules." + a.Split(':')[1].ToLowerInvariant()).ToHashSet();
        var declared = m_root.TryGetProperty("dependencies", out JsonElement all)
            ? all.EnumerateObject().Select(d => d.Name)
                .Where(n => n.StartsWith("com.unity.modules.", StringComparison.Ordinal)).ToHashSet()
            : new HashSet<string>();
        used.ExceptWith(asmdefs.SelectMany(a => Regex.Matches(a, @"com\.unity\.modules\.\w+")).Select(m => m.Value));
        foreach (string module in used.Except(declared))
            yield return Wanted("dependencies." + module, "1.0.0, since it is used", "");
        foreach (string module in declared.Except(used))
            yield return Wanted("dependencies." + module, "none, since nothing of it is used", "one");
    }

    private static string Wanted(string field, string wanted, string got) =>
        $"package.json: {field}: wanted {wanted}, got \"{got}\"";

    private static string Text(JsonElement of, string field) =>
        of.TryGetProperty(field, out JsonElement value) && value.ValueKind == JsonValueKind.String ? value.GetString()! : "";
}

public sealed record PackageSample(string DisplayName, string Description, string Path);
