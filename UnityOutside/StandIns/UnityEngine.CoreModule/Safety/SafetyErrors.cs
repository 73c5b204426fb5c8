namespace StandIns.Safety;

static unsafe class SafetyErrors
{
    internal static void Deallocated(in AtomicSafetyHandle handle)
    {
        // Unity looks where the handle points without asking.
        if (handle.m_Node == null)
            throw new NullReferenceException("The container was never made.");
        string name = SafetyNames.Of(handle.m_Name);
        throw new ObjectDisposedException(name,
            $"Attempted to access {name} which has been disposed, was invalidated by a change of its container, "
            + "or has not been allocated.");
    }

    internal static void Refuse(in AtomicSafetyHandle handle, bool write)
    {
        if (handle.m_Node == null || (handle.m_Version != handle.CurrentVersion
            && (handle.m_Flags & (AtomicSafetyHandle.OfJob | AtomicSafetyHandle.Secondary)) != AtomicSafetyHandle.OfJob))
            Deallocated(handle);
        string name = SafetyNames.Of(handle.m_Name);
        if ((handle.m_Flags & AtomicSafetyHandle.OfJob) != 0)
            throw new InvalidOperationException(write
                ? $"The {name} has been declared as [ReadOnly] in the job, but you are writing to it."
                : $"The {name} has been declared as [WriteOnly] in the job, but you are reading from it.");
        JobAccess access = InFlightJobs.Blocking(handle.m_Node, write);
        throw new InvalidOperationException(
            $"The previously scheduled job {access.Job} {access.Verb} the {access.Container}. You must call "
            + $"JobHandle.Complete() on the job {access.Job}, before you can {(write ? "write to" : "read from")} the "
            + $"{access.ContainerType} safely.");
    }

    internal static void RefuseDeallocation(in AtomicSafetyHandle handle)
    {
        string name = SafetyNames.Of(handle.m_Name);
        if ((handle.m_Flags & AtomicSafetyHandle.OfJob) != 0)
            throw new InvalidOperationException(
                $"The {name} can not be deallocated from a job: it belongs to the one who scheduled the job.");
        JobAccess access = InFlightJobs.Blocking(handle.m_Node, write: true);
        throw new InvalidOperationException(
            $"The previously scheduled job {access.Job} {access.Verb} the {access.Container}. You must call "
            + $"JobHandle.Complete() on the job {access.Job}, before you can deallocate the {access.ContainerType} safely.");
    }
}
