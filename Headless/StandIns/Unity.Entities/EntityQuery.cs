using StandIns.Entities;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Entities;

public unsafe struct EntityQuery : IDisposable, IEquatable<EntityQuery>
{
    EntityStore m_store;
    QueryTerms m_terms;

    internal EntityQuery(EntityStore store, QueryTerms terms) => (m_store, m_terms) = (store, terms);

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

    /// <summary>A system's query belongs to the system and is not disposed by hand.</summary>
    public void Dispose() => m_terms = null;

    public bool Equals(EntityQuery other) => m_terms == other.m_terms;
    public override bool Equals(object compare) => compare is EntityQuery other && Equals(other);
    public override int GetHashCode() => m_terms == null ? 0 : m_terms.GetHashCode();

    EntityStore Alive => m_terms != null && !m_store.IsDisposed ? m_store
        : throw new ObjectDisposedException("EntityQuery", "The query was not created, or it or its world has been disposed.");
}
