using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using StandIns.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace Unity.Collections
{
    [NativeContainer]
    public unsafe struct NativeHashMap<TKey, TValue> : INativeDisposable, IEnumerable<KVPair<TKey, TValue>>
        where TKey : unmanaged, IEquatable<TKey> where TValue : unmanaged
    {
        [NativeDisableUnsafePtrRestriction]
        internal HashTable<TKey, TValue>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeHashMap<TKey, TValue>>();
#endif

        public NativeHashMap(int initialCapacity, AllocatorManager.AllocatorHandle allocator)
        {
            CollectionHelper.CheckAllocator(allocator);
            m_Table = HashTable<TKey, TValue>.Create(initialCapacity, allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = CollectionHelper.CreateSafetyHandle(allocator);
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
#endif
        }

        public readonly bool IsCreated => m_Table != null;

        public readonly bool IsEmpty
        {
            get
            {
                if (!IsCreated)
                    return true;
                CheckRead();
                return m_Table->Count == 0;
            }
        }

        public int Count
        {
            get
            {
                CheckRead();
                return m_Table->Count;
            }
        }

        public int Capacity
        {
            readonly get
            {
                CheckRead();
                return m_Table->Capacity;
            }
            set
            {
                CheckWrite();
                m_Table->SetCapacity(value);
            }
        }

        public TValue this[TKey key]
        {
            get
            {
                if (!TryGetValue(key, out TValue item))
                    throw new ArgumentException($"Key: {key} is not present.");
                return item;
            }
            set
            {
                CheckWrite();
                int slot = m_Table->Find(key);
                if (slot < 0)
                    slot = m_Table->TryAdd(key);
                m_Table->Values[slot] = value;
            }
        }

        public void Clear()
        {
            CheckWrite();
            m_Table->Clear();
        }

        public bool TryAdd(TKey key, TValue item)
        {
            CheckWrite();
            int slot = m_Table->TryAdd(key);
            if (slot >= 0)
                m_Table->Values[slot] = item;
            return slot >= 0;
        }

        public void Add(TKey key, TValue item)
        {
            if (!TryAdd(key, item))
                throw new ArgumentException($"An item with the same key has already been added: {key}");
        }

        public bool Remove(TKey key)
        {
            CheckWrite();
            return m_Table->Remove(key);
        }

        public bool TryGetValue(TKey key, out TValue item)
        {
            CheckRead();
            int slot = m_Table->Find(key);
            item = slot < 0 ? default : m_Table->Values[slot];
            return slot >= 0;
        }

        public bool ContainsKey(TKey key)
        {
            CheckRead();
            return m_Table->Find(key) >= 0;
        }

        public void TrimExcess()
        {
            CheckWrite();
            m_Table->TrimExcess();
        }

        public NativeArray<TKey> GetKeyArray(AllocatorManager.AllocatorHandle allocator) =>
            AsReadOnly().GetKeyArray(allocator);

        public NativeArray<TValue> GetValueArray(AllocatorManager.AllocatorHandle allocator) =>
            AsReadOnly().GetValueArray(allocator);

        public NativeKeyValueArrays<TKey, TValue> GetKeyValueArrays(AllocatorManager.AllocatorHandle allocator) =>
            AsReadOnly().GetKeyValueArrays(allocator);

        public void Dispose()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            CollectionHelper.DisposeSafetyHandle(ref m_Safety);
#endif
            HashTable<TKey, TValue>.Destroy(m_Table);
            m_Table = null;
        }

        public JobHandle Dispose(JobHandle inputDeps)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return inputDeps;
            JobHandle disposed = new DisposeJob { Container = this }.Schedule(inputDeps);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.Release(m_Safety);
#endif
            m_Table = null;
            return disposed;
        }

        public ReadOnly AsReadOnly() => new ReadOnly(this);

        public Enumerator GetEnumerator() => new Enumerator(AsReadOnly());

        IEnumerator<KVPair<TKey, TValue>> IEnumerable<KVPair<TKey, TValue>>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckRead()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckWrite()
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
        }

        [NativeContainer]
        [NativeContainerIsReadOnly]
        public struct ReadOnly : IEnumerable<KVPair<TKey, TValue>>
        {
            [NativeDisableUnsafePtrRestriction]
            internal HashTable<TKey, TValue>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif

            internal ReadOnly(NativeHashMap<TKey, TValue> map)
            {
                m_Table = map.m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = map.m_Safety;
#endif
            }

            public readonly bool IsCreated => m_Table != null;

            public readonly bool IsEmpty => !IsCreated || Count == 0;

            public readonly int Count
            {
                get
                {
                    CheckRead();
                    return m_Table->Count;
                }
            }

            public readonly int Capacity
            {
                get
                {
                    CheckRead();
                    return m_Table->Capacity;
                }
            }

            public readonly TValue this[TKey key]
            {
                get
                {
                    if (!TryGetValue(key, out TValue item))
                        throw new ArgumentException($"Key: {key} is not present.");
                    return item;
                }
            }

            public readonly bool TryGetValue(TKey key, out TValue item)
            {
                CheckRead();
                int slot = m_Table->Find(key);
                item = slot < 0 ? default : m_Table->Values[slot];
                return slot >= 0;
            }

            public readonly bool ContainsKey(TKey key)
            {
                CheckRead();
                return m_Table->Find(key) >= 0;
            }

            public readonly NativeArray<TKey> GetKeyArray(AllocatorManager.AllocatorHandle allocator)
            {
                CheckRead();
                NativeArray<TKey> keys = CollectionHelper.CreateNativeArray<TKey>(m_Table->Count, allocator);
                int bucket = -1, slot = -1;
                for (int i = 0; m_Table->MoveNext(ref bucket, ref slot); i++)
                    keys[i] = m_Table->Keys[slot];
                return keys;
            }

            public readonly NativeArray<TValue> GetValueArray(AllocatorManager.AllocatorHandle allocator)
            {
                CheckRead();
                NativeArray<TValue> values = CollectionHelper.CreateNativeArray<TValue>(m_Table->Count, allocator);
                int bucket = -1, slot = -1;
                for (int i = 0; m_Table->MoveNext(ref bucket, ref slot); i++)
                    values[i] = m_Table->Values[slot];
                return values;
            }

            public readonly NativeKeyValueArrays<TKey, TValue> GetKeyValueArrays(AllocatorManager.AllocatorHandle allocator) =>
                new NativeKeyValueArrays<TKey, TValue> { Keys = GetKeyArray(allocator), Values = GetValueArray(allocator) };

            public readonly Enumerator GetEnumerator() => new Enumerator(this);

            IEnumerator<KVPair<TKey, TValue>> IEnumerable<KVPair<TKey, TValue>>.GetEnumerator() => GetEnumerator();

            IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

            [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
            internal readonly void CheckRead()
            {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
            }
        }

        [NativeContainer]
        [NativeContainerIsReadOnly]
        public struct Enumerator : IEnumerator<KVPair<TKey, TValue>>
        {
            [NativeDisableUnsafePtrRestriction]
            internal HashTable<TKey, TValue>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif
            int m_Bucket;
            int m_Slot;

            internal Enumerator(ReadOnly map)
            {
                map.CheckRead();
                m_Table = map.m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = map.m_Safety;
#endif
                m_Bucket = -1;
                m_Slot = -1;
            }

            public KVPair<TKey, TValue> Current => new KVPair<TKey, TValue>(m_Table, m_Slot);

            object IEnumerator.Current => Current;

            public bool MoveNext()
            {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
                return m_Table->MoveNext(ref m_Bucket, ref m_Slot);
            }

            public void Reset()
            {
                m_Bucket = -1;
                m_Slot = -1;
            }

            public void Dispose()
            {
            }
        }

        struct DisposeJob : IJob
        {
            internal NativeHashMap<TKey, TValue> Container;

            public void Execute() => HashTable<TKey, TValue>.Destroy(Container.m_Table);
        }
    }
}
