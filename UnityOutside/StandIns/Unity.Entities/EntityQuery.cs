namespace Unity.Entities;

public unsafe struct EntityQuery : IDisposable, IEquatable<EntityQuery>
{
    readonly EntityStore m_store;
    readonly QueryTerms m_terms;

    internal EntityQuery(EntityStore store, QueryTerms terms)
    {
        terms.Check();
        (m_store, m_terms) = (store, terms);
    }

    internal EntityQuery Of(EntityStore store) =>
        Alive == store ? this : throw new ArgumentException("query is invalid or disposed");

    internal EntityQuery OfASystem()
    {
        m_terms.IsOfASystem = true;
        return this;
    }

    public bool IsEmpty => CalculateEntityCount() == 0;

    public int CalculateEntityCount()
    {
        int count = 0;
        for (int a = 0; a < Alive.ArchetypeCount; a++)
        {
            var archetype = m_store.ArchetypeAt(a);
            if (!m_terms.MayMatch(archetype))
                continue;
            for (int row = 0; row < archetype.Count; row++)
                count += m_terms.Matches(archetype, row) ? 1 : 0;
        }
        return count;
    }

    public NativeArray<Entity> ToEntityArray(AllocatorManager.AllocatorHandle allocator)
    {
        var entities = new NativeArray<Entity>(CalculateEntityCount(), allocator.ToAllocator);
        int next = 0;
        for (int a = 0; a < m_store.ArchetypeCount; a++)
        {
            var archetype = m_store.ArchetypeAt(a);
            if (!m_terms.MayMatch(archetype))
                continue;
            for (int row = 0; row < archetype.Count; row++)
                if (m_terms.Matches(archetype, row))
                    entities[next++] = archetype.EntityAt(row);
        }
        return entities;
    }

    public NativeArray<T> ToComponentDataArray<T>(AllocatorManager.AllocatorHandle allocator) where T : unmanaged, IComponentData
    {
        if (!m_terms.Declares(TypeRegistry.Of<T>.Index.Value))
            throw new InvalidOperationException("Trying to get iterator for " + typeof(T) +
                " but the required component type was not declared in the EntityQuery.");
        var values = new NativeArray<T>(CalculateEntityCount(), allocator.ToAllocator);
        int next = 0, type = TypeRegistry.Of<T>.Index.Value;
        for (int a = 0; a < m_store.ArchetypeCount; a++)
        {
            var archetype = m_store.ArchetypeAt(a);
            if (!m_terms.MayMatch(archetype))
                continue;
            for (int row = 0; row < archetype.Count; row++)
                if (m_terms.Matches(archetype, row))
                    values[next++] = UnsafeUtility.ReadArrayElement<T>(archetype.Find(type).At(row), 0);
        }
        return values;
    }

    public void Dispose()
    {
        if (Alive != null && m_terms.IsOfASystem)
            throw new InvalidOperationException("EntityQuery cannot be disposed: GetEntityQuery()'s are owned by systems.");
        m_terms.IsDisposed = true;
    }

    public bool Equals(EntityQuery other) => m_terms == other.m_terms;
    public override bool Equals(object compare) => compare is EntityQuery other && Equals(other);
    public override int GetHashCode() => m_terms == null ? 0 : m_terms.GetHashCode();

    EntityStore Alive => !m_terms.IsDisposed ? m_store.Alive
        : throw new ObjectDisposedException("EntityQuery", "The query has been disposed.");
}
