namespace StandIns.Safety;

/// <summary>A scheduled job as Unity's rules see it: what it depends on and which containers it uses, until the main thread has
/// completed it or a job after it.</summary>
sealed unsafe class JobRecord
{
    static readonly JobRecord[] s_none = new JobRecord[0];
    static long s_lastId;

    internal readonly string Name;
    // Grows with time: a job can only depend on smaller ones.
    readonly long m_id = Interlocked.Increment(ref s_lastId);
    JobRecord[] m_dependencies;
    List<(IntPtr Node, JobAccess Access)> m_accesses;
    long m_visit;
    bool m_synced;

    static long s_visit;
    static readonly Stack<JobRecord> s_stack = new Stack<JobRecord>();

    JobRecord(string name, JobRecord[] dependencies) => (Name, m_dependencies) = (name, dependencies);

    internal JobHandle Handle { get; private set; }

    internal static JobRecord After(JobHandle dependency, string name)
    {
        JobRecord record = Of(dependency);
        return new JobRecord(name, record == null ? s_none : new[] { record });
    }

    internal static JobRecord Combine(JobHandle* handles, int count)
    {
        var records = new List<JobRecord>(count);
        for (int i = 0; i < count; i++)
        {
            JobRecord record = Of(handles[i]);
            if (record != null)
                records.Add(record);
        }
        return new JobRecord("combined dependencies", records.ToArray());
    }

    internal void Attach(JobHandle handle) => Handle = handle;

    internal void Add(SafetyNode* node, JobAccess access)
    {
        (m_accesses ??= new List<(IntPtr, JobAccess)>()).Add(((IntPtr)node, access));
        access.Record = this;
        InFlightJobs.Add(node, access);
    }

    internal bool DependsDirectlyOn(JobRecord other) => Array.IndexOf(m_dependencies, other) >= 0;

    internal bool Precedes(JobHandle dependency)
    {
        if (m_synced)
            return true;
        JobRecord from = Of(dependency);
        if (from == null)
            return false;
        long visit = ++s_visit;
        s_stack.Clear();
        s_stack.Push(from);
        while (s_stack.Count > 0)
        {
            JobRecord record = s_stack.Pop();
            if (record == this)
                return true;
            if (record.m_visit == visit || record.m_synced || record.m_id < m_id)
                continue;
            record.m_visit = visit;
            foreach (JobRecord before in record.m_dependencies)
                s_stack.Push(before);
        }
        return false;
    }

    internal static bool Precedes(JobHandle handle, JobHandle dependency)
    {
        JobRecord record = Of(handle);
        return record == null || record.Precedes(dependency);
    }

    /// <summary>The main thread has waited for the job: it and all before it are over.</summary>
    internal void Sync()
    {
        var stack = new Stack<JobRecord>();
        stack.Push(this);
        while (stack.Count > 0)
        {
            JobRecord record = stack.Pop();
            if (record.m_synced)
                continue;
            record.m_synced = true;
            foreach (JobRecord before in record.m_dependencies)
                stack.Push(before);
            record.m_dependencies = s_none;
            if (record.m_accesses != null)
                foreach ((IntPtr node, JobAccess access) in record.m_accesses)
                    InFlightJobs.Remove((SafetyNode*)node, access);
            record.m_accesses = null;
            JobHandle handle = record.Handle;
            if (handle.m_Index == 0)
                continue;
            JobNode jobNode = JobNodes.At(handle.m_Index);
            if (jobNode.Observe(handle.m_Version))
                JobNodes.Recycle(jobNode);
        }
    }

    // Stale handles name nothing: what they named was completed.
    static JobRecord Of(JobHandle handle)
    {
        if (handle.m_Index == 0)
            return null;
        JobNode node = JobNodes.At(handle.m_Index);
        lock (node)
        {
            JobRecord record = node.Version == handle.m_Version ? node.Record : null;
            return record == null || record.m_synced ? null : record;
        }
    }
}
