namespace UnityOutside.Hpc;

/// <summary>What may pass between compiled code and other code, managed or native: through a [BurstCompile] method that managed
/// code calls, and through an extern. Burst's manual: DllImport and internal calls, Function pointers, types.</summary>
internal static class HpcSignature
{
    private static readonly string[] s_vectors =
    {
        "Unity.Burst.Intrinsics.v64", "Unity.Burst.Intrinsics.v128", "Unity.Burst.Intrinsics.v256",
    };

    internal static IEnumerable<string> OfEntry(MethodDefinition method)
    {
        foreach (ParameterDefinition parameter in method.Parameters)
        {
            // Older versions refuse them all, newer ones take bools of one byte.
            if (parameter.HasMarshalInfo)
                yield return $"parameter {parameter.Name} is {As(parameter)}";
        }
        foreach (TypeReference type in method.Parameters.Select(p => p.ParameterType).Append(method.ReturnType))
        {
            if (Crossing(type) is { } objection)
                yield return objection;
        }
    }

    internal static string? OfExtern(MethodDefinition method)
    {
        foreach (ParameterDefinition parameter in method.Parameters)
        {
            if (ThroughExtern(parameter.ParameterType, parameter) is { } objection)
                return objection;
        }
        return ThroughExtern(method.ReturnType, method.MethodReturnType);
    }

    internal static string? Marshalling(IMarshalInfoProvider member, TypeReference type) =>
        !member.HasMarshalInfo || IsByte(member, type) ? null : As(member);

    internal static string As(IMarshalInfoProvider member) => $"marshalled as {Name(member.MarshalInfo.NativeType)}";

    /// <summary>Why a field of a job cannot be: what is in it comes from managed code as it lies there.</summary>
    internal static string? OfField(TypeReference type) => Managed(type, new HashSet<string>());

    private static string? ThroughExtern(TypeReference type, IMarshalInfoProvider member)
    {
        if (type.MetadataType == MetadataType.Boolean && !member.HasMarshalInfo)
            return "a bool that is not marshalled as U1";
        return HpcTypes.Objection(type) ?? Marshalling(member, type) ?? Crossing(type);
    }

    private static string? Crossing(TypeReference type)
    {
        if (type is ByReferenceType reference)
        {
            if (BoolIn(reference.ElementType, new HashSet<string>()) is { } name)
                return $"{reference.ElementType.Name} by reference with the bool {name}, which is not marshalled as U1";
            return OfField(reference.ElementType) is { } inside ? "a parameter " + inside : null;
        }
        bool isStruct = type.IsValueType && !type.IsPrimitive && Resolution.Of(type)?.IsEnum == false;
        return isStruct && !IsHandle(type) && !s_vectors.Contains(type.FullName)
            ? $"{type.Name} by value; managed code gives Burst structs by reference only"
            : null;
    }

    private static bool IsHandle(TypeReference type)
    {
        List<FieldDefinition>? fields = Resolution.Of(type)?.Fields.Where(f => !f.IsStatic).ToList();
        return HpcTypes.IsPackage(type) && fields?.Count == 1 && fields[0].FieldType.MetadataType is MetadataType.Pointer
            or MetadataType.IntPtr or MetadataType.UIntPtr or (>= MetadataType.SByte and <= MetadataType.UInt64);
    }

    private static string? BoolIn(TypeReference type, HashSet<string> seen)
    {
        foreach (FieldDefinition field in Fields(type, seen))
        {
            bool isBool = field.FieldType.MetadataType == MetadataType.Boolean;
            if (isBool && !field.HasMarshalInfo)
                return field.Name;
            if (BoolIn(field.FieldType, seen) is { } name)
                return name;
        }
        return null;
    }

    private static string? Managed(TypeReference type, HashSet<string> seen)
    {
        if (type.FullName.StartsWith("System.ValueTuple`", StringComparison.Ordinal))
            return $"of the type {type.GetElementType().FullName}, whose layout is Auto";
        if (type.GetElementType().FullName is "System.Span`1" or "System.ReadOnlySpan`1")
            return $"of the type {type.GetElementType().FullName}, which may hold a managed array";
        return Fields(type, seen).Select(f => Managed(f.FieldType, seen)).FirstOrDefault(o => o != null);
    }

    // Unity's and .NET's structs are what their own rules say; a stand-in's fields are not theirs.
    private static IEnumerable<FieldDefinition> Fields(TypeReference type, HashSet<string> seen) =>
        type.IsValueType && !type.IsPrimitive && HpcTypes.IsPackage(type) && seen.Add(type.FullName)
            ? Resolution.Of(type)?.Fields.Where(f => !f.IsStatic) ?? Enumerable.Empty<FieldDefinition>()
            : Enumerable.Empty<FieldDefinition>();

    private static bool IsByte(IMarshalInfoProvider member, TypeReference type) =>
        type.MetadataType == MetadataType.Boolean && member.MarshalInfo.NativeType is NativeType.U1 or NativeType.I1;

    private static string Name(NativeType type) => type == NativeType.Int ? "IntPtr" : type.ToString();
}
