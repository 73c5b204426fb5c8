namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe partial class UnsafeUtility
{
    public static void* Malloc(long size, int alignment, Allocator allocator)
    {
        if (allocator == Allocator.Temp)
            return TempMemory.Allocate(size, alignment);
        CheckAllocator(allocator);
        void* memory = NativeHeap.Allocate(size, alignment);
        AllocationLedger.Add(memory, size, allocator, tracked: false);
        return memory;
    }

    public static void* MallocTracked(long size, int alignment, Allocator allocator, int callstacksToSkip)
    {
        if (allocator == Allocator.Temp)
            return TempMemory.Allocate(size, alignment);
        CheckAllocator(allocator);
        void* memory = NativeHeap.Allocate(size, alignment);
        AllocationLedger.Add(memory, size, allocator, tracked: true);
        return memory;
    }

    public static void Free(void* memory, Allocator allocator)
    {
        if (memory == null)
            return;
        if (allocator == Allocator.Temp)
        {
            TempMemory.Free(memory);
            return;
        }
        CheckAllocator(allocator);
        AllocationLedger.Remove(memory, allocator);
        NativeHeap.Free(memory);
    }

    public static void FreeTracked(void* memory, Allocator allocator) => Free(memory, allocator);
    public static int CheckForLeaks() => AllocationLedger.CheckForLeaks();
    public static int ForgiveLeaks() => AllocationLedger.ForgiveLeaks();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void MemCpy(void* destination, void* source, long size)
    {
        CheckSize(size);
        CheckApart((byte*)destination, (byte*)source, size);
        Buffer.MemoryCopy(source, destination, size, size);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void MemMove(void* destination, void* source, long size)
    {
        CheckSize(size);
        Buffer.MemoryCopy(source, destination, size, size);
    }

    public static void MemSet(void* destination, byte value, long size)
    {
        CheckSize(size);
        byte* at = (byte*)destination;
        while (size > 0)
        {
            int part = (int)Math.Min(size, 1 << 30);
            new Span<byte>(at, part).Fill(value);
            at += part;
            size -= part;
        }
    }

    public static void MemClear(void* destination, long size) => MemSet(destination, 0, size);

    public static int MemCmp(void* ptr1, void* ptr2, long size)
    {
        CheckSize(size);
        byte* a = (byte*)ptr1;
        byte* b = (byte*)ptr2;
        while (size > 0)
        {
            int part = (int)Math.Min(size, 1 << 30);
            int order = new ReadOnlySpan<byte>(a, part).SequenceCompareTo(new ReadOnlySpan<byte>(b, part));
            if (order != 0)
                return order;
            a += part;
            b += part;
            size -= part;
        }
        return 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int SizeOf<T>() where T : struct => SystemUnsafe.SizeOf<T>();

    public static int AlignOf<T>() where T : struct => SystemUnsafe.SizeOf<AlignOfHelper<T>>() - SystemUnsafe.SizeOf<T>();

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T ReadArrayElement<T>(void* source, int index) => SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(source), index);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WriteArrayElement<T>(void* destination, int index, T value) =>
        SystemUnsafe.Add(ref SystemUnsafe.AsRef<T>(destination), index) = value;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void* AddressOf<T>(ref T output) where T : struct => SystemUnsafe.AsPointer(ref output);

    public static bool IsUnmanaged<T>() => !RuntimeHelpers.IsReferenceOrContainsReferences<T>();

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckSize(long size)
    {
        if (size < 0)
            throw new ArgumentOutOfRangeException(nameof(size), size, "A size must be positive.");
    }

    // MemMove is for those; MemCpy may copy in any order.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckApart(byte* destination, byte* source, long size)
    {
        if (Math.Abs(destination - source) < size)
            throw new InvalidOperationException("MemCpy is not for memory that overlaps.");
    }

    static void CheckAllocator(Allocator allocator)
    {
        if (allocator != Allocator.Persistent && allocator != Allocator.TempJob && allocator != Allocator.Domain
            && allocator != Allocator.AudioKernel)
            throw new ArgumentException($"Invalid allocator: {allocator}.", nameof(allocator));
    }

#pragma warning disable CS0649 // Only measured, never filled.
    struct AlignOfHelper<T> where T : struct
    {
        public byte Dummy;
        public T Data;
    }
#pragma warning restore CS0649
}
