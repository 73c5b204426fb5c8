namespace FastPoints.HostTests.Entities;

/// <summary>Components are structs without references: Entities has dropped all others.</summary>
public sealed class ComponentRulesTests
{
    sealed class Planted : ICleanupComponentData { }

    readonly struct PlantedReference(string text) : IBufferElementData
    {
        public string Text { get; } = text;
    }

    /// <summary>What Entities 6.7 does not compile: classes that are components, and structs that refer to some.</summary>
    static IEnumerable<Type> Managed(IEnumerable<Type> types) => types.Where(type => !type.IsInterface &&
        (typeof(IComponentData).IsAssignableFrom(type) || typeof(IBufferElementData).IsAssignableFrom(type)) &&
        (type.IsClass || HasReferences(type)));

    static bool HasReferences(Type type) => (bool)typeof(System.Runtime.CompilerServices.RuntimeHelpers)
        .GetMethod("IsReferenceOrContainsReferences").MakeGenericMethod(type).Invoke(null, null);

    [Test]
    public void Components_OfThePackageAndItsSamples_AreUnmanaged()
    {
        var assemblies = new[] { typeof(PointCloudSystemGroup), typeof(PointScene), typeof(StreamContext), typeof(ScenePicking),
            typeof(FastPoints.Samples.EntitiesOnly.EntitiesOnlyStart) }.Select(type => type.Assembly);
        var types = assemblies.SelectMany(assembly => assembly.GetTypes()).ToArray();
        Assert.That(Managed(types), Is.Empty);
        Assert.That(types.Count(typeof(IComponentData).IsAssignableFrom), Is.GreaterThan(10), "they are looked at");
    }

    [Test]
    public void Managed_PlantedComponents_AreFound() =>
        Assert.That(Managed(new[] { typeof(Planted), typeof(PlantedReference), typeof(PointCloudFile), typeof(Entity) }),
            Is.EqualTo(new[] { typeof(Planted), typeof(PlantedReference) }));
}
