using Unity.Entities.Serialization;

namespace FastPoints.HostTests.Probes;

/// <summary>The package in worlds of Unity's own Entities, as projects have them: ./test --entities.</summary>
public sealed unsafe class WorldTests
{
    [Test]
    public void Assemblies_OfTheRun_AreTheWantedBuild()
    {
        bool isProcessed = Environment.GetEnvironmentVariable("REAL_ENTITIES") == "processed";
        Assert.That(RealEntities.Loading.Processed, Is.SupersetOf(new[] { "Unity.Entities", "Unity.Transforms" }));
        foreach (var assembly in new[] { typeof(PointCloudSystemGroup).Assembly, GetType().Assembly })
            Assert.That(assembly.GetType("Unity.Entities.CodeGeneratedRegistry.AssemblyTypeRegistry") != null,
                Is.EqualTo(isProcessed), assembly.GetName().Name);
    }

    [TestCase(WorldFlags.Editor)]
    [TestCase(WorldFlags.Game)]
    public void DefaultWorld_HasThePackagesSystemsAndDrawsACloud(WorldFlags flags)
    {
        var world = World.DefaultGameObjectInjectionWorld = new World("default", flags);
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(world, DefaultWorldInitialization
            .GetAllSystems(WorldSystemFilterFlags.Default, flags == WorldFlags.Editor)
            .Where(t => t.Assembly != GetType().Assembly).ToArray());
        using var probe = new ProbeWorld(world);
        var entities = probe.Entities;
        var entity = probe.AddCloud();
        entities.AddComponentData(entity, LocalTransform.FromPosition(new float3(3, 4, 5)));
        probe.Frames(() => probe.Group.Stats.IsSettled && probe.Group.Stats.DrawnPoints > 0);
        Assert.That(entities.HasComponent<StreamedPointCloud>(entity), Is.True);
        Assert.That(entities.GetComponentData<LocalToWorld>(entity).Position, Is.EqualTo(new float3(3, 4, 5)));
        entities.DestroyEntity(entity);
        probe.Frames(() => !entities.Exists(entity));
        World.DefaultGameObjectInjectionWorld = null;
    }

    [Test]
    public void Components_OfThePackage_AreKnownWithoutAWarning()
    {
        var logged = new List<string>();
        using var world = new World("types");
        UnityEngine.Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        try
        {
            foreach (var type in typeof(PointCloudSystemGroup).Assembly.GetTypes()
                .Where(t => t.IsValueType && t.GetInterfaces()
                    .Any(i => i == typeof(IComponentData) || i == typeof(IBufferElementData))))
            {
                var info = TypeManager.GetTypeInfo(TypeManager.GetTypeIndex(type));
                Assert.That(info.Type, Is.EqualTo(type));
                Assert.That(TypeManager.IsEnableable(info.TypeIndex),
                    Is.EqualTo(typeof(IEnableableComponent).IsAssignableFrom(type)), type.Name);
            }
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
        }
        Assert.That(logged, Is.Empty);
    }

    /// <summary>The checks themselves, without which the rest would say little.</summary>
    [Test]
    public void StructuralChanges_DuringJobs_AreRefused()
    {
        using var world = new World("checks");
        var entities = world.EntityManager;
        var entity = entities.CreateEntity(ComponentType.ReadWrite<Health>());
        using var query = entities.CreateEntityQuery(ComponentType.ReadWrite<Health>());
        var handle = entities.GetComponentTypeHandle<Health>(false);
        var job = new DamageAllJob { Health = handle }.ScheduleParallel(query, default);
        Assert.That(() => entities.GetComponentData<Health>(entity),
            Throws.InvalidOperationException.With.Message.Contains("DamageAllJob"));
        Assert.That(() => entities.CreateEntity(ComponentType.ReadWrite<Health>()),
            Throws.InvalidOperationException.With.Message.Contains("DamageAllJob"));
        job.Complete();
        Assert.That(entities.GetComponentData<Health>(entity).Value, Is.EqualTo(1));
        handle = entities.GetComponentTypeHandle<Health>(false);
        using var chunks = query.ToArchetypeChunkArray(Allocator.Temp);
        var values = chunks[0].GetNativeArray(ref handle);
        values[0] = default;
        entities.DestroyEntity(entities.CreateEntity(ComponentType.ReadWrite<Health>()));
        Assert.That(() => values[0], Throws.InstanceOf<ObjectDisposedException>(), "array of a chunk");
        Assert.That(() => chunks[0].GetNativeArray(ref handle), Throws.InstanceOf<ObjectDisposedException>(), "handle");
    }

