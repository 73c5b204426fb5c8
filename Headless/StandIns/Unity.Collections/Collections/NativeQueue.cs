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
    public unsafe struct NativeQueue<T> : INativeDisposable where T : unmanaged
    {
        [NativeDisableUnsafePtrRestriction]
        internal QueueData<T>* m_Queue;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        internal AtomicSafetyHandle m_Safety;
        static readonly int s_name = AtomicSafetyHandle.NewStaticSafetyId<NativeQueue<T>>();
#endif

        public NativeQueue(AllocatorManager.AllocatorHandle allocator)
        {
            CollectionHelper.CheckAllocator(allocator);
            m_Queue = QueueData<T>.Create(allocator);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            m_Safety = CollectionHelper.CreateSafetyHandle(allocator);
            AtomicSafetyHandle.SetStaticSafetyId(ref m_Safety, s_name);
#endif
        }

        public readonly bool IsCreated => m_Queue != null;

        public int Count
        {
            get
            {
                CheckRead();
                return m_Queue->Count;
            }
        }

        public readonly bool IsEmpty()
        {
            if (!IsCreated)
                return true;
            CheckRead();
            return m_Queue->Count == 0;
        }

        public T Peek()
        {
            CheckRead();
            if (m_Queue->Count == 0)
                throw new InvalidOperationException("Trying to peek from an empty queue");
            return m_Queue->At(0);
        }

        public void Enqueue(T value)
        {
            CheckWrite();
            m_Queue->Enqueue(value);
        }

        public T Dequeue()
        {
            if (!TryDequeue(out T item))
                throw new InvalidOperationException("Trying to dequeue from an empty queue.");
            return item;
        }

        public bool TryDequeue(out T item)
        {
            CheckWrite();
            return m_Queue->TryDequeue(out item);
        }

        public void Clear()
        {
            CheckWrite();
            m_Queue->Clear();
        }

        public NativeArray<T> ToArray(AllocatorManager.AllocatorHandle allocator)
        {
            CheckRead();
            NativeArray<T> array = CollectionHelper.CreateNativeArray<T>(m_Queue->Count, allocator,
                NativeArrayOptions.UninitializedMemory);
            for (int i = 0; i < array.Length; i++)
                array[i] = m_Queue->At(i);
            return array;
        }

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
            QueueData<T>.Destroy(m_Queue);
            m_Queue = null;
        }

        public JobHandle Dispose(JobHandle inputDeps)
        {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            if (!AtomicSafetyHandle.IsDefaultValue(m_Safety))
                AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
            if (!IsCreated)
                return inputDeps;
            JobHandle disposed = new DisposeJob { Queue = this }.Schedule(inputDeps);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            AtomicSafetyHandle.Release(m_Safety);
#endif
            m_Queue = null;
            return disposed;
        }

        public ReadOnly AsReadOnly() => new ReadOnly(this);

        public ParallelWriter AsParallelWriter() => new ParallelWriter(this);

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
        [NativeContainerIsAtomicWriteOnly]
        public struct ParallelWriter
        {
            [NativeDisableUnsafePtrRestriction]
            readonly QueueData<T>* m_Queue;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif

            internal ParallelWriter(NativeQueue<T> queue)
            {
                m_Queue = queue.m_Queue;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = queue.m_Safety;
#endif
            }

            public void Enqueue(T value)
            {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
                m_Queue->EnqueueLocked(value);
            }
        }

        [NativeContainer]
        [NativeContainerIsReadOnly]
        public struct ReadOnly : IEnumerable<T>
        {
            [NativeDisableUnsafePtrRestriction]
            readonly QueueData<T>* m_Queue;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            internal AtomicSafetyHandle m_Safety;
#endif

            internal ReadOnly(NativeQueue<T> queue)
            {
                m_Queue = queue.m_Queue;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                m_Safety = queue.m_Safety;
#endif
            }

            public readonly bool IsCreated => m_Queue != null;

            public readonly int Count
            {
                get
                {
                    CheckRead();
                    return m_Queue->Count;
                }
            }

            public readonly bool IsEmpty() => !IsCreated || Count == 0;

            public readonly T this[int index]
            {
                get
                {
                    CollectionHelper.CheckIndexInRange(index, Count);
                    return m_Queue->At(index);
                }
            }

            public readonly Enumerator GetEnumerator() => new Enumerator(this);

            IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

            IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

            [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
            readonly void CheckRead()
            {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
                AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
            }
        }

        public struct Enumerator : IEnumerator<T>
        {
            ReadOnly m_Queue;
            int m_Index;

            internal Enumerator(ReadOnly queue)
            {
                m_Queue = queue;
                m_Index = -1;
            }

            public T Current => m_Queue[m_Index];

            object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_Index < m_Queue.Count;

            public void Reset() => m_Index = -1;

            public void Dispose()
            {
            }
        }

        struct DisposeJob : IJob
        {
            internal NativeQueue<T> Queue;

            public void Execute() => QueueData<T>.Destroy(Queue.m_Queue);
        }
    }
}
