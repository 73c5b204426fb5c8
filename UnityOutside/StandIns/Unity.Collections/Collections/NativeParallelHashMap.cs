namespace Unity.Collections;

[NativeContainer]
public unsafe struct NativeParallelHashMap<TKey, TValue> : IDisposable
    where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
{
    [NativeDisableUnsafePtrRestriction] internal HashTable<TKey, TValue>* m_Table;
    internal AtomicSafetyHandle m_Safety;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeParallelHashMap<TKey, TValue>>();
#endif

    public NativeParallelHashMap(int capacity, AllocatorManager.AllocatorHandle allocator)
    {
        m_Table = HashTable<TKey, TValue>.Create(capacity, allocator);
        m_Safety = ContainerChecks.CreateSafetyHandle(allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
#endif
    }

    public readonly bool IsCreated => m_Table != null;

    /// <summary>Where checks are off, Unity gives the default of a key that is missing; here every build throws.</summary>
    public TValue this[TKey key] =>
        TryGetValue(key, out TValue item) ? item : throw new ArgumentException($"Key: {key} is not present.");

    public bool TryAdd(TKey key, TValue item)
    {
        AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
        return m_Table->TryAdd(key, item);
    }

    public bool TryGetValue(TKey key, out TValue item)
    {
        AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
        int slot = m_Table->Find(key);
        item = slot < 0 ? default : m_Table->Values[slot];
        return slot >= 0;
    }

    public bool ContainsKey(TKey key)
    {
        AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
        return m_Table->Find(key) >= 0;
    }

    public void Dispose()
    {
        if (!ContainerChecks.TryRelease(m_Safety, IsCreated))
            return;
        HashTable<TKey, TValue>.Destroy(m_Table);
        m_Table = null;
    }
}
