using System;
using System.Threading;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace StandIns.Collections
{
    /// <summary>
    /// Keys and values in arrays, chained by index from buckets; what hash maps and sets are made of. Values may be of no size
    /// (a set's). The struct itself is allocated, so that copies of a container share it.
    /// </summary>
    unsafe struct HashTable<TKey, TValue> where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
    {
        internal TKey* Keys;
        internal TValue* Values;
        int* m_next;
        int* m_buckets;
        int m_bucketMask;
        // Slots ever handed out; those given back are chained from m_firstFree.
        int m_used;
        int m_firstFree;
        int m_freeCount;
        AllocatorManager.AllocatorHandle m_allocator;

        internal int Capacity { get; private set; }

        /// <summary>Parallel writers take a slot before they know whether the key is new; theirs count as free again.</summary>
        internal readonly int Count => Math.Min(m_used, Capacity) - m_freeCount;

        internal readonly int Used => Math.Min(m_used, Capacity);

        internal static HashTable<TKey, TValue>* Create(int capacity, AllocatorManager.AllocatorHandle allocator)
        {
            HashTable<TKey, TValue>* table = AllocatorManager.Allocate<HashTable<TKey, TValue>>(allocator);
            *table = new HashTable<TKey, TValue> { m_allocator = allocator, m_firstFree = -1 };
            table->Rebuild(Math.Max(capacity, 1));
            return table;
        }

        internal static void Destroy(HashTable<TKey, TValue>* table)
        {
            AllocatorManager.AllocatorHandle allocator = table->m_allocator;
            table->FreeArrays();
            AllocatorManager.Free(allocator, table);
        }

        internal void Clear()
        {
            new Span<int>(m_buckets, m_bucketMask + 1).Fill(-1);
            m_used = 0;
            m_firstFree = -1;
            m_freeCount = 0;
        }

        internal readonly int Find(TKey key)
        {
            int slot = Volatile.Read(ref m_buckets[Bucket(key)]);
            while (slot >= 0 && !Keys[slot].Equals(key))
                slot = m_next[slot];
            return slot;
        }

        /// <returns>The new slot, or -1 if the key is there already.</returns>
        internal int TryAdd(TKey key)
        {
            if (Find(key) >= 0)
                return -1;
            if (m_firstFree < 0 && m_used >= Capacity)
                Rebuild(Capacity * 2);
            int slot;
            if (m_firstFree >= 0)
            {
                slot = m_firstFree;
                m_firstFree = m_next[slot];
                m_freeCount--;
            }
            else
            {
                slot = m_used++;
            }
            Keys[slot] = key;
            int bucket = Bucket(key);
            m_next[slot] = m_buckets[bucket];
            m_buckets[bucket] = slot;
            return slot;
        }

        /// <summary>As TryAdd, from several threads at once, up to the capacity.</summary>
        internal bool TryAddParallel(TKey key, TValue value)
        {
            int bucket = Bucket(key);
            int head = Volatile.Read(ref m_buckets[bucket]);
            if (FindBetween(head, -1, key))
                return false;
            int slot = Interlocked.Increment(ref m_used) - 1;
            if (slot >= Capacity)
            {
                Interlocked.Decrement(ref m_used);
                throw new InvalidOperationException("HashMap is full");
            }
            Keys[slot] = key;
            Values[slot] = value;
            while (true)
            {
                m_next[slot] = head;
                int seen = Interlocked.CompareExchange(ref m_buckets[bucket], slot, head);
                if (seen == head)
                    return true;
                // Only what others put before the old head is new.
                if (FindBetween(seen, head, key))
                {
                    GiveBack(slot);
                    return false;
                }
                head = seen;
            }
        }

        internal bool Remove(TKey key)
        {
            int* link = &m_buckets[Bucket(key)];
            while (*link >= 0)
            {
                int slot = *link;
                if (Keys[slot].Equals(key))
                {
                    *link = m_next[slot];
                    m_next[slot] = m_firstFree;
                    m_firstFree = slot;
                    m_freeCount++;
                    return true;
                }
                link = &m_next[slot];
            }
            return false;
        }

        /// <summary>Walks all elements: start with bucket -1 and slot -1.</summary>
        internal readonly bool MoveNext(ref int bucket, ref int slot)
        {
            if (slot >= 0)
                slot = m_next[slot];
            while (slot < 0)
            {
                if (++bucket > m_bucketMask)
                    return false;
                slot = m_buckets[bucket];
            }
            return true;
        }

        internal void SetCapacity(int capacity)
        {
            if (capacity > Capacity)
                Rebuild(capacity);
        }

        internal void TrimExcess() => Rebuild(Math.Max(Count, 1));

        readonly int Bucket(TKey key)
        {
            // Weak hash codes (a number is its own) are spread over the high bits too.
            uint hash = (uint)key.GetHashCode();
            return (int)((hash * 0x9E3779B1u >> 15 ^ hash) & (uint)m_bucketMask);
        }

        readonly bool FindBetween(int from, int end, TKey key)
        {
            for (int slot = from; slot != end && slot >= 0; slot = m_next[slot])
                if (Keys[slot].Equals(key))
                    return true;
            return false;
        }

        // The slot is lost to parallel writers, and found again by the next writer that is alone.
        void GiveBack(int slot)
        {
            int head = Volatile.Read(ref m_firstFree);
            while (true)
            {
                m_next[slot] = head;
                int seen = Interlocked.CompareExchange(ref m_firstFree, slot, head);
                if (seen == head)
                    break;
                head = seen;
            }
            Interlocked.Increment(ref m_freeCount);
        }

        void Rebuild(int capacity)
        {
            HashTable<TKey, TValue> old = this;
            int buckets = 1 << CollectionHelper.Log2Ceil(Math.Max(2, capacity * 2 > 0 ? capacity * 2 : capacity));
            Keys = AllocatorManager.Allocate<TKey>(m_allocator, capacity);
            Values = AllocatorManager.Allocate<TValue>(m_allocator, capacity);
            m_next = AllocatorManager.Allocate<int>(m_allocator, capacity);
            m_buckets = AllocatorManager.Allocate<int>(m_allocator, buckets);
            m_bucketMask = buckets - 1;
            Capacity = capacity;
            Clear();
            if (old.Keys == null)
                return;
            int bucket = -1, slot = -1;
            while (old.MoveNext(ref bucket, ref slot))
            {
                int to = m_used++;
                Keys[to] = old.Keys[slot];
                Values[to] = old.Values[slot];
                int home = Bucket(Keys[to]);
                m_next[to] = m_buckets[home];
                m_buckets[home] = to;
            }
            old.FreeArrays();
        }

        void FreeArrays()
        {
            AllocatorManager.Free(m_allocator, Keys);
            AllocatorManager.Free(m_allocator, Values);
            AllocatorManager.Free(m_allocator, m_next);
            AllocatorManager.Free(m_allocator, m_buckets);
        }
    }
}
