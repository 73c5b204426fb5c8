namespace UnityOutside.Threads;

internal static class TypeRelations
{
    internal static bool IsDelegate(TypeReference type) => type is not ArrayType
        and not ByReferenceType and not GenericParameter
        && Resolution.Of(type)?.BaseType?.FullName == "System.MulticastDelegate";

    internal static TypeReference Self(TypeDefinition type)
    {
        if (!type.HasGenericParameters)
            return type;
        var self = new GenericInstanceType(type);
        foreach (GenericParameter parameter in type.GenericParameters)
            self.GenericArguments.Add(parameter);
        return self;
    }

    internal static TypeReference? Base(TypeReference type) => Resolution.Of(type)?.BaseType is { } parent
        ? GenericScope.OfMember(type, Array.Empty<TypeReference>()).Concrete(parent)
        : null;

    internal static IEnumerable<TypeReference> AllOf(TypeReference type)
    {
        for (TypeReference? at = type; at != null; at = Base(at))
        {
            yield return at;
            foreach (TypeReference each in Interfaces(at))
                yield return each;
        }
    }

    /// <summary>Whether a value of that type may stand where the other is wanted. Type parameters that are open match all;
    /// arguments may differ in either direction (variance).</summary>
    internal static bool IsAssignable(TypeReference type, TypeReference wanted) =>
        wanted is GenericParameter || wanted.MetadataType == MetadataType.Object || AllOf(type).Any(t => Matches(t, wanted));

    private static IEnumerable<TypeReference> Interfaces(TypeReference type)
    {
        TypeDefinition? definition = Resolution.Of(type);
        if (definition == null || type is ArrayType)
            yield break;
        GenericScope scope = GenericScope.OfMember(type, Array.Empty<TypeReference>());
        foreach (TypeReference implemented in definition.Interfaces.Select(i => scope.Concrete(i.InterfaceType)))
        {
            yield return implemented;
            foreach (TypeReference inherited in Interfaces(implemented))
                yield return inherited;
        }
    }

    private static bool MayStandFor(TypeReference given, TypeReference asked) => given.IsValueType || asked.IsValueType
        ? Matches(given, asked)
        : IsAssignable(given, asked) || IsAssignable(asked, given);

    private static bool Matches(TypeReference have, TypeReference wanted)
    {
        if (have is GenericParameter || wanted is GenericParameter)
            return true;
        if (have.GetElementType().FullName != wanted.GetElementType().FullName)
            return false;
        if (have is not GenericInstanceType given || wanted is not GenericInstanceType asked)
            return true;
        return given.GenericArguments.Zip(asked.GenericArguments, MayStandFor).All(same => same);
    }
}
