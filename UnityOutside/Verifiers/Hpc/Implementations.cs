namespace UnityOutside.Hpc;

internal static class Implementations
{
    internal static MethodDefinition? Find(TypeReference type, MethodReference called, GenericScope scope)
    {
        TypeDefinition? definition = Resolution.Of(type);
        return definition?.Methods.FirstOrDefault(m => m.Overrides.Any(o => o.Name == called.Name
                && o.DeclaringType.GetElementType().FullName == called.DeclaringType.GetElementType().FullName))
            ?? definition?.Methods.FirstOrDefault(m => m.Name == called.Name && m.Parameters.Count == called.Parameters.Count
                && m.GenericParameters.Count == called.GetElementMethod().GenericParameters.Count
                && SameParameters(m, called, type, scope));
    }

    private static bool SameParameters(MethodDefinition target, MethodReference called, TypeReference type, GenericScope scope)
    {
        GenericScope ofInterface = scope.Of(called);
        GenericScope ofTarget = GenericScope.OfMember(type, Array.Empty<TypeReference>());
        for (int i = 0; i < target.Parameters.Count; i++)
        {
            TypeReference wanted = ofInterface.Concrete(called.Parameters[i].ParameterType);
            TypeReference have = ofTarget.Concrete(target.Parameters[i].ParameterType);
            bool isOpen = have.ContainsGenericParameter || wanted.ContainsGenericParameter;
            if (!isOpen && wanted.FullName != have.FullName)
                return false;
        }
        return true;
    }
}
