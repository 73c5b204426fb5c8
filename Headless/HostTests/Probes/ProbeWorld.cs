namespace FastPoints.HostTests.Probes;

sealed class ProbeWorld : IDisposable
{
    const int MaxFrames = 200_000;

    static readonly Type[] s_systems = typeof(PointCloudSystemGroup).Assembly.GetTypes()
        .Where(t => typeof(SystemBase).IsAssignableFrom(t) && !t.IsAbstract).ToArray();

    readonly ScratchFolder m_scratch = new ScratchFolder();
    readonly string m_cloud;

    internal ProbeWorld(World world)
    {
        World = world;
        m_cloud = m_scratch.Converted(points: 20000);
        Group = world.GetExistingSystemManaged<PointCloudSystemGroup>();
        Group.Begin(new MemoryNodePool(64 << 20, 1 << 20));
        Entities.CreateEntity(ComponentType.ReadWrite<PointCloudNodesWanted>());
    }

    internal World World { get; }
    internal PointCloudSystemGroup Group { get; }
    internal EntityManager Entities => World.EntityManager;

    internal static ProbeWorld With(params Type[] others)
    {
        var world = new World("probe");
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, s_systems.Concat(others).ToArray());
        return new ProbeWorld(world);
    }

    internal Entity AddCloud() => AddCloud(Entities);

    internal Entity AddCloud(EntityManager entities)
    {
        var entity = entities.CreateEntity(ComponentType.ReadWrite<LocalToWorld>());
        entities.SetComponentData(entity, new LocalToWorld { Value = float4x4.identity });
        entities.AddComponentData(entity, new PointCloudFile());
        new PointCloudPaths { Path = m_cloud }.WriteTo(entities.AddBuffer<PointCloudPathByte>(entity));
        return entity;
    }

    internal EntityQuery Query<T>() => Entities.CreateEntityQuery(ComponentType.ReadOnly<T>());

    internal void Frames(Func<bool> isDone)
    {
        for (int i = 0; i < MaxFrames && !isDone(); i++)
            Frame();
        Assert.That(isDone(), Is.True);
    }

    internal void Frame()
    {
        Group.Views.Add(new StreamView { EyeWorld = new double3(0, 30, 0), ScalePx = 500 });
        World.Update();
        LoggedExceptions.ThrowFirst();
        Thread.Yield();
    }

    public void Dispose()
    {
        World.Dispose();
        m_scratch.Dispose();
    }
}
