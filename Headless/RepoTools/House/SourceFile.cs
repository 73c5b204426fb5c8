namespace FastPoints.RepoTools.House;

public sealed record SourceFile(string Path, string Text)
{
    private const string Package = "Packages/com.fastpoints.dots/";
    private const string Manual = Package + "Documentation~/";
    private const string Entities = "FastPoints.Entities";

    private static readonly string[] s_code = { ".cs", ".hlsl", ".shader", ".compute" };

    public bool IsCSharp => Path.EndsWith(".cs", StringComparison.Ordinal);
    public bool IsCode => IsCodePath(Path);

    public bool IsProduct => IsCSharp && (Path.StartsWith(Package + "Runtime/", StringComparison.Ordinal) ||
        Path.StartsWith(Package + "Editor/", StringComparison.Ordinal));

    /// <summary>Part of the stand-ins for Unity.</summary>
    public bool IsOutside => Path.StartsWith("UnityOutside/", StringComparison.Ordinal);

    /// <summary>The first folder below an assembly's, or the assembly, of a file of the product; empty for an assembly's
    /// list of friends, which is in no room.</summary>
    public string Room
    {
        get
        {
            string[] parts = Path[Package.Length..].Split('/');
            int assembly = parts[0] == "Editor" ? 0 : 1;
            bool isWhole = parts.Length == assembly + 2 || parts[assembly] == Entities;
            return parts[^1] == "AssemblyInfo.cs" ? "" : string.Join('/', parts[assembly..(assembly + (isWhole ? 1 : 2))]);
        }
    }

    public bool IsManual => Path.StartsWith(Manual, StringComparison.Ordinal) && Path.EndsWith(".md", StringComparison.Ordinal);

    /// <summary>Of the manual: what its users read.</summary>
    public bool IsForUsers => IsManual && !Path.StartsWith(Manual + "internals/", StringComparison.Ordinal);

    public bool IsReadme => Path == "README.md";

    public string Folder => Path.Contains('/') ? Path[..Path.LastIndexOf('/')] : ".";
    public int LineCount => Text.Count(c => c == '\n') + (Text.Length > 0 && Text[^1] != '\n' ? 1 : 0);

    public int WordCount => ReferenceBlock.Remove(Text).Replace('|', ' ')
        .Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries).Length;

    public static bool IsWanted(string path) => IsCodePath(path) ||
        new SourceFile(path, "") is { IsManual: true } or { IsReadme: true };

    // Tables that a verb makes are data.
    private static bool IsCodePath(string path) => s_code.Any(e => path.EndsWith(e, StringComparison.Ordinal)) &&
        !path.EndsWith(".g.cs", StringComparison.Ordinal);
}
