namespace FastPoints.HostTests.StandIns;

/// <summary>What Unity's Entities refuse: ./test --entities runs these on them, too.</summary>
public sealed class EntityRuleTests
{
    struct Health : IComponentData
    {
        public int Value;
    }

    struct Tag : IComponentData { }

    struct Burning : IComponentData, IEnableableComponent { }

    struct Tombstone : ICleanupComponentData
    {
        public int Number;
    }

    unsafe struct Large : IComponentData
    {
        public fixed byte Bytes[20000];
    }

    [DisableAutoCreation]
    sealed partial class Idle : SystemBase
    {
        public EntityQuery Query => GetEntityQuery(ComponentType.ReadOnly<Health>());
        protected override void OnUpdate() { }
    }

    [DisableAutoCreation]
    sealed partial class Broken : SystemBase
    {
        protected override void OnCreate() => throw new ArithmeticException("thrown at the beginning");
        protected override void OnUpdate() { }
    }

    [DisableAutoCreation]
    [UpdateInGroup(typeof(Idle))]
    sealed partial class Lost : SystemBase
    {
        protected override void OnUpdate() { }
    }

    [DisableAutoCreation]
    sealed partial class Ending : SystemBase
    {
        protected override void OnUpdate() => World.Dispose();
    }

    World m_world;

    EntityManager Entities => m_world.EntityManager;

    static EntityQueryBuilder Builder => new EntityQueryBuilder(Allocator.Temp);

    [SetUp]
    public void MakeWorld() => m_world = new World("rules");

    [TearDown]
    public void EndWorld()
    {
        if (m_world.IsCreated)
            m_world.Dispose();
    }

    [Test]
    public void Archetypes_WithATypeTwiceOrTooLarge_AreRefused()
    {
        Assert.That(() => Entities.CreateEntity(ComponentType.ReadWrite<Health>(), ComponentType.ReadOnly<Health>()),
            Throws.ArgumentException.With.Message.Contains("two components of the same type"));
        Assert.That(() => Entities.CreateEntity(ComponentType.ReadWrite<Large>()),
            Throws.ArgumentException.With.Message.Contains("too large"));
    }

    [Test]
    public void Entities_Destroyed_RejectComponents()
    {
        var gone = Entities.CreateEntity();
        Entities.DestroyEntity(gone);
        Assert.That(() => Entities.AddComponent<Tag>(gone),
            Throws.InvalidOperationException.With.Message.Contains("does not exist"));
        Assert.That(Entities.RemoveComponent<Tag>(gone), Is.False);
        Assert.That(() => Entities.AddComponentData(gone, new Health { Value = 1 }), Throws.InvalidOperationException);
        var there = Entities.CreateEntity();
        Assert.That(Entities.AddComponentData(there, new Tag()), Is.True);
        Assert.That(() => Entities.SetComponentData(there, new Tag()),
            Throws.ArgumentException.With.Message.Contains("zero sized"));
    }

    [Test]
    public void CleanupComponents_OfLivingEntities_BehaveLikeOthers()
    {
        Entity living = Entities.CreateEntity(), destroyed = Entities.CreateEntity();
        Entities.AddComponentData(living, new Tombstone { Number = 1 });
        Entities.AddComponentData(destroyed, new Tombstone { Number = 2 });
        Entities.DestroyEntity(destroyed);
        Entities.DestroyEntity(destroyed);
        Entities.RemoveComponent<Tombstone>(living);
        Assert.That((Entities.Exists(living), Entities.Exists(destroyed)), Is.EqualTo((true, true)));
        using var copies = new NativeArray<Entity>(1, Allocator.Temp);
        Assert.That(() => Entities.Instantiate(destroyed, copies),
            Throws.ArgumentException.With.Message.Contains("already been destroyed"));
    }