    [Test]
    public void Jobs_OfUsersOverNodes_AreCompletedByThePackage()
    {
        using var probe = ProbeWorld.With(typeof(TintSystem));
        var entity = probe.AddCloud();
        int frames = 0;
        probe.Frames(() => frames++ > 300 && probe.World.GetExistingSystemManaged<TintSystem>().Scheduled > 100);
        probe.Entities.DestroyEntity(entity);
        probe.Frames(() => !probe.Entities.Exists(entity));
    }

    [Test]
    public void Subscene_WrittenReadAndMoved_ShowsItsCloud()
    {
        using var probe = ProbeWorld.With();
        byte[] bytes;
        using (var baked = new World("baked"))
        {
            baked.EntityManager.AddComponentData(probe.AddCloud(baked.EntityManager), new PointCloudLayer { Value = 7 });
            using var writer = new MemoryBinaryWriter();
            SerializeUtility.SerializeWorld(baked.EntityManager, writer, out object[] objects);
            Assert.That(objects, Is.Empty);
            bytes = new ReadOnlySpan<byte>(writer.Data, writer.Length).ToArray();
        }
        using var loaded = new World("loaded");
        fixed (byte* at = bytes)
        {
            using var reader = new MemoryBinaryReader(at, bytes.Length);
            var transaction = loaded.EntityManager.BeginExclusiveEntityTransaction();
            SerializeUtility.DeserializeWorld(transaction, reader);
            loaded.EntityManager.EndExclusiveEntityTransaction();
        }
        probe.Entities.MoveEntitiesFrom(loaded.EntityManager);
        using var query = probe.Query<PointCloudFile>();
        var entity = query.GetSingletonEntity();
        Assert.That(probe.Entities.GetComponentData<PointCloudLayer>(entity).Value, Is.EqualTo(7));
        probe.Frames(() => probe.Entities.HasComponent<StreamedPointCloud>(entity));
    }

    [Test]
    public void CommandBuffers_OfAUser_PlaceHideAndDestroy()
    {
        using var probe = ProbeWorld.With(typeof(EndSimulationEntityCommandBufferSystem));
        EntityCommandBuffer Commands() =>
            probe.World.GetExistingSystemManaged<EndSimulationEntityCommandBufferSystem>().CreateCommandBuffer();
        var entity = probe.AddCloud();
        var moved = float4x4.Translate(new float3(1, 2, 3));
        Commands().SetComponent(entity, new LocalToWorld { Value = moved });
        using var nodes = probe.Query<PointCloudNode>();
        probe.Frames(() => nodes.CalculateEntityCount() > 0 && probe.Group.Stats.IsSettled);
        Assert.That(probe.Entities.GetComponentData<LocalToWorld>(entity).Value, Is.EqualTo(moved));
        var commands = Commands();
        using (var all = nodes.ToEntityArray(Allocator.Temp))
            for (int i = 0; i < all.Length; i += 2)
                commands.SetComponentEnabled<Hidden>(all[i], true);
        probe.Frame();
        commands = Commands();
        commands.DestroyEntity(entity);
        probe.Frames(() => !probe.Entities.Exists(entity) && nodes.CalculateEntityCount() == 0);
    }

    [Test]
    public void Disabled_Cloud_IsHiddenAndComesBack()
    {
        using var probe = ProbeWorld.With();
        var entity = probe.AddCloud();
        probe.Frames(() => probe.Entities.HasComponent<StreamedPointCloud>(entity));
        probe.Entities.SetEnabled(entity, false);
        probe.Frames(() => probe.Group.Stream.Clouds[0].Placement.Visibility.IsHidden);
        probe.Entities.SetEnabled(entity, true);
        probe.Frames(() => !probe.Group.Stream.Clouds[0].Placement.Visibility.IsHidden);
    }
}
