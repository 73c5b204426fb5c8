namespace Unity.Collections.LowLevel.Unsafe;

public static unsafe partial class NativeArrayUnsafeUtility
{
    public static void SetAtomicSafetyHandle<T>(ref NativeArray<T> array, AtomicSafetyHandle safety) where T : struct
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        array.m_Safety = safety;
#endif
    }

    /// <summary>Wraps memory that lies elsewhere; in the test build it needs a safety handle before it can be used.</summary>
    public static NativeArray<T> ConvertExistingDataToNativeArray<T>(void* dataPointer, int length, Allocator allocator)
        where T : struct
    {
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), "Length must be >= 0");
        NativeArray<T> array = default;
        array.m_Buffer = dataPointer;
        array.m_Length = length;
        array.m_AllocatorLabel = allocator;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        array.m_MaxIndex = length - 1;
#endif
        return array;
    }

    public static void* GetUnsafePtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckWrite();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> nativeArray) where T : struct
    {
        nativeArray.CheckRead();
        return nativeArray.m_Buffer;
    }

    public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T>.ReadOnly nativeArray) where T : struct
    {
        nativeArray.CheckRead();
        return nativeArray.m_Buffer;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void* GetUnsafeBufferPointerWithoutChecks<T>(NativeArray<T> nativeArray) where T : struct =>
        nativeArray.m_Buffer;
}
