namespace StandIns.Collections;

/// <summary>A list's elements. The struct itself is allocated, so that copies of a list share it.</summary>
unsafe struct ListData<T> where T : unmanaged
{
    const int MinBytes = 64;
    const int MaxElements = 1 << 30;

    AllocatorManager.AllocatorHandle m_allocator;

    internal T* Items;
    internal int Length;
    internal int Capacity;

    internal static ListData<T>* Create(int capacity, AllocatorManager.AllocatorHandle allocator)
    {
        CheckBytes(capacity);
        ListData<T>* list = AllocatorManager.Allocate<ListData<T>>(allocator);
        *list = new ListData<T> { m_allocator = allocator };
        list->SetCapacity(Math.Max(capacity, 1));
        return list;
    }

    internal static void Destroy(ListData<T>* list)
    {
        AllocatorManager.AllocatorHandle allocator = list->m_allocator;
        AllocatorManager.Free(allocator, list->Items);
        AllocatorManager.Free(allocator, list);
    }

    /// <summary>At least this capacity, rounded up to a power of two.</summary>
    internal void SetCapacity(int capacity)
    {
        CheckBytes(capacity);
        if (capacity < Length)
            throw new ArgumentOutOfRangeException(nameof(capacity), capacity,
                $"The capacity is out of range in a container of '{Length}' Length.");
        int rounded = (int)RoundedUp.ToPowerOfTwo(Math.Max(capacity, MinBytes / sizeof(T)));
        if (rounded == Capacity)
            return;
        T* items = AllocatorManager.Allocate<T>(m_allocator, rounded);
        if (Items != null)
        {
            UnsafeUtility.MemCpy(items, Items, (long)Length * sizeof(T));
            AllocatorManager.Free(m_allocator, Items);
        }
        Items = items;
        Capacity = rounded;
    }

    internal void Resize(int length, NativeArrayOptions options)
    {
        CheckBytes(length);
        int old = Length;
        if (length > Capacity)
            SetCapacity(length);
        Length = length;
        if (options == NativeArrayOptions.ClearMemory && length > old)
            UnsafeUtility.MemClear(Items + old, (long)(length - old) * sizeof(T));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Add(in T value)
    {
        if (Length == Capacity)
            GrowFor(in value);
        Items[Length++] = value;
    }

    internal void AddRange(void* items, int count)
    {
        if (count < 0)
            throw new ArgumentOutOfRangeException(nameof(count), count, "Must be positive.");
        CheckBytes((long)Length + count);
        if (Length + count > Capacity)
            CheckIsOutside(items);
        int at = Length;
        Resize(at + count, NativeArrayOptions.UninitializedMemory);
        UnsafeUtility.MemCpy(Items + at, items, (long)count * sizeof(T));
    }

    internal void RemoveAtSwapBack(int index)
    {
        ContainerChecks.CheckIndexInRange(index, Length);
        Items[index] = Items[--Length];
    }

    internal void RemoveAt(int index)
    {
        ContainerChecks.CheckIndexInRange(index, Length);
        Length--;
        UnsafeUtility.MemMove(Items + index, Items + index + 1, (long)(Length - index) * sizeof(T));
    }

    void GrowFor(in T value)
    {
        CheckBytes((long)Length + 1);
        fixed (T* at = &value)
            CheckIsOutside(at);
        SetCapacity(Length + 1);
    }

    // Unity frees the old elements before it reads what is to be added.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    readonly void CheckIsOutside(void* items)
    {
        if (items >= Items && items < Items + Capacity)
            throw new InvalidOperationException("The list moves to grow, and what is to be added lies in it.");
    }

    // Beyond, Unity's first release for 6000.0 loses what was in the list: it rounds and multiplies in int.
    static void CheckBytes(long count)
    {
        if (count < 0 || count > MaxElements || count * sizeof(T) > int.MaxValue)
            throw new ArgumentOutOfRangeException(nameof(count), count,
                $"A list takes at most 2^30 elements and 2^31 - 1 bytes ({sizeof(T)} each).");
    }
}
