namespace StandIns.Collections;

/// <summary>Keys and values in arrays, chained by index from buckets. The struct itself is allocated, so that copies of a map
/// share it.</summary>
unsafe struct HashTable<TKey, TValue> where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
{
    TKey* m_keys;
    int* m_next;
    int* m_buckets;
    int m_bucketMask;
    int m_count;
    int m_capacity;
    AllocatorManager.AllocatorHandle m_allocator;

    internal TValue* Values;

    internal static HashTable<TKey, TValue>* Create(int capacity, AllocatorManager.AllocatorHandle allocator)
    {
        CheckBytes(capacity);
        HashTable<TKey, TValue>* table = AllocatorManager.Allocate<HashTable<TKey, TValue>>(allocator);
        *table = new HashTable<TKey, TValue> { m_allocator = allocator };
        table->Allocate(Math.Max(capacity, 1));
        return table;
    }

    internal static void Destroy(HashTable<TKey, TValue>* table)
    {
        AllocatorManager.AllocatorHandle allocator = table->m_allocator;
        table->FreeArrays();
        AllocatorManager.Free(allocator, table);
    }

    /// <returns>The key's slot, or -1.</returns>
    internal readonly int Find(TKey key)
    {
        int slot = m_buckets[Bucket(key)];
        while (slot >= 0 && !m_keys[slot].Equals(key))
            slot = m_next[slot];
        return slot;
    }

    internal bool TryAdd(TKey key, TValue value)
    {
        if (Find(key) >= 0)
            return false;
        if (m_count == m_capacity)
            Grow();
        Append(key, value);
        return true;
    }

    void Append(TKey key, TValue value)
    {
        int slot = m_count++;
        m_keys[slot] = key;
        Values[slot] = value;
        int bucket = Bucket(key);
        m_next[slot] = m_buckets[bucket];
        m_buckets[bucket] = slot;
    }

    readonly int Bucket(TKey key)
    {
        // Weak hash codes (a number is its own) are spread over the high bits too.
        uint hash = (uint)key.GetHashCode();
        return (int)((hash * 0x9E3779B1u >> 15 ^ hash) & (uint)m_bucketMask);
    }

    void Grow()
    {
        HashTable<TKey, TValue> old = this;
        CheckBytes(2L * old.m_capacity);
        Allocate(2 * old.m_capacity);
        for (int slot = 0; slot < old.m_count; slot++)
            Append(old.m_keys[slot], old.Values[slot]);
        old.FreeArrays();
    }

    void Allocate(int capacity)
    {
        int buckets = (int)BucketsFor(capacity);
        m_keys = AllocatorManager.Allocate<TKey>(m_allocator, capacity);
        Values = AllocatorManager.Allocate<TValue>(m_allocator, capacity);
        m_next = AllocatorManager.Allocate<int>(m_allocator, capacity);
        m_buckets = AllocatorManager.Allocate<int>(m_allocator, buckets);
        m_bucketMask = buckets - 1;
        m_capacity = capacity;
        m_count = 0;
        UnsafeUtility.MemSet(m_buckets, 0xFF, (long)buckets * sizeof(int));
    }

    void FreeArrays()
    {
        AllocatorManager.Free(m_allocator, m_keys);
        AllocatorManager.Free(m_allocator, Values);
        AllocatorManager.Free(m_allocator, m_next);
        AllocatorManager.Free(m_allocator, m_buckets);
    }

    static long BucketsFor(long capacity) => RoundedUp.ToPowerOfTwo(2 * capacity);

    // Unity's first release for 6000.0 adds the bytes of all arrays up in an int.
    static void CheckBytes(long capacity)
    {
        if (capacity < 0 || capacity * (sizeof(TKey) + sizeof(TValue) + sizeof(int)) + BucketsFor(capacity) * sizeof(int)
            > int.MaxValue)
            throw new ArgumentOutOfRangeException(nameof(capacity), capacity, "A map takes at most 2^31 - 1 bytes.");
    }
}
