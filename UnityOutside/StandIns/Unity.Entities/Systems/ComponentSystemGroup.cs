namespace Unity.Entities;

public abstract class ComponentSystemGroup : SystemBase
{
    readonly List<ComponentSystemBase> m_systems = new List<ComponentSystemBase>();
    bool m_isSorted = true;

    public virtual IReadOnlyList<ComponentSystemBase> ManagedSystems => m_systems;

    public void AddSystemToUpdateList(ComponentSystemBase sys)
    {
        if (sys == this)
            throw new ArgumentException("Can't add " + GetType().Name + " to its own update list");
        if (m_systems.Contains(sys))
            return;
        m_systems.Add(sys);
        m_isSorted = false;
    }

    public void RemoveSystemFromUpdateList(ComponentSystemBase sys) => m_systems.Remove(sys);

    public void SortSystems()
    {
        SystemOrder.Sort(m_systems, GetType());
        m_isSorted = true;
    }

    protected override void OnUpdate()
    {
        if (!m_isSorted)
            SortSystems();
        // As in Unity: one that throws keeps none from running.
        for (int i = 0; i < m_systems.Count; i++)
            try
            {
                m_systems[i].Update();
            }
            catch (Exception exception)
            {
                UnityEngine.Debug.LogException(exception);
            }
    }
}
