namespace StandIns.Scheduling;

/// <summary>Jobs that are ready, first come first served, and the threads that sleep until there are some.</summary>
static class JobQueue
{
    struct Entry
    {
        public JobNode Node;
        public int Version;
        public int Shares; // Threads that may still join in.
    }

    static readonly object s_gate = new object();
    static Entry[] s_ring = new Entry[256];
    static int s_head;
    static int s_count;
    static int s_sleepers;

    internal static bool IsEmpty => Volatile.Read(ref s_count) == 0;

    internal static void Push(JobNode node, int version, int shares)
    {
        lock (s_gate)
        {
            if (s_count == s_ring.Length)
                Grow();
            s_ring[(s_head + s_count) & (s_ring.Length - 1)] = new Entry { Node = node, Version = version, Shares = shares };
            s_count++;
            for (int i = 0; i < shares && i < s_sleepers; i++)
                Monitor.Pulse(s_gate);
        }
    }

    internal static bool TryPop(out JobNode node, out int version)
    {
        if (!IsEmpty)
        {
            lock (s_gate)
            {
                while (s_count > 0)
                {
                    ref Entry entry = ref s_ring[s_head];
                    node = entry.Node;
                    version = entry.Version;
                    bool alive = node.HasWork(version);
                    if (!alive || --entry.Shares == 0)
                    {
                        entry.Node = null;
                        s_head = (s_head + 1) & (s_ring.Length - 1);
                        s_count--;
                    }
                    if (alive)
                        return true;
                }
            }
        }
        node = null;
        version = 0;
        return false;
    }

    internal static void WaitForWork()
    {
        lock (s_gate)
        {
            if (s_count > 0 || IoThreads.HasWaiting)
                return;
            s_sleepers++;
            Monitor.Wait(s_gate);
            s_sleepers--;
        }
    }

    internal static void WaitFor(JobNode node, int version)
    {
        lock (s_gate)
        {
            // Set before Done is read, as the finishing thread reads it after Done was set.
            node.Waited = true;
            Thread.MemoryBarrier();
            if (s_count > 0 || node.Done || node.Version != version)
                return;
            s_sleepers++;
            Monitor.Wait(s_gate);
            s_sleepers--;
            // Woken for a job that this thread may not run, its own being done: somebody else is to.
            if (s_count > 0 && s_sleepers > 0)
                Monitor.Pulse(s_gate);
        }
    }

    /// <summary>Wakes another thread if there is work that this one will not do.</summary>
    internal static void PassOn()
    {
        lock (s_gate)
        {
            if (s_count > 0)
                Monitor.Pulse(s_gate);
        }
    }

    /// <summary>Wakes a thread that sleeps, if there is one: a read waits.</summary>
    internal static void WakeOne()
    {
        lock (s_gate)
        {
            if (s_sleepers > 0)
                Monitor.Pulse(s_gate);
        }
    }

    internal static void WakeAll()
    {
        lock (s_gate)
            Monitor.PulseAll(s_gate);
    }

    static void Grow()
    {
        var grown = new Entry[2 * s_ring.Length];
        for (int i = 0; i < s_count; i++)
            grown[i] = s_ring[(s_head + i) & (s_ring.Length - 1)];
        s_ring = grown;
        s_head = 0;
    }
}
