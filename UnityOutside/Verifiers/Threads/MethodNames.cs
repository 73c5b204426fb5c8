namespace UnityOutside.Threads;

/// <summary>Methods as one knows them from the source: the compiler's own names are replaced by what they were made of.</summary>
internal static class MethodNames
{
    internal static string Of(MethodDefinition method)
    {
        string name = Written(method.Name) ?? method.Name;
        TypeDefinition type = method.DeclaringType;
        for (; type.DeclaringType != null && type.Name.StartsWith('<'); type = type.DeclaringType)
            name = Written(type.Name) ?? name;
        return DocId.DefinitionName(type).Split('.')[^1] + "." + name;
    }

    /// <summary>What stands between the brackets of a lambda's, a local function's or a state machine's name.</summary>
    private static string? Written(string name)
    {
        int end = name.IndexOf('>');
        return name.StartsWith('<') && end > 1 ? name[1..end] : null;
    }
}
