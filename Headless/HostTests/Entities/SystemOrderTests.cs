namespace FastPoints.HostTests.Entities;

public sealed class SystemOrderTests
{
    static Type[] Systems => typeof(PointCloudSystemGroup).Assembly.GetTypes()
        .Where(t => t.IsSubclassOf(typeof(ComponentSystemBase)) && !t.IsAbstract).ToArray();

    static string[] Order(bool isBackwards)
    {
        SystemOrder.IsBackwards = isBackwards;
        try
        {
            using var world = new World("order");
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, Systems);
            var group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
            group.SortSystems();
            return group.ManagedSystems.Select(s => s.GetType().Name).ToArray();
        }
        finally
        {
            SystemOrder.IsBackwards = false;
        }
    }

    [Test]
    public void Systems_AnyRegistrationOrder_RunInOneOrderWithoutAWarning()
    {
        var logged = new List<string>();
        UnityEngine.Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        try
        {
            Assert.That(Order(true), Is.EqualTo(Order(false)).And.Length.EqualTo(Systems.Length - 1));
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
        }
        Assert.That(logged, Is.Empty);
    }

    [Test]
    public void Systems_All_AreOfTheEditorsWorldAndOfPlayers()
    {
        foreach (var system in Systems)
            Assert.That(system.GetCustomAttribute<WorldSystemFilterAttribute>()?.FilterFlags,
                Is.EqualTo(WorldSystemFilterFlags.Default | WorldSystemFilterFlags.Editor), system.Name);
    }
}
