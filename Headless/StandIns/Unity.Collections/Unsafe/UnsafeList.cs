using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Threading;
using StandIns.Collections;
using Unity.Jobs;

namespace Unity.Collections.LowLevel.Unsafe
{
    /// <summary>A growing list without checks of access. Pointer and length come first: deferred arrays rely on it.</summary>
    [DebuggerDisplay("Length = {Length}, Capacity = {Capacity}")]
    public unsafe struct UnsafeList<T> : INativeDisposable, INativeList<T>, IEnumerable<T> where T : unmanaged
    {
        public const int MaxCapacity = int.MaxValue;

        [NativeDisableUnsafePtrRestriction]
        public T* Ptr;
        public int m_length;
        public int m_capacity;
        public AllocatorManager.AllocatorHandle Allocator;

        public UnsafeList(T* ptr, int length)
        {
            Ptr = ptr;
            m_length = length;
            m_capacity = length;
            Allocator = AllocatorManager.None;
        }

        public UnsafeList(int initialCapacity, AllocatorManager.AllocatorHandle allocator,
            NativeArrayOptions options = NativeArrayOptions.UninitializedMemory)
        {
            CollectionHelper.CheckAllocator(allocator);
            Ptr = null;
            m_length = 0;
            m_capacity = 0;
            Allocator = allocator;
            SetCapacity(Math.Max(initialCapacity, 1));
            if (options == NativeArrayOptions.ClearMemory)
                UnsafeUtility.MemClear(Ptr, (long)m_capacity * sizeof(T));
        }

        public int Length
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            readonly get => m_length;
            set
            {
                if (value > m_capacity)
                    Resize(value);
                else
                    m_length = value;
            }
        }

