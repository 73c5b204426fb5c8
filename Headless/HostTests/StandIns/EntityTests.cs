namespace FastPoints.HostTests.StandIns;

public sealed class EntityTests
{
    struct Health : IComponentData
    {
        public int Value;
    }

    struct Burning : IComponentData, IEnableableComponent { }

    struct Tombstone : ICleanupComponentData
    {
        public int Number;
    }

    sealed class Managed : IComponentData { }

    struct Item : IBufferElementData
    {
        public long Value;
    }

    World m_world;

    EntityManager Entities => m_world.EntityManager;

    [SetUp]
    public void MakeWorld() => m_world = new World("test");

    [TearDown]
    public void EndWorld()
    {
        if (m_world.IsCreated)
            m_world.Dispose();
    }

    int Count(EntityQuery query) => query.CalculateEntityCount();

    [Test]
    public void Query_DisabledEntities_AreIncludedOnRequest()
    {
        Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        Entities.AddComponent<Disabled>(Entities.CreateEntity(ComponentType.ReadWrite<Health>()));
        EntityQueryBuilder Healthy() => new EntityQueryBuilder(Allocator.Temp).WithAll<Health>();
        Assert.That(Count(Healthy().Build(Entities)), Is.EqualTo(1));
        Assert.That(Count(Healthy().WithOptions(EntityQueryOptions.IncludeDisabledEntities).Build(Entities)), Is.EqualTo(2));
        Assert.That(Count(Healthy().WithAll<Disabled>().Build(Entities)), Is.EqualTo(1));
    }

    [Test]
    public void CreateAndDestroy_ManyInAnyOrder_KeepTheirData()
    {
        var random = new Unity.Mathematics.Random(3);
        var alive = new List<(Entity Entity, int Value)>();
        for (int i = 0; i < 5000; i++)
        {
            if (alive.Count > 0 && random.NextInt(3) == 0)
            {
                int gone = random.NextInt(alive.Count);
                Entities.DestroyEntity(alive[gone].Entity);
                Assert.That(Entities.Exists(alive[gone].Entity), Is.False);
                alive.RemoveAt(gone);
                continue;
            }
            var entity = Entities.CreateEntity(ComponentType.ReadWrite<Health>());
            Entities.SetComponentData(entity, new Health { Value = i });
            if (i % 2 == 0)
                Entities.AddComponent<Burning>(entity);
            alive.Add((entity, i));
        }
        foreach (var (entity, value) in alive)
            Assert.That(Entities.GetComponentData<Health>(entity).Value, Is.EqualTo(value));
        using var query = Entities.CreateEntityQuery(ComponentType.ReadOnly<Health>());
        using var all = query.ToEntityArray(Allocator.Temp);
        Assert.That(all.ToArray(), Is.EquivalentTo(alive.Select(a => a.Entity)));
    }

