namespace Unity.Entities;

public sealed class World : IDisposable
{
    readonly List<ComponentSystemBase> m_systems = new List<ComponentSystemBase>();
    readonly EntityStore m_store = new EntityStore();
    readonly EntityManager m_entities;
    internal int Executing;

    public World(string name, WorldFlags flags = WorldFlags.Simulation)
    {
        Name = name;
        m_entities = new EntityManager(this, m_store);
    }

    /// <summary>Null until a host or a test sets it.</summary>
    public static World DefaultGameObjectInjectionWorld { get; set; }

    public string Name { get; }
    public EntityManager EntityManager => m_store.Alive != null ? m_entities : default;
    public bool IsCreated => !m_store.IsDisposed;

    public T GetExistingSystemManaged<T>() where T : ComponentSystemBase => (T)GetExistingSystemManaged(typeof(T));

    /// <summary>Without garbage: it is asked each frame.</summary>
    public ComponentSystemBase GetExistingSystemManaged(Type type)
    {
        if (m_store.Alive != null && !typeof(ComponentSystemBase).IsAssignableFrom(type))
            throw new ArgumentException("The passed-in Type " + type + " is not a type that derives from SystemBase or ISystem");
        foreach (var system in m_systems)
            if (system.GetType() == type)
                return system;
        return null;
    }

    public T GetOrCreateSystemManaged<T>() where T : ComponentSystemBase => (T)GetOrCreateSystemManaged(typeof(T));
    public ComponentSystemBase GetOrCreateSystemManaged(Type type) => GetExistingSystemManaged(type) ?? CreateSystemManaged(type);

    public ComponentSystemBase CreateSystemManaged(Type type)
    {
        if (!IsCreated)
            throw new ObjectDisposedException(Name);
        var system = (ComponentSystemBase)Activator.CreateInstance(type);
        m_systems.Add(system);
        try
        {
            system.Create(this);
        }
        catch
        {
            m_systems.Remove(system);
            throw;
        }
        return system;
    }

    /// <summary>Initialization, Simulation, Presentation, as the player loop would.</summary>
    public void Update()
    {
        GetExistingSystemManaged<InitializationSystemGroup>()?.Update();
        GetExistingSystemManaged<SimulationSystemGroup>()?.Update();
        GetExistingSystemManaged<PresentationSystemGroup>()?.Update();
    }

    public void Dispose()
    {
        if (!IsCreated)
            throw new ArgumentException("The World has already been Disposed.");
        if (Executing > 0)
            throw new ArgumentException("The World can not be disposed while a system in that world is executing");
        for (int i = m_systems.Count - 1; i >= 0; i--)
            Try(m_systems[i].Stop);
        for (int i = m_systems.Count - 1; i >= 0; i--)
            Try(m_systems[i].Destroy);
        m_systems.Clear();
        m_store.Dispose();
        if (DefaultGameObjectInjectionWorld == this)
            DefaultGameObjectInjectionWorld = null;
    }

    /// <summary>A system that throws keeps no other from its steps.</summary>
    internal static void Try(Action step)
    {
        try
        {
            step();
        }
        catch (Exception exception)
        {
            UnityEngine.Debug.LogException(exception);
        }
    }
}
