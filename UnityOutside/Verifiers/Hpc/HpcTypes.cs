namespace UnityOutside.Hpc;

internal static class HpcTypes
{
    internal static string? Objection(TypeReference type) => Objection(type, new HashSet<string>());

    /// <summary>An array of numbers or of such arrays, which Burst reads (and only reads) from a static readonly field.</summary>
    internal static bool IsTable(TypeReference type) => type is ArrayType { IsVector: true } array
        && (array.ElementType.IsValueType ? Objection(array.ElementType) == null : IsTable(array.ElementType));

    internal static bool IsException(TypeReference type)
    {
        for (TypeDefinition? at = Resolution.Of(type); at != null; at = at.BaseType == null ? null : Resolution.Of(at.BaseType))
        {
            if (at.FullName == "System.Exception")
                return true;
        }
        // Without .NET's own assemblies a name is all there is.
        return Resolution.Of(type) == null && type.Name.EndsWith("Exception", System.StringComparison.Ordinal);
    }

    private static string? Objection(TypeReference type, HashSet<string> seen)
    {
        switch (type)
        {
            case GenericParameter:
            case PointerType:
            case FunctionPointerType:
                return null;
            case ByReferenceType reference:
                return Objection(reference.ElementType, seen);
            case ArrayType:
                return "a managed array";
            case PinnedType or IModifierType:
                return Objection(((TypeSpecification)type).ElementType, seen);
        }
        switch (type.MetadataType)
        {
            case MetadataType.Char:
                return "a char";
            case MetadataType.String:
                return "a string";
            case MetadataType.Object:
                return "an object";
        }
        if (type.FullName == "System.Decimal")
            return "a decimal";
        // Containers hold one for managed code; to compiled code it is never there.
        if (type.MetadataType == MetadataType.Void || type.FullName == "Unity.Collections.LowLevel.Unsafe.DisposeSentinel")
            return null;
        if (!type.IsValueType)
            return $"of the class {type.FullName}";
        if (type is GenericInstanceType instance
            && instance.GenericArguments.Select(a => Objection(a, seen)).FirstOrDefault(o => o != null) is { } inArgument)
            return inArgument;
        // Unity's and .NET's structs are what their own rules say; a stand-in's fields are not theirs.
        if (!IsPackage(type) || type.IsPrimitive || !seen.Add(type.FullName) || Resolution.Of(type) is not { } definition)
            return null;
        if (HpcLayout.Objection(definition) is { } inLayout)
            return inLayout;
        foreach (FieldDefinition field in definition.Fields.Where(f => !f.IsStatic))
        {
            if (Objection(field.FieldType, seen) is { } objection)
                return $"{type.Name} with {field.Name}, {objection}";
        }
        return null;
    }

    internal static bool IsPackage(TypeReference type)
    {
        string assembly = Origins.AssemblyOf(type);
        return !Origins.IsUnity(assembly) && !Origins.IsSystem(assembly);
    }
}
