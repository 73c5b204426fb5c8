using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace Unity.Entities;

/// <summary>One that was freed is not recognised everywhere in Unity: here the heap does.</summary>
public unsafe struct BlobAssetReference<T> : IDisposable where T : unmanaged
{
    byte* m_data;

    public bool IsCreated => m_data != null;
    public void* GetUnsafePtr() => m_data;

    public ref T Value
    {
        get
        {
            CheckNotNull();
            return ref *(T*)m_data;
        }
    }

    public static BlobAssetReference<T> Create(void* ptr, int length)
    {
        var created = new BlobAssetReference<T> { m_data = (byte*)UnsafeUtility.Malloc(length, 16, Allocator.Persistent) };
        UnsafeUtility.MemCpy(created.m_data, ptr, length);
        return created;
    }

    public void Dispose()
    {
        CheckNotNull();
        UnsafeUtility.Free(m_data, Allocator.Persistent);
        m_data = null;
    }

    readonly void CheckNotNull()
    {
        if (m_data == null)
            throw new InvalidOperationException("The BlobAssetReference is null.");
    }
}
