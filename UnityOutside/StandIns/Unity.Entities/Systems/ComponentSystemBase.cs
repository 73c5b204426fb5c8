namespace Unity.Entities;

public abstract class ComponentSystemBase
{
    bool m_wasRunning;

    bool m_isEnabled = true;

    public bool Enabled
    {
        get => Made != null && m_isEnabled;
        set => m_isEnabled = Made != null && value;
    }

    public World World { get; private set; }
    public EntityManager EntityManager => Made.EntityManager;

    internal World Made =>
        World ?? throw new InvalidOperationException("system state is not initialized or has already been destroyed");

    public abstract void Update();
    protected virtual void OnCreate() { }
    protected virtual void OnStartRunning() { }
    protected virtual void OnStopRunning() { }
    protected virtual void OnDestroy() { }

    public EntityQuery GetEntityQuery(params ComponentType[] componentTypes) =>
        EntityManager.CreateEntityQuery(componentTypes).OfASystem();

    internal void Create(World world)
    {
        World = world;
        OnCreate();
    }

    internal void Destroy()
    {
        try
        {
            OnDestroy();
        }
        finally
        {
            World = null;
        }
    }

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
