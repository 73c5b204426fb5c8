using StandIns.Entities;
using Unity.Collections;

namespace Unity.Entities;

public ref struct EntityQueryBuilder
{
    readonly QueryTerms m_terms;

    public EntityQueryBuilder(AllocatorManager.AllocatorHandle allocator) => m_terms = new QueryTerms();

    public EntityQueryBuilder WithAll<T>()
    {
        m_terms.All.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithNone<T>()
    {
        m_terms.None.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithAny<T>()
    {
        m_terms.Any.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithDisabled<T>()
    {
        m_terms.Disabled.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithPresent<T>()
    {
        m_terms.Present.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithAbsent<T>()
    {
        m_terms.Absent.Add(TypeRegistry.Of<T>.Index.Value);
        return this;
    }

    public EntityQueryBuilder WithOptions(EntityQueryOptions options)
    {
        m_terms.Options |= options;
        return this;
    }

    public EntityQuery Build(EntityManager entityManager) => new EntityQuery(entityManager.Store, m_terms);
    public EntityQuery Build(SystemBase systemBase) => Build(systemBase.EntityManager);
}
