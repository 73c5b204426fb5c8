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
    public unsafe struct NativeHashSet<T> : INativeDisposable, IEnumerable<T> where T : unmanaged, IEquatable<T>
    {
        [NativeDisableUnsafePtrRestriction]
        internal HashTable<T, byte>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeHashSet<T>>();
#endif

        public NativeHashSet(int initialCapacity, AllocatorManager.AllocatorHandle allocator)
        {
            CollectionHelper.CheckAllocator(allocator);
            m_Table = HashTable<T, byte>.Create(initialCapacity, allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = CollectionHelper.CreateSafetyHandle(allocator);
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
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

        public void Clear()
        {
            CheckWrite();
            m_Table->Clear();
        }

        public bool Add(T item)
        {
            CheckWrite();
            return m_Table->TryAdd(item) >= 0;
        }

        public bool Remove(T item)
        {
            CheckWrite();
            return m_Table->Remove(item);
        }

        public bool Contains(T item)
        {
            CheckRead();
            return m_Table->Find(item) >= 0;
        }

        public void TrimExcess()
        {
            CheckWrite();
            m_Table->TrimExcess();
        }

        public NativeArray<T> ToNativeArray(AllocatorManager.AllocatorHandle allocator) =>
            AsReadOnly().ToNativeArray(allocator);

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
            HashTable<T, byte>.Destroy(m_Table);
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

        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

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
        public struct ReadOnly : IEnumerable<T>
        {
            [NativeDisableUnsafePtrRestriction]
            internal HashTable<T, byte>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif

            internal ReadOnly(NativeHashSet<T> set)
            {
                m_Table = set.m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = set.m_Safety;
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

            public readonly bool Contains(T item)
            {
                CheckRead();
                return m_Table->Find(item) >= 0;
            }

            public readonly NativeArray<T> ToNativeArray(AllocatorManager.AllocatorHandle allocator)
            {
                CheckRead();
                NativeArray<T> items = CollectionHelper.CreateNativeArray<T>(m_Table->Count, allocator);
                int bucket = -1, slot = -1;
                for (int i = 0; m_Table->MoveNext(ref bucket, ref slot); i++)
                    items[i] = m_Table->Keys[slot];
                return items;
            }

            public readonly Enumerator GetEnumerator() => new Enumerator(this);

            IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

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
        public struct Enumerator : IEnumerator<T>
        {
            [NativeDisableUnsafePtrRestriction]
            internal HashTable<T, byte>* m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif
            int m_Bucket;
            int m_Slot;

            internal Enumerator(ReadOnly set)
            {
                set.CheckRead();
                m_Table = set.m_Table;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = set.m_Safety;
#endif
                m_Bucket = -1;
                m_Slot = -1;
            }

            public T Current => m_Table->Keys[m_Slot];

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
            internal NativeHashSet<T> Container;

            public void Execute() => HashTable<T, byte>.Destroy(Container.m_Table);
        }
    }
}
