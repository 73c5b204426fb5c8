using System;
using System.Collections.Generic;

namespace UnityEngine.Rendering;

public abstract class ContextItem
{
    public abstract void Reset();
}

public class ContextContainer : IDisposable
{
    readonly Dictionary<Type, ContextItem> m_items = new Dictionary<Type, ContextItem>();

    public T Get<T>() where T : ContextItem, new() => m_items.TryGetValue(typeof(T), out var item) ? (T)item
        : throw new InvalidOperationException("Type " + typeof(T).FullName + " has not been created yet.");

    public T GetOrCreate<T>() where T : ContextItem, new()
    {
        if (!m_items.ContainsKey(typeof(T)))
            m_items.Add(typeof(T), new T());
        return Get<T>();
    }

    public void Dispose() => m_items.Clear();
}
