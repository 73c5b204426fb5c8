namespace Unity.Collections.LowLevel.Unsafe;

/// <summary>A container's permission to touch its memory. The copy that a job gets says what the job declared; the others ask the
/// node whether jobs are in flight that the main thread has not completed.</summary>
public unsafe partial struct AtomicSafetyHandle
{
    internal const int OfJob = 1;
    internal const int NoRead = 2;
    internal const int NoWrite = 4;
    internal const int Secondary = 8;
    internal const int Temp = 16;

    [NativeDisableUnsafePtrRestriction] internal SafetyNode* m_Node;
    internal int m_Version;
    internal int m_Flags;
    internal int m_Name; // Of the container's type; in a job's copy of the field.

    public static AtomicSafetyHandle Create()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        SafetyNode* node = SafetyNode.Create();
        return new AtomicSafetyHandle { m_Node = node, m_Version = node->Version };
#else
        return default;
#endif
    }

    /// <summary>For memory of Allocator.Temp. Each container has its own, so that its end is known.</summary>
    public static AtomicSafetyHandle GetTempMemoryHandle()
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        AtomicSafetyHandle handle = Create();
        handle.m_Flags |= Temp;
        TempMemory.NoteContainer(handle.m_Node);
        return handle;
#else
        return default;
#endif
    }

    public static bool IsDefaultValue(in AtomicSafetyHandle handle) => handle.m_Node == null;

    internal readonly int CurrentVersion => (m_Flags & Secondary) != 0 ? m_Node->SecondaryVersion : m_Node->Version;

    /// <summary>Makes this the handle of a view: writes that may move the memory end it.</summary>
    public static void UseSecondaryVersion(ref AtomicSafetyHandle handle)
    {
        if (handle.m_Node == null || (handle.m_Flags & Secondary) != 0)
            return;
        handle.m_Flags |= Secondary;
        handle.m_Version = handle.m_Node->SecondaryVersion;
    }

    public static void SetBumpSecondaryVersionOnScheduleWrite(AtomicSafetyHandle handle, bool value)
    {
        if (handle.m_Node != null)
            handle.m_Node->BumpOnScheduledWrite = value ? 1 : 0;
    }

    public static int NewStaticSafetyId<T>() => SafetyNames.IdOf(SafetyNames.Of(typeof(T)));

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void SetStaticSafetyId(ref AtomicSafetyHandle handle, int staticSafetyId) => handle.m_Name = staticSafetyId;

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void CheckExistsAndThrow(in AtomicSafetyHandle handle)
    {
        if (handle.m_Node == null || handle.m_Version != handle.CurrentVersion)
            SafetyErrors.Deallocated(handle);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void CheckReadAndThrow(AtomicSafetyHandle handle)
    {
        if (!handle.MayAccess(SafetyNode.WriterInFlight, NoRead))
            SafetyErrors.Refuse(handle, write: false);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void CheckWriteAndThrow(AtomicSafetyHandle handle)
    {
        if (!handle.MayAccess(SafetyNode.WriterInFlight | SafetyNode.ReaderInFlight, NoWrite))
            SafetyErrors.Refuse(handle, write: true);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void CheckWriteAndBumpSecondaryVersion(AtomicSafetyHandle handle)
    {
        CheckWriteAndThrow(handle);
        handle.m_Node->SecondaryVersion++;
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void CheckGetSecondaryDataPointerAndThrow(AtomicSafetyHandle handle)
    {
        if (!handle.MayAccess(SafetyNode.WriterInFlight, NoRead))
            SafetyErrors.Refuse(handle, write: false);
    }

    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    public static void CheckDeallocateAndThrow(AtomicSafetyHandle handle)
    {
        if (handle.m_Node == null || handle.m_Version != handle.CurrentVersion)
            SafetyErrors.Deallocated(handle);
        if (((handle.m_Flags & OfJob) | handle.m_Node->InFlight) != 0)
            SafetyErrors.RefuseDeallocation(handle);
    }

    public static void Release(AtomicSafetyHandle handle)
    {
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        if (handle.m_Node == null || handle.m_Version != handle.CurrentVersion)
            SafetyErrors.Deallocated(handle);
        SafetyNode.Release(handle.m_Node, recycle: handle.m_Node->InFlight == 0);
#endif
    }

    // A job's copy was checked when it was scheduled, and is told by its own flags; its container cannot go away under it.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    readonly bool MayAccess(int forbiddenInFlight, int forbiddenFlag)
    {
        if (m_Node == null)
            return false;
        if ((m_Flags & (OfJob | Secondary)) == OfJob)
            return (m_Flags & forbiddenFlag) == 0;
        if (m_Version != CurrentVersion)
            return false;
        return (m_Flags & OfJob) != 0 ? (m_Flags & forbiddenFlag) == 0 : (m_Node->InFlight & forbiddenInFlight) == 0;
    }
}
