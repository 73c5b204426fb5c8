namespace UnityOutside.Hpc;

/// <summary>Which layouts of structs Burst compiles. Its manual lists Pack as supported, tests of 1.6 have it refused: the rule
/// is the stricter one.</summary>
internal static class HpcLayout
{
    internal static string? Objection(TypeDefinition type)
    {
        // What an array's initial values lie in is packed, and Burst knows it.
        if (type.IsEnum || type.DeclaringType?.Name == "<PrivateImplementationDetails>")
            return null;
        // The variables that a local function captures lie in such a struct, too; those Burst takes.
        if (type.IsAutoLayout && type.CustomAttributes.All(a => a.AttributeType.Name != "CompilerGeneratedAttribute"))
            return $"{type.Name} with Auto layout";
        if (type.PackingSize > 0)
            return $"{type.Name} with Pack = {type.PackingSize}";
        List<FieldDefinition> fields = type.Fields.Where(f => !f.IsStatic).ToList();
        if (fields.Count == 0 && type.ClassSize <= 0)
            return $"{type.Name} with neither fields nor Size";
        int alignment = Alignment(type);
        if (type.IsSequentialLayout && type.ClassSize > 0 && type.ClassSize % alignment != 0)
            return $"{type.Name} with Size = {type.ClassSize}, no multiple of its alignment, {alignment}";
        FieldDefinition? marshalled = fields.FirstOrDefault(f => f.HasMarshalInfo && !IsU1(f));
        return marshalled == null ? null : $"{type.Name} with {marshalled.Name} {HpcSignature.As(marshalled)}";
    }

    internal static string? OfAll(TypeReference type) => OfAll(type, new HashSet<string>());

    private static string? OfAll(TypeReference type, HashSet<string> seen)
    {
        if (!type.IsValueType || type.IsPrimitive || !HpcTypes.IsPackage(type) || !seen.Add(type.FullName)
            || Resolution.Of(type) is not { } definition)
            return null;
        return Objection(definition)
            ?? definition.Fields.Where(f => !f.IsStatic).Select(f => OfAll(f.FieldType, seen)).FirstOrDefault(o => o != null);
    }

    /// <summary>A bool of one byte, which is what Burst makes of it anyhow; those of Mathematics are such.</summary>
    private static bool IsU1(FieldDefinition field) =>
        field.FieldType.MetadataType == MetadataType.Boolean && field.MarshalInfo.NativeType == NativeType.U1;

    private static int Alignment(TypeReference type)
    {
        switch (type.MetadataType)
        {
            case MetadataType.Boolean or MetadataType.Byte or MetadataType.SByte:
                return 1;
            case MetadataType.Int16 or MetadataType.UInt16 or MetadataType.Char:
                return 2;
            case MetadataType.Int32 or MetadataType.UInt32 or MetadataType.Single:
                return 4;
        }
        // Pointers, and numbers of eight bytes.
        if (type.IsPrimitive || !type.IsValueType)
            return 8;
        return (Resolution.Of(type)?.Fields.Where(f => !f.IsStatic).Select(f => Alignment(f.FieldType)) ?? Array.Empty<int>())
            .DefaultIfEmpty(1).Max();
    }
}