    [Test]
    public void Queries_OfEnableableComponents_CheckTheirBits()
    {
        var burns = Entities.CreateEntity(ComponentType.ReadWrite<Health>(), ComponentType.ReadWrite<Burning>());
        var out1 = Entities.CreateEntity(ComponentType.ReadWrite<Health>(), ComponentType.ReadWrite<Burning>());
        Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        Entities.SetComponentEnabled<Burning>(out1, false);
        Assert.That(Entities.IsComponentEnabled<Burning>(burns), Is.True, "enabled when it is added");
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithAll<Burning>().Build(Entities)), Is.EqualTo(1));
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithAll<Health>().WithNone<Burning>().Build(Entities)),
            Is.EqualTo(2));
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithDisabled<Burning>().Build(Entities)), Is.EqualTo(1));
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithPresent<Burning>().Build(Entities)), Is.EqualTo(2));
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithAll<Health>().WithAbsent<Burning>().Build(Entities)),
            Is.EqualTo(1));
        Assert.That(Count(new EntityQueryBuilder(Allocator.Temp).WithAny<Burning>().Build(Entities)), Is.EqualTo(1));
    }

    [Test]
    public void DestroyEntity_WithCleanup_KeepsItUntilRemoved()
    {
        var entity = Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        Entities.AddComponentData(entity, new Tombstone { Number = 7 });
        Entities.DestroyEntity(entity);
        Assert.That(Entities.Exists(entity), Is.True);
        Assert.That(Entities.HasComponent<Health>(entity), Is.False);
        Assert.That(Entities.GetComponentData<Tombstone>(entity).Number, Is.EqualTo(7));
        Entities.RemoveComponent<Tombstone>(entity);
        Assert.That(Entities.Exists(entity), Is.False);
    }

    [Test]
    public void Instantiate_CleanupAndPrefab_AreNotCopiedAndBuffersAre()
    {
        var entity = Entities.CreateEntity(ComponentType.ReadWrite<Health>(), ComponentType.ReadWrite<Prefab>());
        Entities.AddComponentData(entity, new Tombstone { Number = 7 });
        Entities.AddBuffer<Item>(entity).Add(new Item { Value = 5 });
        var copy = Entities.Instantiate(entity);
        Assert.That(Entities.HasComponent<Tombstone>(copy) || Entities.HasComponent<Prefab>(copy), Is.False);
        var items = Entities.GetBuffer<Item>(copy);
        items[0] = new Item { Value = 6 };
        for (int i = 0; i < 100; i++)
            items.Add(new Item { Value = i });
        Assert.That((Entities.GetBuffer<Item>(entity)[0].Value, Entities.GetBuffer<Item>(entity).Length), Is.EqualTo((5, 1)));
        Entities.AddComponent<Burning>(copy);
        Assert.That((Entities.GetBuffer<Item>(copy)[0].Value, Entities.GetBuffer<Item>(copy)[100].Value), Is.EqualTo((6, 99)));
        Assert.That(Entities.AddBuffer<Item>(copy).Length, Is.EqualTo(101), "it is there already");
        using var other = new World("other");
        using var copies = new NativeArray<Entity>(1, Allocator.Temp);
        using var sources = new NativeArray<Entity>(new[] { entity }, Allocator.Temp);
        other.EntityManager.CopyEntitiesFrom(Entities, sources, copies);
        Assert.That(other.EntityManager.GetBuffer<Item>(copies[0])[0].Value, Is.EqualTo(5));
        Assert.That(other.EntityManager.HasComponent<Prefab>(copies[0]), Is.True);
        Assert.That(other.EntityManager.HasComponent<Tombstone>(copies[0]), Is.False);
    }

    [Test]
    public void LinkedEntities_OfAPrefab_FollowIt()
    {
        Entity root = Entities.CreateEntity(), child = Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        var group = Entities.AddBuffer<LinkedEntityGroup>(root);
        group.Add(new LinkedEntityGroup { Value = root });
        group.Add(new LinkedEntityGroup { Value = child });
        var copy = Entities.Instantiate(root);
        var copied = Entities.GetBuffer<LinkedEntityGroup>(copy)[1].Value;
        Assert.That(Entities.GetBuffer<LinkedEntityGroup>(copy)[0].Value, Is.EqualTo(copy));
        Assert.That(copied, Is.Not.EqualTo(child));
        Entities.DestroyEntity(root);
        Assert.That((Entities.Exists(child), Entities.HasComponent<Health>(copied)), Is.EqualTo((false, true)));
    }

    [Test]
    public void CommandBuffer_PlayedBack_RunsCommandsInOrder()
    {
        var commands = new EntityCommandBuffer(Allocator.Temp);
        var made = commands.CreateEntity();
        commands.AddComponent(made, new Health { Value = 3 });
        commands.AddBuffer<Item>(made).Add(new Item { Value = 9 });
        commands.Instantiate(commands.Instantiate(made));
        using var query = Entities.CreateEntityQuery(ComponentType.ReadOnly<Health>(), ComponentType.ReadOnly<Item>());
        Assert.That(Count(query), Is.Zero);
        commands.Playback(Entities);
        Assert.That(Count(query), Is.EqualTo(3));
        using var all = query.ToEntityArray(Allocator.Temp);
        Assert.That(Entities.GetBuffer<Item>(all[2])[0].Value, Is.EqualTo(9));
        Assert.That(() => commands.Playback(Entities), Throws.InvalidOperationException);
        Assert.That(() => commands.CreateEntity(), Throws.InvalidOperationException);
        commands.Dispose();
    }

