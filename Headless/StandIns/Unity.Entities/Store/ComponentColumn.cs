using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace StandIns.Entities;

/// <summary>One component of all entities of an archetype, row by row.</summary>
sealed unsafe class ComponentColumn(int typeIndex) : IDisposable
{
    object[] m_objects;
    byte* m_bytes;
    byte* m_enabled;

    public int TypeIndex { get; } = typeIndex;
    public ComponentInfo Info { get; } = TypeRegistry.InfoOf(typeIndex);

    public void* At(int row) => m_bytes + (long)row * Info.SizeBytes;
    public object ObjectAt(int row) => m_objects[row];
    public void SetObject(int row, object value) => m_objects[row] = value;

    /// <summary>As Unity does with managed components that can be disposed, when they are removed.</summary>
    public void DisposeObject(int row)
    {
        if (Info.IsManaged && m_objects[row] is IDisposable owned)
            owned.Dispose();
    }

    public bool IsEnabled(int row) => !Info.IsEnableable || m_enabled[row] != 0;
    public void SetEnabled(int row, bool value) => m_enabled[row] = value ? (byte)1 : (byte)0;

    public void Grow(int count, int capacity)
    {
        if (Info.IsManaged)
            Array.Resize(ref m_objects, capacity);
        m_bytes = Grow(m_bytes, (long)count * Info.SizeBytes, (long)capacity * Info.SizeBytes);
        m_enabled = Grow(m_enabled, Info.IsEnableable ? count : 0, Info.IsEnableable ? capacity : 0);
    }

    /// <summary>As a component is when it is added: zeros, and enabled.</summary>
    public void Reset(int row)
    {
        if (Info.IsManaged)
            m_objects[row] = null;
        UnsafeUtility.MemClear(At(row), Info.SizeBytes);
        if (Info.IsEnableable)
            m_enabled[row] = 1;
    }

    public void Copy(int row, ComponentColumn to, int toRow)
    {
        if (Info.IsManaged)
            to.m_objects[toRow] = m_objects[row];
        UnsafeUtility.MemCpy(to.At(toRow), At(row), Info.SizeBytes);
        if (Info.IsEnableable)
            to.m_enabled[toRow] = m_enabled[row];
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
