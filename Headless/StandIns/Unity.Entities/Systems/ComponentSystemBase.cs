namespace Unity.Entities;

public abstract class ComponentSystemBase
{
    bool m_wasRunning;

    public bool Enabled { get; set; } = true;
    public World World { get; private set; }
    public EntityManager EntityManager => World.EntityManager;

    public abstract void Update();
    protected virtual void OnCreate() { }
    protected virtual void OnStartRunning() { }
    protected virtual void OnStopRunning() { }
    protected virtual void OnDestroy() { }
    public EntityQuery GetEntityQuery(params ComponentType[] componentTypes) => EntityManager.CreateEntityQuery(componentTypes);

    internal void Create(World world)
    {
        World = world;
        OnCreate();
    }

    internal void Destroy()
    {
        OnDestroy();
        World = null;
    }

    /// <summary>Whether it runs in this update: tells the system where that has changed.</summary>
    internal bool Begin()
    {
        if (!Enabled)
        {
            Stop();
            return false;
        }
        if (!m_wasRunning)
            OnStartRunning();
        m_wasRunning = true;
        return true;
    }

    internal void Stop()
    {
        if (m_wasRunning)
            OnStopRunning();
        m_wasRunning = false;
    }
}
