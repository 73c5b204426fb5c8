namespace UnityOutside.Threads;

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

    private static string? Written(string name)
    {
        int end = name.IndexOf('>');
        return name.StartsWith('<') && end > 1 ? name[1..end] : null;
    }
}
