namespace Unity.Collections;

public unsafe partial struct NativeArray<T>
{
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal readonly void CheckRead()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal readonly void CheckWrite()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly void CheckElementRead(int index)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (index < m_MinIndex || index > m_MaxIndex)
            ThrowOutOfRange(index);
        AtomicSafetyHandle.CheckReadAndThrow(m_Safety);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly void CheckElementWrite(int index)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (index < m_MinIndex || index > m_MaxIndex)
            ThrowOutOfRange(index);
        AtomicSafetyHandle.CheckWriteAndThrow(m_Safety);
#endif
    }

#if ENABLE_UNITY_COLLECTIONS_CHECKS
    readonly void ThrowOutOfRange(int index)
    {
        if (index >= 0 && index < m_Length && (m_MinIndex != 0 || m_MaxIndex != m_Length - 1))
            throw new IndexOutOfRangeException(
                $"Index {index} is out of restricted IJobParallelFor range [{m_MinIndex}...{m_MaxIndex}] in "
                + "ReadWriteBuffer.\nReadWriteBuffers are restricted to only read & write the element at the job "
                + "index. You can use double buffering strategies to avoid race conditions due to reading & writing in "
                + "parallel to the same elements from a job.");
        throw new IndexOutOfRangeException($"Index {index} is out of range of '{m_Length}' Length.");
    }
#endif

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckAllocation(int length, Allocator allocator)
    {
        if (allocator <= Allocator.None)
            throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", nameof(allocator));
        if (allocator >= Allocator.FirstUserIndex)
            throw new ArgumentException("Use CollectionHelper.CreateNativeArray for custom allocators", nameof(allocator));
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
        CheckElementType();
        if (JobThread.IsExecuting && allocator != Allocator.Temp)
            throw new InvalidOperationException("Jobs can only create Temp memory");
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal static void CheckElementType()
    {
        if (!UnsafeUtility.IsUnmanaged<T>())
            throw new InvalidOperationException($"{typeof(T)} used in NativeArray<{typeof(T)}> must be unmanaged (contain no "
                + "managed types) and cannot itself be a native container type.");
    }

    readonly void CheckDisposable()
    {
        if (m_AllocatorLabel == Allocator.Invalid)
            throw new InvalidOperationException(
                "The NativeArray can not be Disposed because it was not allocated with a valid allocator.");
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    readonly void CheckSubArray(int start, int length)
    {
        CheckReadOrWrite();
        if (start < 0)
            throw new ArgumentOutOfRangeException(nameof(start), "start must be >= 0");
        if ((long)start + length > m_Length)
            throw new ArgumentOutOfRangeException(nameof(length),
                $"sub array range {start}-{(long)start + length - 1} is outside the range of the native array "
                + $"0-{m_Length - 1}");
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
    }

    // A view may be made while jobs are in flight: what is done through it is checked then.
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    readonly void CheckReadOrWrite()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (m_Buffer != null && (m_Safety.m_Flags & AtomicSafetyHandle.OfJob) == 0)
            AtomicSafetyHandle.CheckExistsAndThrow(m_Safety);
#endif
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    static void CheckSameSize<U>() where U : struct
    {
        if (SystemUnsafe.SizeOf<T>() != SystemUnsafe.SizeOf<U>())
            throw new InvalidOperationException($"Types {typeof(T)} and {typeof(U)} are different sizes - direct "
                + "reinterpretation is not possible. If this is what you intended, use Reinterpret(<type size>)");
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    readonly void CheckReinterpret<U>(int expectedTypeSize, long bytes, long length) where U : struct
    {
        if (SystemUnsafe.SizeOf<T>() != expectedTypeSize)
            throw new InvalidOperationException($"Type {typeof(T)} was expected to be {expectedTypeSize} but is "
                + $"{SystemUnsafe.SizeOf<T>()} bytes");
        if (length * SystemUnsafe.SizeOf<U>() != bytes)
            throw new InvalidOperationException($"Types {typeof(T)} (array length {m_Length}) and {typeof(U)} cannot be "
                + "aliased due to size constraints. The size of the types and lengths involved must line up.");
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    readonly void CheckReinterpretRange<U>(int index, bool write) where U : struct
    {
        if (write)
            CheckWrite();
        else
            CheckRead();
        if (index < 0 || (long)index * SystemUnsafe.SizeOf<T>() + SystemUnsafe.SizeOf<U>()
            > (long)m_Length * SystemUnsafe.SizeOf<T>())
            throw new ArgumentOutOfRangeException(nameof(index), "access length must be within the array");
    }
}