#if !REAL_ENTITIES
    /// <summary>Entities refuses them if UNITY_DISABLE_MANAGED_COMPONENTS is defined, and from 6.7 on.</summary>
    [Test]
    public void ManagedComponent_IsRefused() =>
        Assert.That(() => Entities.CreateEntity(new ComponentType(typeof(Managed))), Throws.ArgumentException);
#endif

    /// <summary>Planted violations: what Unity refuses.</summary>
    [Test]
    public void RadixSort_Misused_Throws()
    {
        var gone = Entities.CreateEntity(ComponentType.ReadWrite<Health>());
        Entities.DestroyEntity(gone);
        var bare = Entities.CreateEntity();
        Assert.That(() => Entities.GetComponentData<Health>(gone),
            Throws.ArgumentException.With.Message.Contains("does not exist"));
        Assert.That(() => Entities.GetComponentData<Health>(bare),
            Throws.ArgumentException.With.Message.Contains("has not been added"));
        Assert.That(() => Entities.SetComponentEnabled<Burning>(bare, true), Throws.ArgumentException);
        Entities.AddComponent<Burning>(bare);
        Assert.That(() => Entities.GetComponentData<Burning>(bare), Throws.ArgumentException.With.Message.Contains("zero sized"));
        Assert.That(() => Entities.CreateEntity(default(EntityArchetype)), Throws.ArgumentException);
        var items = Entities.AddBuffer<Item>(bare);
        Assert.That(() => items[0], Throws.InstanceOf<IndexOutOfRangeException>());
#if !REAL_ENTITIES
        // Unity's own takes both, over our safety handles.
        Assert.That(() => Entities.GetBuffer<Item>(bare, true).Add(default), Throws.InvalidOperationException);
        Entities.CreateEntity();
        Assert.That(() => items.Length, Throws.InstanceOf<ObjectDisposedException>(), "a structural change");
#endif
        Assert.That(() => default(EntityQuery).CalculateEntityCount(), Throws.InstanceOf<NullReferenceException>());
        var manager = Entities;
        m_world.Dispose();
        Assert.That(() => manager.CreateEntity(), Throws.InstanceOf<ObjectDisposedException>());
        Assert.That(() => Entities.DestroyEntity(gone), Throws.InstanceOf<ObjectDisposedException>());
    }

    static readonly List<string> s_calls = new List<string>();

    abstract class RecordingSystem : SystemBase
    {
        protected override void OnCreate() => s_calls.Add("+" + GetType().Name);
        protected override void OnStartRunning() => s_calls.Add(">" + GetType().Name);
        protected override void OnUpdate() => s_calls.Add(GetType().Name);
        protected override void OnStopRunning() => s_calls.Add("<" + GetType().Name);
        protected override void OnDestroy() => s_calls.Add("-" + GetType().Name);
    }

    [UpdateInGroup(typeof(PresentationSystemGroup))]
    sealed class Group : ComponentSystemGroup { }

    [UpdateInGroup(typeof(Group), OrderLast = true)]
    sealed class A : RecordingSystem { }

    [UpdateInGroup(typeof(Group))]
    [UpdateAfter(typeof(C))]
    sealed class B : RecordingSystem { }

    [UpdateInGroup(typeof(Group))]
    sealed class C : RecordingSystem { }

    [UpdateInGroup(typeof(Group))]
    [UpdateBefore(typeof(C))]
    sealed class D : RecordingSystem { }

    [Test]
    public void Systems_OfAGroup_RunInTheRequestedOrder()
    {
        s_calls.Clear();
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Group), typeof(A), typeof(B), typeof(C),
            typeof(D));
        s_calls.Clear();
        m_world.Update();
        Assert.That(s_calls, Is.EqualTo(new[] { ">D", "D", ">C", "C", ">B", "B", ">A", "A" }));
        m_world.GetExistingSystemManaged<C>().Enabled = false;
        s_calls.Clear();
        m_world.Update();
        m_world.Update();
        Assert.That(s_calls, Is.EqualTo(new[] { "D", "<C", "B", "A", "D", "B", "A" }));
        s_calls.Clear();
        m_world.Dispose();
        Assert.That(s_calls, Is.EqualTo(new[] { "<D", "<B", "<A", "-D", "-C", "-B", "-A" }));
    }

    [UpdateInGroup(typeof(FixedStepSimulationSystemGroup))]
    sealed class Step : RecordingSystem { }

    [Test]
    public void FixedSteps_WorldWhoseTimeStandsStill_AreOne()
    {
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(FixedStepSimulationSystemGroup),
            typeof(Step));
        s_calls.Clear();
        m_world.Update();
        m_world.Update();
        Assert.That(s_calls, Is.EqualTo(new[] { ">Step", "Step" }));
    }

    [Test]
    public void World_DisposedTwice_Throws()
    {
        m_world.Dispose();
        Assert.That(() => m_world.Dispose(), Throws.ArgumentException);
    }

    [UpdateInGroup(typeof(Group))]
    sealed class E : RecordingSystem
    {
        protected override void OnUpdate() => throw new ArithmeticException("thrown in a system");
        protected override void OnDestroy() => throw new ArithmeticException("thrown at the end");
    }

    [Test]
    public void System_ThatThrows_IsLoggedAndOthersRun()
    {
        DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Group), typeof(A), typeof(E));
        s_calls.Clear();
        Assert.That(() => m_world.Update(), Throws.Nothing);
        Assert.That(s_calls, Is.EqualTo(new[] { ">E", ">A", "A" }));
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.TypeOf<ArithmeticException>());
        Assert.That(() => m_world.Dispose(), Throws.Nothing);
        Assert.That(s_calls, Has.Member("-A"));
        Assert.That(() => LoggedExceptions.ThrowFirst(), Throws.TypeOf<ArithmeticException>());
    }

    [UpdateInGroup(typeof(Group), OrderFirst = true)]
    [UpdateAfter(typeof(C))]
    sealed class F : RecordingSystem { }

    [UpdateInGroup(typeof(Group))]
    [UpdateBefore(typeof(A))]
    [UpdateAfter(typeof(G))]
    sealed class G : RecordingSystem { }

    [Test]
    public void Systems_WhoseOrderUnityIgnores_AreWarnedOf()
    {
        var logged = new List<string>();
        UnityEngine.Debug.s_sink = (type, text) => logged.Add(type + ": " + text);
        try
        {
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(A));
            Assert.That(logged, Has.Count.EqualTo(1).And.Some.Contains("Warning").And.Some.Contains("group was not created"));
            logged.Clear();
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(Group), typeof(B), typeof(F), typeof(C));
            m_world.Update();
            Assert.That(logged, Has.Count.EqualTo(1).And.Some.Contains("precedence"));
            logged.Clear();
            m_world.GetExistingSystemManaged<Group>().RemoveSystemFromUpdateList(m_world.GetExistingSystemManaged<C>());
            m_world.GetExistingSystemManaged<Group>().SortSystems();
            Assert.That(logged, Has.Count.EqualTo(2).And.All.Contains("members of the same ComponentSystemGroup"));
            logged.Clear();
            DefaultWorldInitialization.AddSystemsToRootLevelSystemGroups(m_world, typeof(C), typeof(A), typeof(G));
            m_world.Update();
            Assert.That(logged.Where(l => l.Contains("itself")), Has.Some.Contains(typeof(G).FullName));
            Assert.That(logged.Where(l => l.Contains("precedence")), Has.Some.Contains(typeof(F).FullName)
                .And.Some.Contains(typeof(G).FullName), "one that is harmless is told of with one that is not");
        }
        finally
        {
            UnityEngine.Debug.s_sink = null;
        }
    }
}
