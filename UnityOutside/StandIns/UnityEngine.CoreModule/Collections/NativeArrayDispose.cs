namespace StandIns.Jobs;

/// <summary>What is left of an array that a job is to free; a container, so that the job counts as its writer.</summary>
[NativeContainer]
unsafe struct NativeArrayDispose
{
    [NativeDisableUnsafePtrRestriction] internal void* m_Buffer;
    internal Allocator m_AllocatorLabel;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
    internal AtomicSafetyHandle m_Safety;
#endif
}

unsafe struct NativeArrayDisposeJob : IJob
{
    internal NativeArrayDispose Data;

    public void Execute() => UnsafeUtility.FreeTracked(Data.m_Buffer, Data.m_AllocatorLabel);
}
