namespace StandIns.Io;

/// <summary>Objects behind the unmanaged handles that Unity gives out: an index and a version. Index 0 is nothing.</summary>
sealed class HandleTable<T> where T : class
{
    readonly object m_lock = new object();
    readonly List<T> m_items = new List<T> { null };
    readonly List<int> m_versions = new List<int> { 0 };
    readonly Stack<int> m_free = new Stack<int>();

    internal (int Index, int Version) Add(T item)
    {
        lock (m_lock)
        {
            if (m_free.Count == 0)
            {
                m_items.Add(null);
                m_versions.Add(1);
                m_free.Push(m_items.Count - 1);
            }
            int index = m_free.Pop();
            m_items[index] = item;
            return (index, m_versions[index]);
        }
    }

    /// <returns>Null for a handle that is stale or default.</returns>
    internal T Find(int index, int version)
    {
        lock (m_lock)
            return index > 0 && index < m_items.Count && m_versions[index] == version ? m_items[index] : null;
    }

    internal void Prepare(int count)
    {
        var made = new (int Index, int Version)[count];
        for (int i = 0; i < count; i++)
            made[i] = Add(null);
        foreach ((int index, int version) in made)
            Remove(index, version);
    }

    internal T Remove(int index, int version)
    {
        lock (m_lock)
        {
            if (index <= 0 || index >= m_items.Count || m_versions[index] != version)
                return null;
            T item = m_items[index];
            m_items[index] = null;
            m_versions[index]++;
            m_free.Push(index);
            return item;
        }
    }
}
