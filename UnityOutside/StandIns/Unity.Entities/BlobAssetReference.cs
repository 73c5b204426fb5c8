
namespace Unity.Entities;

public unsafe struct BlobAssetReference<T> : IDisposable where T : unmanaged
{
    void* m_data;

    public bool IsCreated => m_data != null;
    public void* GetUnsafePtr() => m_data;

    public static BlobAssetReference<T> Create(void* ptr, int length)
    {
        var created = new BlobAssetReference<T> { m_data = UnsafeUtility.MallocTracked(length, 16, Allocator.Persistent, 0) };
        UnsafeUtility.MemCpy(created.m_data, ptr, length);
        return created;
    }

    public void Dispose()
    {
        if (m_data == null)
            throw new InvalidOperationException("The BlobAssetReference is null.");
        UnsafeUtility.FreeTracked(m_data, Allocator.Persistent);
        m_data = null;
    }
}
