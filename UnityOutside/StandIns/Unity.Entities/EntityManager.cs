namespace Unity.Entities;

public unsafe struct EntityManager : IEquatable<EntityManager>
{
    readonly EntityStore m_store;
    readonly World m_world;

    internal EntityManager(World world, EntityStore store) => (m_world, m_store) = (world, store);

    internal EntityStore Store => m_store.Alive;

    public World World => Store.IsDisposed ? null : m_world;

    /// <summary>Rises with each structural change.</summary>
    public int EntityOrderVersion => Store.StructuralVersion;

    public EntityArchetype CreateArchetype(params ComponentType[] types)
    {
        Span<int> indices = stackalloc int[types.Length];
        for (int i = 0; i < types.Length; i++)
            indices[i] = types[i].TypeIndex.Value;
        return new EntityArchetype { Stored = Store.ArchetypeOf(indices) };
    }

    public Entity CreateEntity() => Store.Create(Store.ArchetypeOf(default));
    public Entity CreateEntity(EntityArchetype archetype) => Store.Create(Of(archetype));
    public Entity CreateEntity(params ComponentType[] types) => CreateEntity(CreateArchetype(types));

    public void CreateEntity(EntityArchetype archetype, NativeArray<Entity> entities)
    {
        for (int i = 0; i < entities.Length; i++)
            entities[i] = Store.Create(Of(archetype));
    }

    /// <summary>Copies with their values and with what is enabled, but no prefabs themselves.</summary>
    public void Instantiate(Entity srcEntity, NativeArray<Entity> outputEntities)
    {
        for (int i = 0; i < outputEntities.Length; i++)
            outputEntities[i] = Instantiate(srcEntity);
    }

    /// <summary>What is linked to it, too. Of components that name entities, the copies of groups alone name copies.</summary>
    public Entity Instantiate(Entity srcEntity)
    {
        var store = Store;
        var copies = Array.ConvertAll(Linked(srcEntity), e => store.Copy(store, e, TypeRegistry.Of<Prefab>.Index.Value));
        if (HasComponent<LinkedEntityGroup>(copies[0]))
            for (int i = 0; i < copies.Length; i++)
            {
                var group = GetBuffer<LinkedEntityGroup>(copies[0]);
                group[i] = new LinkedEntityGroup { Value = copies[i] };
            }
        return copies[0];
    }

    /// <summary>Copies with all their values, cleanup components excepted.</summary>
    public void CopyEntitiesFrom(EntityManager srcEntityManager, NativeArray<Entity> srcEntities,
        NativeArray<Entity> outputEntities = default)
    {
        for (int i = 0; i < srcEntities.Length; i++)
        {
            var copy = Store.Copy(srcEntityManager.Store, srcEntities[i]);
            if (outputEntities.IsCreated)
                outputEntities[i] = copy;
        }
    }

    /// <summary>What is linked to it, too.</summary>
    public void DestroyEntity(Entity entity)
    {
        foreach (var linked in Linked(entity))
            Store.Destroy(linked);
    }

    Entity[] Linked(Entity entity)
    {
        if (!HasComponent<LinkedEntityGroup>(entity))
            return new[] { entity };
        var group = GetBuffer<LinkedEntityGroup>(entity, true);
        var linked = new Entity[group.Length];
        for (int i = 0; i < linked.Length; i++)
            linked[i] = group[i].Value;
        return linked;
    }

    public void DestroyEntity(NativeArray<Entity> entities)
    {
        for (int i = 0; i < entities.Length; i++)
            DestroyEntity(entities[i]);
    }

    public void DestroyEntity(EntityQuery entityQuery)
    {
        using (var entities = entityQuery.Of(Store).ToEntityArray(Allocator.Temp))
            DestroyEntity(entities);
    }

    public bool Exists(Entity entity) => Store.Exists(entity);
    public bool HasComponent<T>(Entity entity) => Store.Has(entity, TypeRegistry.Of<T>.Index.Value);
    public bool AddComponent<T>(Entity entity) => Store.Add(entity, TypeRegistry.Of<T>.Index.Value);

    public bool AddComponentData<T>(Entity entity, T componentData) where T : unmanaged, IComponentData
    {
        bool isNew = AddComponent<T>(entity);
        if (TypeRegistry.InfoOf(TypeRegistry.Of<T>.Index.Value).SizeBytes > 0)
            SetComponentData(entity, componentData);
        return isNew;
    }

    /// <summary>One that is there already keeps what it has.</summary>
    public DynamicBuffer<T> AddBuffer<T>(Entity entity) where T : unmanaged, IBufferElementData
    {
        AddComponent<T>(entity);
        return GetBuffer<T>(entity);
    }

    public DynamicBuffer<T> GetBuffer<T>(Entity entity, bool isReadOnly = false) where T : unmanaged, IBufferElementData
    {
        var column = Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row);
        return new DynamicBuffer<T>((BufferStore*)column.At(row), Store, isReadOnly);
    }

    public bool RemoveComponent<T>(Entity entity) => Store.Remove(entity, TypeRegistry.Of<T>.Index.Value);

    public void RemoveComponent<T>(EntityQuery entityQuery)
    {
        using (var entities = entityQuery.Of(Store).ToEntityArray(Allocator.Temp))
            for (int i = 0; i < entities.Length; i++)
                RemoveComponent<T>(entities[i]);
    }

    public T GetComponentData<T>(Entity entity) where T : unmanaged, IComponentData
    {
        var column = Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row);
        CheckHasData(column);
        return UnsafeUtility.ReadArrayElement<T>(column.At(row), 0);
    }

    public void SetComponentData<T>(Entity entity, T componentData) where T : unmanaged, IComponentData
    {
        var column = Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row);
        CheckHasData(column);
        UnsafeUtility.WriteArrayElement(column.At(row), 0, componentData);
        ComponentWrites<T>.Count++;
    }

    public bool IsComponentEnabled<T>(Entity entity) where T : unmanaged, IEnableableComponent =>
        Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row).IsEnabled(row);

    public void SetComponentEnabled<T>(Entity entity, bool value) where T : unmanaged, IEnableableComponent =>
        Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row).SetEnabled(row, value);

    public EntityQuery CreateEntityQuery(params ComponentType[] requiredComponents) =>
        new EntityQuery(Store, QueryTerms.Of(requiredComponents));

    public bool Equals(EntityManager other) => m_store == other.m_store;
    public override bool Equals(object obj) => obj is EntityManager other && Equals(other);
    public override int GetHashCode() => m_store.GetHashCode();

    static Archetype Of(EntityArchetype archetype) => archetype.Stored ??
        throw new ArgumentException("CreateEntity with an archetype that was not created by CreateArchetype");

    static void CheckHasData(ComponentColumn column)
    {
        if (column.Info.SizeBytes == 0)
            throw new ArgumentException("GetComponentData and SetComponentData can not be called with " +
                "a zero sized component: " + column.Info.Type.Name);
    }
}

/// <summary>How often the main thread has set components of a type: each time Unity completes all jobs that use the type, and
/// tells those who look for changes of one.</summary>
static class ComponentWrites<T>
{
    internal static int Count;
}
