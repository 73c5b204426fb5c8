namespace Unity.Entities;

/// <summary>Invalid after the next structural change of its world; that of a command buffer is not.</summary>
public unsafe struct DynamicBuffer<T> where T : unmanaged
{
    readonly BufferStore* m_buffer;
    readonly EntityStore m_store;
    readonly int m_structuralVersion;
    readonly bool m_isReadOnly;

    internal DynamicBuffer(BufferStore* buffer, EntityStore store, bool isReadOnly)
    {
        m_buffer = buffer;
        m_store = store;
        m_isReadOnly = isReadOnly;
        m_structuralVersion = store == null ? 0 : store.StructuralVersion;
    }

    public int Length => Checked()->Length;

    public T this[int index]
    {
        get => UnsafeUtility.ReadArrayElement<T>(Checked()->Elements, Within(index));
        set => UnsafeUtility.WriteArrayElement(Writable()->Elements, Within(index), value);
    }

    public void ResizeUninitialized(int length) => Writable()->Resize(length, sizeof(T));

    public int Add(T elem)
    {
        ResizeUninitialized(Length + 1);
        this[Length - 1] = elem;
        return Length - 1;
    }

    public void* GetUnsafePtr() => Writable()->Elements;
    public void* GetUnsafeReadOnlyPtr() => Checked()->Elements;

    BufferStore* Checked()
    {
        if (m_store != null && (m_store.IsDisposed || m_store.StructuralVersion != m_structuralVersion))
            throw new ObjectDisposedException("DynamicBuffer", "Attempted to access a buffer that has been invalidated by a " +
                "structural change.");
        return m_buffer;
    }

    BufferStore* Writable()
    {
        if (m_isReadOnly)
            throw new InvalidOperationException("The buffer has been declared as [ReadOnly], but you are writing to it.");
        return Checked();
    }

    int Within(int index) => (uint)index < (uint)Length ? index
        : throw new IndexOutOfRangeException($"Index {index} is out of range in DynamicBuffer of '{Length}' Length.");
}
