namespace StandIns.Entities;

/// <summary>All entities with the same components, without gaps. Unity cuts them into chunks of 16 KiB; nothing here looks at
/// these.</summary>
sealed class Archetype : IDisposable
{
    readonly ComponentColumn[] m_columns;
    Entity[] m_entities = new Entity[0];

    /// <param name="types">Rising.</param>
    public Archetype(int[] types)
    {
        Types = types;
        m_columns = new ComponentColumn[types.Length];
        for (int i = 0; i < types.Length; i++)
        {
            m_columns[i] = new ComponentColumn(types[i]);
            HasCleanup |= m_columns[i].Info.IsCleanup;
        }
    }

    public int[] Types { get; }
    public bool HasCleanup { get; }
    public int Count { get; private set; }
    public IReadOnlyList<ComponentColumn> Columns => m_columns;

    public Entity EntityAt(int row) => m_entities[row];

    public ComponentColumn Find(int type)
    {
        for (int i = 0; i < m_columns.Length; i++)
            if (m_columns[i].TypeIndex == type)
                return m_columns[i];
        return null;
    }

    public int Add(Entity entity)
    {
        if (Count == m_entities.Length)
        {
            int capacity = Math.Max(16, Count * 2);
            Array.Resize(ref m_entities, capacity);
            foreach (var column in m_columns)
                column.Grow(Count, capacity);
        }
        m_entities[Count] = entity;
        foreach (var column in m_columns)
            column.Reset(Count);
        return Count++;
    }

    public Entity Remove(int row)
    {
        int last = --Count;
        var moved = row == last ? Entity.Null : m_entities[last];
        m_entities[row] = m_entities[last];
        foreach (var column in m_columns)
        {
            if (row != last)
                column.Move(last, column, row);
            column.Reset(last);
        }
        return moved;
    }

    public void Dispose()
    {
        foreach (var column in m_columns)
        {
            for (int row = 0; row < Count; row++)
                column.Free(row);
            column.Dispose();
        }
    }
}
