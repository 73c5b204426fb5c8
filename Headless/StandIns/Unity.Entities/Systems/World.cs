using StandIns.Entities;

namespace Unity.Entities;

public sealed class World : IDisposable
{
    readonly List<ComponentSystemBase> m_systems = new List<ComponentSystemBase>();
    readonly EntityStore m_store = new EntityStore();

    public World(string name, WorldFlags flags = WorldFlags.Simulation)
    {
        Name = name;
        EntityManager = new EntityManager(this, m_store);
    }

    /// <summary>Null until a host or a test sets it.</summary>
    public static World DefaultGameObjectInjectionWorld { get; set; }

    public string Name { get; }
    public EntityManager EntityManager { get; }
    public bool IsCreated => !m_store.IsDisposed;

    public T GetExistingSystemManaged<T>() where T : ComponentSystemBase => (T)GetExistingSystemManaged(typeof(T));

    /// <summary>Without garbage: it is asked each frame.</summary>
    public ComponentSystemBase GetExistingSystemManaged(Type type)
    {
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
        system.Create(this);
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
        for (int i = m_systems.Count - 1; i >= 0; i--)
            Try(m_systems[i].Stop);
        for (int i = m_systems.Count - 1; i >= 0; i--)
            Try(m_systems[i].Destroy);
        m_systems.Clear();
        m_store.Dispose();
        if (DefaultGameObjectInjectionWorld == this)
            DefaultGameObjectInjectionWorld = null;
    }

    /// <summary>A system that throws keeps no other from ending.</summary>
    static void Try(Action step)
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
