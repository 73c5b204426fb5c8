namespace UnityOutside.Hpc;

/// <summary>Where Burst starts: the jobs of an assembly and its methods with [BurstCompile].</summary>
public static class HpcEntries
{
    private const string BurstCompile = "Unity.Burst.BurstCompileAttribute";

    public static IEnumerable<TypeDefinition> Jobs(ModuleDefinition module) => module.GetTypes().Where(IsJob);

    internal static bool IsJob(TypeDefinition type) => type.IsValueType && JobInterfaces(type).Any();

    public static bool IsCompiled(ICustomAttributeProvider member) =>
        member.CustomAttributes.Any(a => a.AttributeType.FullName == BurstCompile);

    public static bool IsDiscarded(ICustomAttributeProvider method) =>
        method.CustomAttributes.Any(a => a.AttributeType.FullName == "Unity.Burst.BurstDiscardAttribute");

    internal static IEnumerable<MethodDefinition> OfJob(TypeDefinition job)
    {
        List<string> names = JobInterfaces(job)
            .SelectMany(i => Resolution.Of(i)?.Methods.Select(m => m.Name) ?? new[] { "Execute" }).ToList();
        return job.Methods.Where(m => names.Contains(m.Name) || m.Overrides.Any(o => names.Contains(o.Name)));
    }

    internal static IEnumerable<MethodDefinition> Methods(ModuleDefinition module) =>
        module.GetTypes().SelectMany(t => t.Methods).Where(m => m.HasBody && IsCompiled(m));

    private static IEnumerable<TypeReference> JobInterfaces(TypeDefinition type) => type.Interfaces
        .Select(i => i.InterfaceType).Where(i => i.Name.StartsWith("IJob", StringComparison.Ordinal)
            && i.Namespace.StartsWith("Unity.", StringComparison.Ordinal));
}
