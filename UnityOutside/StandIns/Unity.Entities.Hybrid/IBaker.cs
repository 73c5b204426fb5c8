namespace Unity.Entities;

public abstract class IBaker
{
    readonly HashSet<Type> m_added = new HashSet<Type>();

    internal EntityManager Entities;
    internal Entity Primary;
    internal UnityEngine.Component Authoring;

    /// <summary>Objects of which a change has everything baked again.</summary>
    internal readonly HashSet<UnityEngine.Object> Dependencies = new HashSet<UnityEngine.Object>();

    internal bool IsForPlayer;

    public bool IsBakingForEditor() => !IsForPlayer;

    public Entity GetEntity(TransformUsageFlags flags) => Primary;

    /// <returns>The object itself; null as it came.</returns>
    public T DependsOn<T>(T dependency) where T : UnityEngine.Object
    {
        if (dependency is object)
            Dependencies.Add(dependency);
        return dependency;
    }

    /// <summary>A change of it has everything baked again.</summary>
    public int GetLayer() => DependsOn(Authoring.gameObject).layer;

    /// <summary>Inactive ones, too.</summary>
    public T GetComponentInParent<T>() where T : UnityEngine.Component
    {
        for (var at = Authoring.transform; at is not null; at = at.Parent)
            if (at.GetComponent<T>() is { } found)
                return DependsOn(found);
        return null;
    }

    /// <summary>Inactive ones, too.</summary>
    public T[] GetComponentsInChildren<T>(UnityEngine.Component component) where T : UnityEngine.Component
    {
        var found = component.GetComponentsInChildren<T>(true);
        Dependencies.UnionWith(found);
        return found;
    }

    public void AddComponent<T>(Entity entity, in T component) where T : unmanaged, IComponentData
    {
        Track<T>(entity);
        Entities.AddComponentData(entity, component);
    }

    public DynamicBuffer<T> AddBuffer<T>(Entity entity) where T : unmanaged, IBufferElementData
    {
        Track<T>(entity);
        return Entities.AddBuffer<T>(entity);
    }

    void Track<T>(Entity entity)
    {
        if (entity != Primary)
            throw new InvalidOperationException("Entity " + entity + " doesn't belong to the current authoring component.");
        if (!m_added.Add(typeof(T)))
            throw new InvalidOperationException("Baking error: Attempt to add duplicate component " + typeof(T).Name);
    }
}
