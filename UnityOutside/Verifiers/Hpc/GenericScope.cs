namespace UnityOutside.Hpc;

/// <summary>What a method's generic parameters stand for on one walk: Burst compiles each instance by itself.</summary>
internal sealed class GenericScope
{
    internal static readonly GenericScope None = new GenericScope(Array.Empty<TypeReference>(), Array.Empty<TypeReference>());

    private readonly IReadOnlyList<TypeReference> m_ofType;
    private readonly IReadOnlyList<TypeReference> m_ofMethod;

    private GenericScope(IReadOnlyList<TypeReference> ofType, IReadOnlyList<TypeReference> ofMethod) =>
        (m_ofType, m_ofMethod) = (ofType, ofMethod);

    internal GenericScope Of(MethodReference called) => new GenericScope(
        called.DeclaringType is GenericInstanceType type
            ? type.GenericArguments.Select(Concrete).ToList()
            : Array.Empty<TypeReference>(),
        called is GenericInstanceMethod method
            ? method.GenericArguments.Select(Concrete).ToList()
            : Array.Empty<TypeReference>());

    internal static GenericScope OfMember(TypeReference concrete, IReadOnlyList<TypeReference> ofMethod) => new GenericScope(
        concrete is GenericInstanceType type ? type.GenericArguments.ToList() : Array.Empty<TypeReference>(), ofMethod);

    internal TypeReference Concrete(TypeReference type)
    {
        switch (type)
        {
            case GenericParameter parameter:
                IReadOnlyList<TypeReference> arguments = parameter.Type == GenericParameterType.Method ? m_ofMethod : m_ofType;
                return parameter.Position < arguments.Count ? arguments[parameter.Position] : parameter;
            case GenericInstanceType instance:
                var concrete = new GenericInstanceType(instance.ElementType);
                foreach (TypeReference argument in instance.GenericArguments)
                    concrete.GenericArguments.Add(Concrete(argument));
                return concrete;
            case ByReferenceType reference:
                return new ByReferenceType(Concrete(reference.ElementType));
            case PointerType pointer:
                return new PointerType(Concrete(pointer.ElementType));
            case ArrayType array:
                return new ArrayType(Concrete(array.ElementType), array.Rank);
            case PinnedType pinned:
                return Concrete(pinned.ElementType);
            case IModifierType modifier:
                return Concrete(modifier.ElementType);
            default:
                return type;
        }
    }

    internal string Key => string.Join(",", m_ofType.Select(t => t.FullName)) + "|" +
        string.Join(",", m_ofMethod.Select(t => t.FullName));
}
