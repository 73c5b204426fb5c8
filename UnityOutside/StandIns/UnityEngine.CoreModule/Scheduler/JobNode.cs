namespace StandIns.Scheduling;

sealed class JobNode(int index)
{
    internal readonly int Index = index;
    internal int Version = 1;
    internal JobWork Work;
    internal int Length;
    internal int BatchSize;
    internal int BatchCount;
    internal bool Shared;
    internal Action Callback;
    internal volatile bool Done;
    internal volatile bool Waited;
    internal JobRecord Record; // In the test build: the job for Unity's rules.

    internal int Pending;
    internal JobNode NextFree;

    // The version and the first batch that nobody took. Not this version: not ready yet, or another job by now.
    long m_cursor;
    int m_unfinishedBatches;
    // Who still looks at the node: the thread that finishes it, and who is to complete it.
    int m_holders;
    bool m_observed;
    JobNode[] m_dependents = new JobNode[4];
    int m_dependentCount;

    internal void Reset()
    {
        Work = null;
        Length = 0;
        BatchSize = 1;
        BatchCount = 0;
        Shared = false;
        Callback = null;
        Done = false;
        Waited = false;
        Record = null;
        Pending = 1;
        m_holders = 2;
        m_observed = false;
        m_dependentCount = 0;
    }

    internal void AddDependent(int version, JobNode dependent)
    {
        lock (this)
        {
            if (Version != version)
                return;
            if (Done)
                return;
            Interlocked.Increment(ref dependent.Pending);
            if (m_dependentCount == m_dependents.Length)
                Array.Resize(ref m_dependents, 2 * m_dependentCount);
            m_dependents[m_dependentCount++] = dependent;
        }
    }

    internal void Publish()
    {
        m_unfinishedBatches = BatchCount;
        Volatile.Write(ref m_cursor, (long)Version << 32);
    }

    internal bool HasWork(int version)
    {
        long cursor = Volatile.Read(ref m_cursor);
        return (int)(cursor >> 32) == version && (int)cursor < BatchCount;
    }

    internal bool TryTake(int version, int takers, out int first, out int count)
    {
        long cursor = Volatile.Read(ref m_cursor);
        while ((int)(cursor >> 32) == version)
        {
            first = (int)cursor;
            int left = BatchCount - first;
            if (left <= 0)
                break;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            // One batch at a time: what is out of a job's range then never depends on who was fast.
            count = 1;
#else
            count = Math.Max(1, left / (8 * takers));
#endif
            long seen = Interlocked.CompareExchange(ref m_cursor, cursor + count, cursor);
            if (seen == cursor)
                return true;
            cursor = seen;
        }
        first = count = 0;
        return false;
    }

    internal bool BatchesDone(int count) => Interlocked.Add(ref m_unfinishedBatches, -count) == 0;

    internal int Close(out JobNode[] dependents)
    {
        lock (this)
        {
            Done = true;
            dependents = m_dependents;
            return m_dependentCount;
        }
    }

    /// <summary>The main thread has completed the node: it need not be kept for that.</summary>
    internal bool Observe(int version)
    {
        lock (this)
        {
            if (Version != version || m_observed)
                return false;
            m_observed = true;
            return --m_holders == 0;
        }
    }

    /// <summary>The finishing thread looks at the node no more.</summary>
    internal bool LetGo()
    {
        lock (this)
        {
            if (Record == null)
            {
                m_observed = true;
                m_holders--;
            }
            return --m_holders == 0;
        }
    }

    internal void Retire()
    {
        lock (this)
        {
            Version = Version == int.MaxValue ? 1 : Version + 1;
            m_cursor = 0;
            Array.Clear(m_dependents, 0, m_dependentCount);
            m_dependentCount = 0;
            Work = null;
            Callback = null;
            Record = null;
        }
    }
}
