using StandIns.Entities;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Entities;

public unsafe struct EntityManager : IEquatable<EntityManager>
{
    internal EntityStore Store;
    World m_world;

    internal EntityManager(World world, EntityStore store) => (m_world, Store) = (world, store);

    public World World => m_world;

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
            outputEntities[i] = Store.Copy(srcEntity, TypeRegistry.Of<Prefab>.Index.Value);
    }

    public void DestroyEntity(Entity entity) => Store.Destroy(entity);

    public void DestroyEntity(NativeArray<Entity> entities)
    {
        for (int i = 0; i < entities.Length; i++)
            Store.Destroy(entities[i]);
    }

    public void DestroyEntity(EntityQuery entityQuery)
    {
        using (var entities = entityQuery.ToEntityArray(Allocator.Temp))
            DestroyEntity(entities);
    }

    public bool Exists(Entity entity) => Store.Exists(entity);
    public bool HasComponent<T>(Entity entity) => Store.Has(entity, TypeRegistry.Of<T>.Index.Value);
    public bool AddComponent<T>(Entity entity) => Store.Add(entity, TypeRegistry.Of<T>.Index.Value);

    public bool AddComponentData<T>(Entity entity, T componentData) where T : unmanaged, IComponentData
    {
        bool isNew = AddComponent<T>(entity);
        SetComponentData(entity, componentData);
        return isNew;
    }

    public void AddComponentObject(Entity entity, object componentData)
    {
        if (componentData == null)
            throw new ArgumentNullException(nameof(componentData));
        int type = TypeRegistry.IndexOf(componentData.GetType()).Value;
        Store.Add(entity, type);
        Store.Column(entity, type, out int row).SetObject(row, componentData);
    }

    public bool RemoveComponent<T>(Entity entity) => Store.Remove(entity, TypeRegistry.Of<T>.Index.Value);

    public void RemoveComponent<T>(EntityQuery entityQuery)
    {
        using (var entities = entityQuery.ToEntityArray(Allocator.Temp))
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

    public T GetComponentObject<T>(Entity entity) =>
        (T)Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row).ObjectAt(row);

    public bool IsComponentEnabled<T>(Entity entity) where T : unmanaged, IEnableableComponent =>
        Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row).IsEnabled(row);

    public void SetComponentEnabled<T>(Entity entity, bool value) where T : unmanaged, IEnableableComponent =>
        Store.Column(entity, TypeRegistry.Of<T>.Index.Value, out int row).SetEnabled(row, value);

    public EntityQuery CreateEntityQuery(params ComponentType[] requiredComponents) =>
        new EntityQuery(Store, QueryTerms.Of(requiredComponents));

    public bool Equals(EntityManager other) => Store == other.Store;
    public override bool Equals(object obj) => obj is EntityManager other && Equals(other);
    public override int GetHashCode() => Store.GetHashCode();

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
