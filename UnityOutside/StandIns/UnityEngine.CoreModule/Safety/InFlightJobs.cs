namespace StandIns.Safety;

sealed class JobAccess
{
    public JobRecord Record;
    public bool Writes;
    public string Container; // Type and field: Unity.Collections.NativeArray`1[System.Int32] SumJob.Values.
    public string ContainerType;

    public string Job => Record.Name;
    public string Verb => Writes ? "writes to" : "reads from";
}

/// <summary>Which jobs use which container, from Schedule until the main thread has completed them. That a job has run is not
/// enough: what Unity refuses must not depend on how fast a worker was. Only the main thread comes here.</summary>
static unsafe class InFlightJobs
{
    static readonly Dictionary<int, List<JobAccess>> s_accessesOfNode = new Dictionary<int, List<JobAccess>>();

    internal static List<JobAccess> Of(SafetyNode* node) =>
        node->InFlight != 0 && s_accessesOfNode.TryGetValue(node->Index, out List<JobAccess> list) ? list : null;

    internal static void Add(SafetyNode* node, JobAccess access)
    {
        if (!s_accessesOfNode.TryGetValue(node->Index, out List<JobAccess> list))
            s_accessesOfNode.Add(node->Index, list = new List<JobAccess>());
        // A job that comes after a writer comes after all that the writer waited for: only the last writer and the readers
        // since are looked at again. In a chain of readers, only the last.
        if (access.Writes)
            list.Clear();
        else
            list.RemoveAll(other => !other.Writes && access.Record.DependsDirectlyOn(other.Record));
        list.Add(access);
        node->InFlight |= access.Writes ? SafetyNode.WriterInFlight : SafetyNode.ReaderInFlight;
    }

    internal static void Remove(SafetyNode* node, JobAccess access)
    {
        List<JobAccess> list = s_accessesOfNode[node->Index];
        list.Remove(access);
        int inFlight = 0;
        foreach (JobAccess other in list)
            inFlight |= other.Writes ? SafetyNode.WriterInFlight : SafetyNode.ReaderInFlight;
        node->InFlight = inFlight;
    }

    /// <summary>A job that forbids the main thread to read, or to write.</summary>
    internal static JobAccess Blocking(SafetyNode* node, bool write)
    {
        JobAccess found = null;
        foreach (JobAccess access in Of(node))
            if (access.Writes || (write && found == null))
                found = access;
        return found;
    }
}
