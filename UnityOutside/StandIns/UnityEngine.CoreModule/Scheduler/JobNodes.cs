namespace StandIns.Scheduling;

static class JobNodes
{
    static readonly object s_lock = new object();
    static JobNode[] s_nodes = new JobNode[1024];
    // Index 0 is what default(JobHandle) names: nothing.
    static int s_count = 1;
    static JobNode s_free;

    internal static JobNode At(int index) => Volatile.Read(ref s_nodes)[index];

    internal static JobNode Take()
    {
        JobNode node;
        lock (s_lock)
        {
            node = s_free;
            if (node != null)
            {
                s_free = node.NextFree;
            }
            else
            {
                if (s_count == s_nodes.Length)
                {
                    var grown = new JobNode[2 * s_count];
                    Array.Copy(s_nodes, grown, s_count);
                    Volatile.Write(ref s_nodes, grown);
                }
                node = new JobNode(s_count);
                s_nodes[s_count++] = node;
            }
        }
        node.Reset();
        return node;
    }

    internal static void Prepare(int count)
    {
        var nodes = new JobNode[count];
        for (int i = 0; i < count; i++)
            nodes[i] = Take();
        foreach (JobNode node in nodes)
            Recycle(node);
    }

    internal static void Recycle(JobNode node)
    {
        node.Retire();
        lock (s_lock)
        {
            node.NextFree = s_free;
            s_free = node;
        }
    }
}
