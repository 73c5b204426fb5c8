namespace StandIns.Safety;

/// <summary>What Unity refuses when a job is scheduled.</summary>
static unsafe class JobChecks
{
    [Conditional("ENABLE_UNITY_COLLECTIONS_CHECKS")]
    internal static void CheckThread(string what)
    {
        if (JobThread.IsExecuting)
            throw new InvalidOperationException($"{what} can not be called from within a job.");
        if (!MainThread.IsCurrent)
            throw new InvalidOperationException($"{what} can only be called from the main thread.");
    }

    internal static JobRecord Register<T>(ref T job, bool parallel, JobHandle dependency, bool runsAtOnce = false)
        where T : struct
    {
        CheckThread(runsAtOnce ? "Run" : "Schedule");
        JobLayout layout = JobLayout.Of(typeof(T));
        if (layout.Refusal != null)
            throw new InvalidOperationException(layout.Refusal);
        string name = typeof(T).Name;
        // The job lies in an object that a garbage collection may move, and the records below allocate.
        fixed (byte* at = &SystemUnsafe.As<T, byte>(ref job))
            return Register(at, layout, name, parallel, dependency, runsAtOnce);
    }

    internal static JobRecord Register(byte* at, JobLayout layout, string name, bool parallel, JobHandle dependency,
        bool runsAtOnce)
    {
        JobField[] fields = layout.Containers;
        for (int i = 0; i < fields.Length; i++)
        {
            if (fields[i].DisablesSafety || fields[i].Type.SafetyOffset < 0)
                continue;
            ref AtomicSafetyHandle handle = ref HandleOf(at, fields[i]);
            CheckValid(handle, fields[i], runsAtOnce);
            CheckParallelWrites(fields[i], parallel);
            for (int k = 0; k < i; k++)
                CheckAlias(at, fields[i], fields[k]);
            CheckConflicts(handle.m_Node, fields[i], name, dependency);
        }

        JobRecord record = JobRecord.After(dependency, name);
        foreach (JobField field in fields)
        {
            if (field.DisablesSafety || field.Type.SafetyOffset < 0)
                continue;
            ref AtomicSafetyHandle handle = ref HandleOf(at, field);
            AtomicSafetyHandle owner = handle;
            record.Add(handle.m_Node, new JobAccess
            {
                Writes = field.Writes,
                Container = field.Name,
                ContainerType = field.Type.Name,
            });
            if (field.Writes && handle.m_Node->BumpOnScheduledWrite != 0 && (handle.m_Flags & AtomicSafetyHandle.Secondary) == 0)
                handle.m_Node->SecondaryVersion++;
            handle.m_Flags |= AtomicSafetyHandle.OfJob | (field.IsReadOnly ? AtomicSafetyHandle.NoWrite : 0)
                | (field.IsWriteOnly ? AtomicSafetyHandle.NoRead : 0);
            handle.m_Name = field.NameId;
            if (field.IsDeallocated)
                AtomicSafetyHandle.Release(owner);
        }
        return record;
    }

    static ref AtomicSafetyHandle HandleOf(byte* job, JobField field) =>
        ref SystemUnsafe.AsRef<AtomicSafetyHandle>(job + field.Offset + field.Type.SafetyOffset);

    static void CheckValid(in AtomicSafetyHandle handle, JobField field, bool runsAtOnce)
    {
        if (handle.m_Node == null)
            throw new InvalidOperationException(
                $"The {field.Name} has not been assigned or constructed. All containers must be valid when scheduling a "
                + "job.");
        if (handle.m_Version != handle.CurrentVersion)
            throw new InvalidOperationException(
                $"The {field.Name} has been deallocated. All containers must be valid when scheduling a job.");
        if (!runsAtOnce && (handle.m_Flags & AtomicSafetyHandle.Temp) != 0)
            throw new InvalidOperationException($"The {field.Name} is memory of Allocator.Temp, which cannot be used in a "
                + "scheduled job. Use Allocator.TempJob.");
    }

    static void CheckParallelWrites(JobField field, bool parallel)
    {
        if (parallel && field.Writes && !field.DisablesParallelForRestriction && !field.Type.SupportsMinMax)
            throw new InvalidOperationException($"{field.Name} is not declared [ReadOnly] in a IJobParallelFor job. The "
                + "container does not support parallel writing. Please use a more suitable container type.");
    }

    static void CheckAlias(byte* job, JobField field, JobField other)
    {
        if (other.DisablesSafety || other.Type.SafetyOffset < 0 || (!field.Writes && !other.Writes))
            return;
        if (HandleOf(job, field).m_Node == HandleOf(job, other).m_Node)
            throw new InvalidOperationException($"The writeable {(field.Writes ? field : other).Name} is the same "
                + $"{field.Type.Name} as {(field.Writes ? other : field).Name}, two containers may not be the same "
                + "(aliasing).");
    }

    static void CheckConflicts(SafetyNode* node, JobField field, string name, JobHandle dependency)
    {
        List<JobAccess> accesses = InFlightJobs.Of(node);
        if (accesses == null)
            return;
        // The last ones are the likeliest to be depended on.
        for (int i = accesses.Count - 1; i >= 0; i--)
        {
            JobAccess access = accesses[i];
            if ((!access.Writes && !field.Writes) || access.Record.Precedes(dependency))
                continue;
            throw new InvalidOperationException($"The previously scheduled job {access.Job} {access.Verb} the "
                + $"{access.Container}. You are trying to schedule a new job {name}, which "
                + $"{(field.Writes ? "writes to" : "reads from")} the same {field.Type.Name} (via {field.Name}). To "
                + $"guarantee safety, you must include {access.Job} as a dependency of the newly scheduled job.");
        }
    }
}