        public int Capacity
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            readonly get => m_capacity;
            set => SetCapacity(value);
        }

        public readonly bool IsEmpty => Ptr == null || m_length == 0;

        public readonly bool IsCreated => Ptr != null;

        public T this[int index]
        {
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            get
            {
                CollectionHelper.CheckIndexInRange(index, m_length);
                return Ptr[index];
            }
            [MethodImpl(MethodImplOptions.AggressiveInlining)]
            set
            {
                CollectionHelper.CheckIndexInRange(index, m_length);
                Ptr[index] = value;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public ref T ElementAt(int index)
        {
            CollectionHelper.CheckIndexInRange(index, m_length);
            return ref Ptr[index];
        }

        /// <summary>A list whose struct is allocated too, so that copies of the pointer share it.</summary>
        public static UnsafeList<T>* Create(int initialCapacity, AllocatorManager.AllocatorHandle allocator,
            NativeArrayOptions options = NativeArrayOptions.UninitializedMemory)
        {
            UnsafeList<T>* list = AllocatorManager.Allocate<UnsafeList<T>>(allocator);
            *list = new UnsafeList<T>(initialCapacity, allocator, options);
            return list;
        }

        public static void Destroy(UnsafeList<T>* listData)
        {
            AllocatorManager.AllocatorHandle allocator = listData->Allocator;
            listData->Dispose();
            AllocatorManager.Free(allocator, listData);
        }

        public void Dispose()
        {
            if (!IsCreated)
                return;
            if (Allocator.Index > (ushort)Collections.Allocator.None)
                AllocatorManager.Free(Allocator, Ptr);
            Allocator = AllocatorManager.Invalid;
            Ptr = null;
            m_length = 0;
            m_capacity = 0;
        }

        public JobHandle Dispose(JobHandle inputDeps)
        {
            if (!IsCreated)
                return inputDeps;
            if (Allocator.Index > (ushort)Collections.Allocator.None)
                inputDeps = new FreeJob { Memory = Ptr, Allocator = Allocator }.Schedule(inputDeps);
            Allocator = AllocatorManager.Invalid;
            Ptr = null;
            m_length = 0;
            m_capacity = 0;
            return inputDeps;
        }

        public void Clear() => m_length = 0;

        public void Resize(int length, NativeArrayOptions options = NativeArrayOptions.UninitializedMemory)
        {
            int old = m_length;
            if (length > m_capacity)
                Grow(length);
            m_length = length;
            if (options == NativeArrayOptions.ClearMemory && length > old)
                UnsafeUtility.MemClear(Ptr + old, (long)(length - old) * sizeof(T));
        }

        /// <summary>At least this capacity, rounded up to a power of two.</summary>
        public void SetCapacity(int capacity)
        {
            CheckCapacity(capacity);
            int atLeast = Math.Max(capacity, CollectionHelper.CacheLineSize / sizeof(T));
            int rounded = atLeast > 1 << 30 ? int.MaxValue : 1 << CollectionHelper.Log2Ceil(atLeast);
            if (rounded != m_capacity)
                Realloc(rounded);
        }

        public void TrimExcess()
        {
            if (m_capacity != m_length)
                Realloc(m_length);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Add(in T value)
        {
            int at = m_length;
            if (at < m_capacity)
            {
                Ptr[at] = value;
                m_length = at + 1;
                return;
            }
            // The value may lie in this very list, which is about to move.
            T copy = value;
            Resize(at + 1);
            Ptr[at] = copy;
        }

        public void AddNoResize(T value)
        {
            CheckNoResize(1);
            Ptr[m_length++] = value;
        }

        public void AddRange(void* ptr, int count)
        {
            int at = m_length;
            Resize(at + count);
            UnsafeUtility.MemCpy(Ptr + at, ptr, (long)count * sizeof(T));
        }

        public void AddRange(UnsafeList<T> container) => AddRange(container.Ptr, container.m_length);

        public void AddRangeNoResize(void* ptr, int count)
        {
            CheckNoResize(count);
            UnsafeUtility.MemCpy(Ptr + m_length, ptr, (long)count * sizeof(T));
            m_length += count;
        }

        public void AddRangeNoResize(UnsafeList<T> list) => AddRangeNoResize(list.Ptr, list.m_length);

        public void AddReplicate(in T value, int count)
        {
            T copy = value;
            int at = m_length;
            Resize(at + count);
            new Span<T>(Ptr + at, count).Fill(copy);
        }

        public void InsertRangeWithBeginEnd(int begin, int end)
        {
            CheckBeginEnd(begin, end);
            int count = end - begin;
            if (count <= 0)
                return;
            int after = m_length - begin;
            Resize(m_length + count);
            UnsafeUtility.MemMove(Ptr + end, Ptr + begin, (long)after * sizeof(T));
        }

        public void InsertRange(int index, int count) => InsertRangeWithBeginEnd(index, index + count);

        public void RemoveAtSwapBack(int index)
        {
            CollectionHelper.CheckIndexInRange(index, m_length);
            Ptr[index] = Ptr[--m_length];
        }

        public void RemoveRangeSwapBack(int index, int count)
        {
            CheckRange(index, count);
            int from = Math.Max(m_length - count, index + count);
            UnsafeUtility.MemCpy(Ptr + index, Ptr + from, (long)(m_length - from) * sizeof(T));
            m_length -= count;
        }

        public void RemoveAt(int index)
        {
            CollectionHelper.CheckIndexInRange(index, m_length);
            RemoveRange(index, 1);
        }

        public void RemoveRange(int index, int count)
        {
            CheckRange(index, count);
            UnsafeUtility.MemMove(Ptr + index, Ptr + index + count, (long)(m_length - index - count) * sizeof(T));
            m_length -= count;
        }

        public ParallelWriter AsParallelWriter() =>
            new ParallelWriter((UnsafeList<T>*)System.Runtime.CompilerServices.Unsafe.AsPointer(ref this));

        public Enumerator GetEnumerator() => new Enumerator { m_Ptr = Ptr, m_Length = m_length, m_Index = -1 };

        IEnumerator<T> IEnumerable<T>.GetEnumerator() => GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

        // Doubles, so that adding one by one stays linear.
        void Grow(int length) => SetCapacity((int)Math.Max(length, Math.Min(2L * m_capacity, 1 << 30)));

        void Realloc(int capacity)
        {
            T* grown = null;
            if (capacity > 0)
            {
                grown = (T*)AllocatorManager.Allocate(Allocator, sizeof(T), UnsafeUtility.AlignOf<T>(), capacity);
                if (m_capacity > 0)
                    UnsafeUtility.MemCpy(grown, Ptr, (long)Math.Min(capacity, m_capacity) * sizeof(T));
            }
            if (Ptr != null)
                AllocatorManager.Free(Allocator, Ptr);
            Ptr = grown;
            m_capacity = capacity;
            m_length = Math.Min(m_length, capacity);
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckCapacity(int capacity)
        {
            if (capacity < 0)
                throw new ArgumentOutOfRangeException(nameof(capacity), $"Capacity {capacity} must be positive.");
            if (capacity < m_length)
                throw new ArgumentOutOfRangeException(nameof(capacity),
                    $"Capacity {capacity} is out of range in container of '{m_length}' Length.");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        internal readonly void CheckNoResize(int count)
        {
            if (m_capacity < m_length + (long)count)
                throw new InvalidOperationException("AddNoResize assumes that list capacity is sufficient "
                    + $"(Capacity {m_capacity}, Length {m_length}), requested length {m_length + (long)count}!");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckRange(int index, int count)
        {
            if (count < 0)
                throw new ArgumentOutOfRangeException(nameof(count), $"Value for count {count} must be positive.");
            if (index < 0 || (long)index + count > m_length)
                throw new ArgumentOutOfRangeException(nameof(index),
                    $"Range [{index}, {(long)index + count}) is out of a list of length {m_length}.");
        }

        [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
        readonly void CheckBeginEnd(int begin, int end)
        {
            if (begin > end)
                throw new ArgumentException($"Value for begin {begin} index must less or equal to end {end}.");
            if (begin < 0 || begin > m_length)
                throw new ArgumentOutOfRangeException(nameof(begin), $"Value for begin {begin} must be within the list.");
        }

        /// <summary>Adds from several threads at once, up to the capacity.</summary>
        public struct ParallelWriter
        {
            [NativeDisableUnsafePtrRestriction]
            public UnsafeList<T>* ListData;

            internal ParallelWriter(UnsafeList<T>* listData)
            {
                ListData = listData;
            }

            public readonly void* Ptr => ListData->Ptr;

            public void AddNoResize(T value)
            {
                int at = ParallelAppend.Reserve(ref ListData->m_length, ListData->m_capacity, 1);
                ListData->Ptr[at] = value;
            }

            public void AddRangeNoResize(void* ptr, int count)
            {
                int at = ParallelAppend.Reserve(ref ListData->m_length, ListData->m_capacity, count);
                UnsafeUtility.MemCpy(ListData->Ptr + at, ptr, (long)count * sizeof(T));
            }

            public void AddRangeNoResize(UnsafeList<T> list) => AddRangeNoResize(list.Ptr, list.m_length);
        }

        public struct Enumerator : IEnumerator<T>
        {
            internal T* m_Ptr;
            internal int m_Length;
            internal int m_Index;

            public T Current => m_Ptr[m_Index];

            object IEnumerator.Current => Current;

            public bool MoveNext() => ++m_Index < m_Length;

            public void Reset() => m_Index = -1;

            public void Dispose()
            {
            }
        }
    }
}