    [Test]
    public void Queries_ThatNameATypeTwice_AreRefused()
    {
        Assert.That(() => Entities.CreateEntityQuery(ComponentType.ReadWrite<Health>(), ComponentType.ReadOnly<Health>()),
            Throws.InstanceOf<EntityQueryDescValidationException>());
        Assert.That(() => Builder.WithAll<Health>().WithNone<Health>().Build(Entities),
            Throws.InstanceOf<EntityQueryDescValidationException>());
        Assert.That(() => Builder.WithAny<Health>().WithAll<Health>().Build(Entities),
            Throws.InstanceOf<EntityQueryDescValidationException>());
        Assert.That(() => Builder.WithAll<Burning>().WithPresent<Burning>().Build(Entities),
            Throws.InstanceOf<EntityQueryDescValidationException>());
        Assert.That(() => Builder.WithAbsent<Burning>().WithDisabled<Burning>().Build(Entities),
            Throws.InstanceOf<EntityQueryDescValidationException>());
        Assert.That(() => Builder.WithDisabled<Health>().Build(Entities),
            Throws.InvalidOperationException.With.Message.Contains("enableable"));
        Assert.That(() => Builder.WithOptions(EntityQueryOptions.IncludeDisabledEntities).WithOptions(EntityQueryOptions.Default)
            .Build(Entities),
            Throws.InvalidOperationException.With.Message.Contains("once"));
    }

    [Test]
    public void Builder_UsedAgain_LeavesTheFirstQueryUnchanged()
    {
        var builder = Builder.WithAll<Health>();
        using var first = builder.Build(Entities);
        using var second = builder.WithAll<Tag>().Build(Entities);
        Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        Assert.That(first.CalculateEntityCount(), Is.EqualTo(1));
        Assert.That(second.Equals(first), Is.False);
    }

    [Test]
    public void Queries_DisposedOrOfOtherWorlds_AreRefused()
    {
        var query = Entities.CreateEntityQuery(ComponentType.ReadOnly<Health>());
        var copy = query;
        Assert.That(() => query.ToComponentDataArray<Burning>(Allocator.Temp),
            Throws.InvalidOperationException.With.Message.Contains("not declared"));
        query.Dispose();
        Assert.That(() => copy.CalculateEntityCount(), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => copy.Dispose(), Throws.InstanceOf<ObjectDisposedException>());
        var ofASystem = m_world.GetOrCreateSystemManaged<Idle>().Query;
        Assert.That(() => ofASystem.Dispose(), Throws.InvalidOperationException.With.Message.Contains("owned"));
        using var other = new World("other");
        Assert.That(() => other.EntityManager.DestroyEntity(ofASystem), Throws.ArgumentException);
    }

    [Test]
    public void Worlds_Disposed_ReturnNothing()
    {
        var manager = Entities;
        var system = m_world.GetOrCreateSystemManaged<Idle>();
        var entity = manager.CreateEntity();
        m_world.Dispose();
        Assert.That(() => manager.Exists(entity), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => manager.HasComponent<Tag>(entity), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => manager.CreateArchetype(ComponentType.ReadOnly<Tag>()), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => manager.World, Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => m_world.EntityManager, Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => m_world.GetExistingSystemManaged<Idle>(), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => m_world.Update(), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => system.Update(), Throws.InvalidOperationException);
        Assert.That(() => system.Enabled, Throws.InvalidOperationException);
        Assert.That(() => new Idle().EntityManager, Throws.InvalidOperationException);
    }

    [Test]
    public void Systems_ThatCannotBeCreated_AreAbsent()
    {
        Assert.That(() => m_world.GetOrCreateSystemManaged<Broken>(), Throws.TypeOf<ArithmeticException>());
        Assert.That(m_world.GetExistingSystemManaged<Broken>(), Is.Null);
        Assert.That(() => m_world.GetOrCreateSystemManaged(typeof(Health)), Throws.ArgumentException);
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Broken), typeof(Idle));
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.TypeOf<ArithmeticException>());
        Assert.That(m_world.GetExistingSystemManaged<Idle>(), Is.Not.Null);
        Assert.That(() => DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Lost)),
            Throws.InvalidOperationException.With.Message.Contains("ComponentSystemGroup"));
    }

    [Test]
    public void World_DisposedByItsOwnSystem_StaysAndReportsIt()
    {
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Ending));
        m_world.Update();
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.ArgumentException.With.Message.Contains("executing"));
        Assert.That(m_world.IsCreated, Is.True);
    }
}
