using System.Reflection;

namespace UnityOutside.Tests.Hpc;

[AttributeUsage(AttributeTargets.Struct | AttributeTargets.Class)]
internal sealed class PlantedAttribute(string reported = null) : Attribute
{
    public string Reported { get; } = reported;

    internal static IEnumerable<(Type Type, string Reported)> In(Type type) => type.GetNestedTypes(BindingFlags.NonPublic)
        .Select(t => (Type: t, Planted: t.GetCustomAttribute<PlantedAttribute>())).Where(p => p.Planted != null)
        .Select(p => (p.Type, p.Planted.Reported));
}
