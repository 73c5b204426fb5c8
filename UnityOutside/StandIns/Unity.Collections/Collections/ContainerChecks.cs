namespace StandIns.Collections;

static class ContainerChecks
{
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void CheckIndexInRange(int index, int length)
    {
        if ((uint)index >= (uint)length)
            throw new IndexOutOfRangeException($"Index {index} is out of range in container of '{length}' Length.");
    }

    internal static AtomicSafetyHandle CreateSafetyHandle(AllocatorManager.AllocatorHandle allocator) =>
        allocator.ToAllocator == Allocator.Temp ? AtomicSafetyHandle.GetTempMemoryHandle() : AtomicSafetyHandle.Create();

    /// <summary>Whether there is anything to dispose; throws where that was done already, or a job is at it.</summary>
    internal static bool TryRelease(AtomicSafetyHandle handle, bool isCreated)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (!AtomicSafetyHandle.IsDefaultValue(handle))
            AtomicSafetyHandle.CheckExistsAndThrow(handle);
        if (isCreated)
        {
            AtomicSafetyHandle.CheckDeallocateAndThrow(handle);
            AtomicSafetyHandle.Release(handle);
        }
#endif
        return isCreated;
    }
}
