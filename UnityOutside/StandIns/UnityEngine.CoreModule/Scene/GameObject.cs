namespace UnityEngine;

public sealed partial class GameObject : Object
{
    readonly List<Component> m_components = new List<Component>();
    readonly Transform m_transform;
    bool m_isActive = true;
    int m_layer;

    public GameObject(string name)
    {
        this.name = name;
        m_transform = new Transform { gameObject = this };
        m_components.Add(m_transform);
        SceneLoop.Objects.Add(this);
    }

    internal SceneManagement.Scene Scene = SceneManagement.SceneManager.s_active;

    public Transform transform => There(m_transform);

    /// <summary>That of its root.</summary>
    public SceneManagement.Scene scene => m_transform.Parent is null ? Scene : m_transform.Parent.gameObject.scene;

    public bool activeSelf => There(m_isActive);

    public bool activeInHierarchy =>
        activeSelf && (m_transform.Parent is null || m_transform.Parent.gameObject.activeInHierarchy);

    public int layer
    {
        get => There(m_layer);
        set
        {
            CheckIsThere();
            if (value < 0 || value > 31)
                Debug.LogError("A game object can only be in one layer. The layer needs to be in the range [0...31]");
            else
                m_layer = value;
        }
    }

    /// <summary>Of the scene that it is in.</summary>
    public ulong sceneCullingMask => There(SceneMask);

    internal ulong SceneMask { get; set; } = 7UL << 61;

    public void SetActive(bool value)
    {
        CheckIsThere();
        m_isActive = value;
        Refresh();
    }

    /// <summary>Of those that are active; a name alone, no path.</summary>
    public static GameObject Find(string name) => SceneLoop.Objects.Find(o => o.name == name && o.activeInHierarchy);

    /// <summary>Without its mesh.</summary>
    public static GameObject CreatePrimitive(PrimitiveType type) => new GameObject(type.ToString());

    /// <returns>Null if there may be one only, and is one.</returns>
    public T AddComponent<T>() where T : Component
    {
        CheckIsThere();
        if (typeof(T).IsDefined(typeof(DisallowMultipleComponent), false) && GetComponent<T>() != null)
        {
            Debug.LogError("Can't add component '" + typeof(T).Name + "' to " + name +
                " because such a component is already added to the game object!");
            return null;
        }
        foreach (var required in typeof(T).GetCustomAttributes<RequireComponent>())
            if (m_components.Find(required.m_Type0.IsInstanceOfType) == null)
                Add((Component)Activator.CreateInstance(required.m_Type0));
        return (T)Add(Activator.CreateInstance<T>());
    }

    public T GetComponent<T>()
    {
        CheckIsThere();
        return m_components.Find(c => c is T && !c.IsDestroyed) is T found ? found : default;
    }

    /// <summary>Its own, then those of its children.</summary>
    public T[] GetComponentsInChildren<T>(bool includeInactive) => includeInactive || activeInHierarchy
        ? Components.OfType<T>().Concat(Children.SelectMany(c => c.GetComponentsInChildren<T>(includeInactive))).ToArray()
        : new T[0];

    internal IEnumerable<Component> Components => m_components.Where(c => !c.IsDestroyed);

    internal void Refresh()
    {
        foreach (var behaviour in Components.OfType<Behaviour>().ToArray())
            SceneLoop.Refresh(behaviour);
        foreach (var child in Children)
            child.Refresh();
    }

    IEnumerable<GameObject> Children => m_transform.Children.Select(c => c.gameObject).ToArray();

    Component Add(Component component)
    {
        component.gameObject = this;
        m_components.Add(component);
        if (component is Behaviour behaviour)
        {
            SceneLoop.Refresh(behaviour);
            SceneLoop.Added(behaviour);
        }
        return component;
    }

    internal override void OnDestroyed()
    {
        foreach (var child in Children)
            DestroyImmediate(child);
        m_transform.Leave();
        foreach (var component in Components.Reverse().ToArray())
            DestroyImmediate(component);
        SceneLoop.Objects.Remove(this);
    }
}
