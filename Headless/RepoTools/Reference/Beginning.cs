namespace FastPoints.RepoTools.Reference;

public static class Beginning
{
    private const int MaxMembers = 2;
    private const int MaxFields = 3;
    private const int MaxValues = 6;
    private const int FieldRank = 4;

    public static IEnumerable<string> Of(TypeDefinition type, ISet<string> inExamples)
    {
        if (type.IsEnum)
            return Values(type);
        // The simplest overload.
        List<(string Name, int Rank, string Text)> members = Members(type).GroupBy(m => m.Name)
            .Select(overloads => overloads.MinBy(m => m.Text.Length)).ToList();
        int max = members.All(m => m.Rank >= FieldRank) ? MaxFields : MaxMembers;
        bool isInExamples = inExamples.Contains(type.Name);
        return members.OrderBy(m => m.Rank == 0 ? 0 : isInExamples && inExamples.Contains(m.Name) ? 1 : 2)
            .ThenBy(m => m.Rank).Take(max).Select(m => m.Text);
    }

    private static IEnumerable<string> Values(TypeDefinition type)
    {
        List<string> names = type.Fields.Where(f => f.IsStatic).Select(f => f.Name).ToList();
        return names.Count <= MaxValues ? names : names.Take(MaxValues - 1).Append("...");
    }

    private static IEnumerable<(string Name, int Rank, string Text)> Members(TypeDefinition type)
    {
        foreach (MethodDefinition method in type.Methods.Where(m => IsSeen(m) && !IsOfAnother(m)))
        {
            if (method.IsConstructor && method.Parameters.Count > 0 && !type.IsAbstract)
                yield return (method.Name, 0, Signature.Of(method));
            else if (!method.IsSpecialName)
                yield return (method.Name, method.IsStatic && Signature.Makes(method, type) ? 0 : method.IsStatic ? 1 : 2,
                    Signature.Of(method));
        }
        foreach (PropertyDefinition property in type.Properties.Where(p => p.GetMethod is { } get && IsSeen(get)))
            yield return (property.Name, 3, Signature.Of(property));
        foreach (FieldDefinition field in type.Fields.Where(f => f.IsPublic && !f.IsSpecialName))
            yield return (field.Name, field.HasConstant ? FieldRank + 1 : FieldRank, Signature.Of(field));
    }

    private static bool IsSeen(MethodDefinition method) => method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;

    // What every object has, and what a base class or Unity calls.
    private static bool IsOfAnother(MethodDefinition method) => method.IsVirtual && !method.IsNewSlot ||
        method.Name is "Dispose" or "Equals" or "GetHashCode" or "ToString" ||
        method.Overrides.Count > 0;
}
