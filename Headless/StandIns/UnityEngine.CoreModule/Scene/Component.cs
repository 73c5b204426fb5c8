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
}
