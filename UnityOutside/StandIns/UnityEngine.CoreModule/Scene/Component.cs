namespace UnityEngine;

public class Component : Object
{
    GameObject m_gameObject;

    public GameObject gameObject
    {
        get
        {
            CheckIsThere();
            return m_gameObject;
        }
        internal set => m_gameObject = value;
    }

    public Transform transform => gameObject.transform;

    public bool TryGetComponent<T>(out T component)
    {
        component = GetComponent<T>();
        return component != null;
    }

    public T GetComponent<T>() => gameObject.GetComponent<T>();

    /// <summary>Its own, then those of its parents; of objects that are not active none.</summary>
    public T GetComponentInParent<T>()
    {
        for (var at = transform; at is not null; at = at.Parent)
            if (at.gameObject.activeInHierarchy && at.GetComponent<T>() is { } found)
                return found;
        return default;
    }

    public void GetComponentsInChildren<T>(bool includeInactive, List<T> result)
    {
        result.Clear();
        result.AddRange(GetComponentsInChildren<T>(includeInactive));
    }

    public T[] GetComponentsInChildren<T>(bool includeInactive) => gameObject.GetComponentsInChildren<T>(includeInactive);
}
