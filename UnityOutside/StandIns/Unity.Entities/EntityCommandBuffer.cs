namespace Unity.Entities;

/// <summary>Changes that are made later, once and in order. Entities that it makes have numbers below 0 until then.</summary>
public unsafe struct EntityCommandBuffer : IDisposable
{
    readonly Recorded m_recorded;

    sealed class Recorded
    {
        public readonly List<Action<EntityManager>> Commands = new List<Action<EntityManager>>();
        public readonly List<IntPtr> Buffers = new List<IntPtr>();
        public readonly List<Entity> Made = new List<Entity>();
        public int Promised;
        public bool IsPlayed;
    }

    public EntityCommandBuffer(AllocatorManager.AllocatorHandle allocator) => m_recorded = new Recorded();

    public Entity CreateEntity() => Promise(entities => entities.CreateEntity());

    public Entity Instantiate(Entity e)
    {
        var recorded = m_recorded;
        return Promise(entities => entities.Instantiate(Resolve(recorded, e)));
    }

    public void AddComponent<T>(Entity e, T component) where T : unmanaged, IComponentData
    {
        var recorded = m_recorded;
        Record(entities => entities.AddComponentData(Resolve(recorded, e), component));
    }

    public DynamicBuffer<T> AddBuffer<T>(Entity e) where T : unmanaged, IBufferElementData
    {
        var recorded = m_recorded;
        var buffer = (BufferStore*)UnsafeUtility.Malloc(sizeof(BufferStore), 8, Allocator.Persistent);
        *buffer = default;
        recorded.Buffers.Add((IntPtr)buffer);
        Record(entities =>
        {
            var added = entities.AddBuffer<T>(Resolve(recorded, e));
            added.ResizeUninitialized(buffer->Length);
            UnsafeUtility.MemCpy(added.GetUnsafePtr(), buffer->Elements, (long)buffer->Length * sizeof(T));
        });
        return new DynamicBuffer<T>(buffer, null, false);
    }

    public void Playback(EntityManager mgr)
    {
        Record(null);
        m_recorded.IsPlayed = true;
        foreach (var command in m_recorded.Commands)
            command?.Invoke(mgr);
    }

    public void Dispose()
    {
        foreach (var buffer in m_recorded.Buffers)
        {
            UnsafeUtility.Free(((BufferStore*)buffer)->Elements, Allocator.Persistent);
            UnsafeUtility.Free((void*)buffer, Allocator.Persistent);
        }
        m_recorded.Buffers.Clear();
        m_recorded.IsPlayed = true;
    }

    Entity Promise(Func<EntityManager, Entity> make)
    {
        var recorded = m_recorded;
        Record(entities => recorded.Made.Add(make(entities)));
        return new Entity { Index = -++recorded.Promised };
    }

    void Record(Action<EntityManager> command)
    {
        if (m_recorded == null)
            throw new NullReferenceException("The EntityCommandBuffer has not been initialized!");
        if (m_recorded.IsPlayed)
            throw new InvalidOperationException("The EntityCommandBuffer has already been played back and no further commands " +
                "can be added.");
        m_recorded.Commands.Add(command);
    }

    static Entity Resolve(Recorded recorded, Entity entity) => entity.Index < 0 ? recorded.Made[-entity.Index - 1] : entity;
}
