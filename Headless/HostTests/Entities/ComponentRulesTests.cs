namespace FastPoints.HostTests.Entities;

public sealed class ComponentRulesTests
{
    sealed class Planted : ICleanupComponentData { }

    static IEnumerable<Type> Classes(IEnumerable<Type> types) =>
        types.Where(type => type.IsClass && typeof(IQueryTypeParameter).IsAssignableFrom(type));

    [Test]
    public void Components_OfThePackageAndItsSamples_AreUnmanaged()
    {
        var types = new[] { typeof(PointCloudSystemGroup), typeof(PointScene), typeof(StreamContext), typeof(ScenePicking),
            typeof(FastPoints.Samples.EntitiesOnly.EntitiesOnlyStart) }.SelectMany(type => type.Assembly.GetTypes()).ToArray();
        Assert.That(Classes(types), Is.Empty);
        Assert.That(types.Count(typeof(IComponentData).IsAssignableFrom), Is.GreaterThan(10), "they are looked at");
    }

    [Test]
    public void Classes_PlantedComponent_IsFound() => Assert.That(
        Classes(new[] { typeof(Planted), typeof(PointCloudFile), typeof(World) }), Is.EqualTo(new[] { typeof(Planted) }));
}
