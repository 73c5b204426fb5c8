using System;
using System.Threading;
using Unity.Collections;

namespace StandIns.Collections
{
    /// <summary>A ring that doubles. Unity's is a chain of blocks; what can be seen of it is the same.</summary>
    unsafe struct QueueData<T> where T : unmanaged
    {
        T* m_items;
        int m_head;
        int m_capacity;
        int m_lock;
        AllocatorManager.AllocatorHandle m_allocator;

        internal int Count { get; private set; }

        internal static QueueData<T>* Create(AllocatorManager.AllocatorHandle allocator)
        {
            QueueData<T>* queue = AllocatorManager.Allocate<QueueData<T>>(allocator);
            *queue = new QueueData<T> { m_allocator = allocator };
            return queue;
        }

        internal static void Destroy(QueueData<T>* queue)
        {
            AllocatorManager.AllocatorHandle allocator = queue->m_allocator;
            if (queue->m_items != null)
                AllocatorManager.Free(allocator, queue->m_items);
            AllocatorManager.Free(allocator, queue);
        }

        internal readonly T At(int index) => m_items[(m_head + index) & (m_capacity - 1)];

        internal void Enqueue(T value)
        {
            if (Count == m_capacity)
                Grow();
            m_items[(m_head + Count) & (m_capacity - 1)] = value;
            Count++;
        }

        internal void EnqueueLocked(T value)
        {
            var spin = new SpinWait();
            while (Interlocked.CompareExchange(ref m_lock, 1, 0) != 0)
                spin.SpinOnce();
            Enqueue(value);
            Volatile.Write(ref m_lock, 0);
        }

        internal bool TryDequeue(out T item)
        {
            if (Count == 0)
            {
                item = default;
                return false;
            }
            item = m_items[m_head];
            m_head = (m_head + 1) & (m_capacity - 1);
            Count--;
            return true;
        }

        internal void Clear()
        {
            m_head = 0;
            Count = 0;
        }

        void Grow()
        {
            int capacity = Math.Max(16, 2 * m_capacity);
            T* grown = AllocatorManager.Allocate<T>(m_allocator, capacity);
            for (int i = 0; i < Count; i++)
                grown[i] = At(i);
            if (m_items != null)
                AllocatorManager.Free(m_allocator, m_items);
            m_items = grown;
            m_capacity = capacity;
            m_head = 0;
        }
    }
}
