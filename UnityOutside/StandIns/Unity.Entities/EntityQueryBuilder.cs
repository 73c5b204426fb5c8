namespace Unity.Entities;

/// <summary>A query names a type twice.</summary>
public class EntityQueryDescValidationException(string message) : Exception(message) { }

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
        if (m_terms.HasOptions)
            throw new InvalidOperationException("EntityQueryBuilder.WithOptions should only be called once for each query.");
        (m_terms.HasOptions, m_terms.Options) = (true, options);
        return this;
    }

    public EntityQuery Build(EntityManager entityManager) => new EntityQuery(entityManager.Store, m_terms.Copy());
    public EntityQuery Build(SystemBase systemBase) => Build(systemBase.EntityManager).OfASystem();
}
