namespace UnityOutside.Api;

public static class Origins
{
    public static string AssemblyOf(TypeReference type)
    {
        IMetadataScope scope = type.GetElementType().Scope;
        return scope is ModuleDefinition module ? module.Assembly.Name.Name : scope.Name;
    }

    public static bool IsUnity(string assembly) => assembly.StartsWith("Unity.", StringComparison.Ordinal)
        || assembly.StartsWith("UnityEngine", StringComparison.Ordinal)
        || assembly.StartsWith("UnityEditor", StringComparison.Ordinal);

    public static bool IsSystem(string assembly) => assembly is "netstandard" or "mscorlib" or "System"
        || assembly.StartsWith("System.", StringComparison.Ordinal);

    /// <summary>What a package may reference beside Unity's and its own: netstandard, and two that Unity brings along.</summary>
    public static bool IsThereInUnity(string assembly) =>
        assembly is "netstandard" or "mscorlib" or "nunit.framework" or "Newtonsoft.Json";

    /// <summary>The list's "A|B" (moved from A to B), UnityEngine:Core and so on, as names of assemblies.</summary>
    public static IEnumerable<string> AssembliesOf(ApiRow row)
    {
        foreach (string part in row.Assembly.Split('|'))
        {
            int colon = part.IndexOf(':');
            yield return colon < 0 ? part : part[..colon] + "." + part[(colon + 1)..] + "Module";
        }
    }

    public static string? ReferenceFor(ApiRow row) => row.Assembly.Split('|').FirstOrDefault(p => !p.Contains(':'));

    public static bool IsEditor(ApiRow row) =>
        row.Has("editor-only") || row.Assembly.StartsWith("UnityEditor:", StringComparison.Ordinal);
}
