namespace StandIns.Entities;

sealed unsafe class ComponentColumn(int typeIndex) : IDisposable
{
    byte* m_bytes;
    byte* m_enabled;

    public int TypeIndex { get; } = typeIndex;
    public ComponentInfo Info { get; } = TypeRegistry.InfoOf(typeIndex);

    public void* At(int row) => m_bytes + (long)row * Info.SizeBytes;

    public bool IsEnabled(int row) => !Info.IsEnableable || m_enabled[row] != 0;
    public void SetEnabled(int row, bool value) => m_enabled[row] = value ? (byte)1 : (byte)0;

    public void Grow(int count, int capacity)
    {
        m_bytes = Grow(m_bytes, (long)count * Info.SizeBytes, (long)capacity * Info.SizeBytes);
        m_enabled = Grow(m_enabled, Info.IsEnableable ? count : 0, Info.IsEnableable ? capacity : 0);
    }

    public void Reset(int row)
    {
        UnsafeUtility.MemClear(At(row), Info.SizeBytes);
        if (Info.IsEnableable)
            m_enabled[row] = 1;
    }

    public void Move(int row, ComponentColumn to, int toRow)
    {
        UnsafeUtility.MemCpy(to.At(toRow), At(row), Info.SizeBytes);
        if (Info.IsEnableable)
            to.m_enabled[toRow] = m_enabled[row];
    }

    public void Copy(int row, ComponentColumn to, int toRow)
    {
        Move(row, to, toRow);
        if (!Info.IsBuffer)
            return;
        var copied = (BufferStore*)At(row);
        var copy = (BufferStore*)to.At(toRow);
        *copy = default;
        copy->Resize(copied->Length, Info.ElementBytes);
        UnsafeUtility.MemCpy(copy->Elements, copied->Elements, (long)copied->Length * Info.ElementBytes);
    }

    public void Free(int row)
    {
        if (Info.IsBuffer)
            UnsafeUtility.Free(((BufferStore*)At(row))->Elements, Allocator.Persistent);
    }

    public void Dispose()
    {
        UnsafeUtility.Free(m_bytes, Allocator.Persistent);
        UnsafeUtility.Free(m_enabled, Allocator.Persistent);
        m_bytes = null;
        m_enabled = null;
    }

    static byte* Grow(byte* bytes, long used, long size)
    {
        if (size == 0)
            return null;
        byte* grown = (byte*)UnsafeUtility.Malloc(size, 16, Allocator.Persistent);
        if (used > 0)
            UnsafeUtility.MemCpy(grown, bytes, used);
        UnsafeUtility.Free(bytes, Allocator.Persistent);
        return grown;
    }
}

unsafe struct BufferStore
{
    public byte* Elements;
    public int Length;
    int m_capacity;

    public void Resize(int length, int elementBytes)
    {
        if (length > m_capacity)
        {
            m_capacity = Math.Max(length, 2 * m_capacity);
            byte* grown = (byte*)UnsafeUtility.Malloc((long)m_capacity * elementBytes, 16, Allocator.Persistent);
            UnsafeUtility.MemCpy(grown, Elements, (long)Length * elementBytes);
            UnsafeUtility.Free(Elements, Allocator.Persistent);
            Elements = grown;
        }
        Length = length;
    }
}
