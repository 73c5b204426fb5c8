namespace StandIns.Scheduling;

static unsafe partial class JobScheduler
{
    // A job that became ready when this worker finished another, and that nobody else has to be woken for.
    [ThreadStatic] static JobNode t_next;

    [ThreadStatic] static JobNode[] t_finishStack;
    [ThreadStatic] static int t_finishCount;
    [ThreadStatic] static bool t_finishing;

    // Scheduled, and not yet flushed: no worker sees them.
    static readonly List<JobNode> s_held = new List<JobNode>();
    static int s_heldCount;

    internal static JobHandle Schedule<T, TKind>(ref T data, int length, int batchSize, bool parallel, JobHandle dependency)
        where T : struct where TKind : struct, IJobKind<T>
    {
        CheckLength(length);
        JobWork<T, TKind> work = JobWork<T, TKind>.Take(ref data);
        JobRecord record = null;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        try
        {
            record = JobChecks.Register(ref work.Data, parallel, dependency);
        }
        catch
        {
            work.Return();
            throw;
        }
#endif
        JobNode node = JobNodes.Take();
        node.Work = work;
        node.Record = record;
        node.Shared = parallel;
        node.BatchSize = Math.Max(1, batchSize);
        node.Length = length;
        JobHandle handle = Commit(node, dependency);
        if (SimulatedWorkers.IsOn)
            SimulatedWorkers.Call();
        else
            JobWorkers.Start();
        Hold(node);
        return handle;
    }

    internal static void Flush()
    {
        if (Volatile.Read(ref s_heldCount) == 0)
            return;
        lock (s_held)
        {
            for (int i = 0; i < s_held.Count; i++)
                Release(s_held[i]);
            s_held.Clear();
            Volatile.Write(ref s_heldCount, 0);
        }
    }

    /// <summary>Executes at once, on the calling thread. What the job throws is logged, as with any other.</summary>
    internal static void Run<T, TKind>(ref T data, int length, bool parallel) where T : struct where TKind : struct, IJobKind<T>
    {
        CheckLength(length);
        T copy = data;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        JobRecord record = JobChecks.Register(ref copy, parallel, default, runsAtOnce: true);
#endif
        TempMemory.Mark mark = TempMemory.Now;
        JobThread.Enter();
        try
        {
            JobPatch<T>.SetThreadIndex(ref copy, JobThread.Index);
            if (length > 0)
                default(TKind).Execute(ref copy, 0, length);
        }
        catch (Exception exception)
        {
            UnityEngine.Debug.LogException(exception);
        }
        finally
        {
            JobThread.Leave();
            TempMemory.FreeSince(mark);
            JobPatch<T>.Deallocate(ref copy);
#if ENABLE_UNITY_COLLECTIONS_CHECKS
            record.Sync();
#endif
        }
    }

    internal static JobHandle Combine(JobHandle* handles, int count)
    {
        JobNode node = JobNodes.Take();
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        node.Record = JobRecord.Combine(handles, count);
#endif
        var handle = new JobHandle(node);
        for (int i = 0; i < count; i++)
            DependOn(node, handles[i]);
        node.Record?.Attach(handle);
        Release(node);
        return handle;
    }

    internal static JobNode BeginExternal() => JobNodes.Take();

    internal static void FinishExternal(JobNode node) => Release(node);

    /// <summary>Calls back, on whatever thread, once the dependency is done. The handle is done after that.</summary>
    internal static JobHandle CallAfter(JobHandle dependency, string name, Action callback)
    {
        JobNode node = JobNodes.Take();
        node.Callback = callback;
#if ENABLE_UNITY_COLLECTIONS_CHECKS
        node.Record = JobRecord.After(dependency, name);
#endif
        JobHandle handle = Commit(node, dependency);
        Release(node);
        return handle;
    }

    internal static bool IsCompleted(JobHandle handle)
    {
        if (handle.m_Index == 0)
            return true;
        if (SimulatedWorkers.IsOn)
            SimulatedWorkers.Call();
        return IsDone(handle);
    }

    static bool IsDone(JobHandle handle)
    {
        JobNode node = JobNodes.At(handle.m_Index);
        return Volatile.Read(ref node.Version) != handle.m_Version || node.Done;
    }

    internal static void Complete(JobHandle handle)
    {
        if (handle.m_Index == 0)
            return;
        Flush();
        JobNode node = JobNodes.At(handle.m_Index);
        int version = handle.m_Version;
        int spins = 0;
        while (!IsDone(handle))
        {
            if (SimulatedWorkers.IsOn)
            {
                if (!SimulatedWorkers.EndNext())
                    throw new InvalidOperationException("no job is left that the awaited one could depend on");
            }
            else if (RunBatches(node, version) || RunOne() || IoThreads.TryRunOne())
            {
                spins = 0;
            }
            else if (++spins < 40)
            {
                Thread.SpinWait(10);
            }
            else
            {
                JobQueue.WaitFor(node, version);
                spins = 0;
            }
            PutBackNext();
        }
        JobRecord record = null;
        lock (node)
            if (node.Version == version)
                record = node.Record;
        record?.Sync();
    }

    internal static bool RunOne()
    {
        JobNode node = t_next;
        int version;
        if (node != null)
        {
            t_next = null;
            version = node.Version;
        }
        else if (!JobQueue.TryPop(out node, out version))
            return false;
        RunBatches(node, version);
        return true;
    }

    static JobHandle Commit(JobNode node, JobHandle dependency)
    {
        var handle = new JobHandle(node);
        DependOn(node, dependency);
        node.Record?.Attach(handle);
        return handle;
    }

    static void Hold(JobNode node)
    {
        lock (s_held)
        {
            s_held.Add(node);
            Volatile.Write(ref s_heldCount, s_held.Count);
        }
    }

    static void CheckLength(int length)
    {
        if (length < 0)
            throw new ArgumentOutOfRangeException(nameof(length), length, "A job's length must be >= 0.");
    }

    static void DependOn(JobNode node, JobHandle dependency)
    {
        if (dependency.m_Index != 0)
            JobNodes.At(dependency.m_Index).AddDependent(dependency.m_Version, node);
    }

    static void Release(JobNode node)
    {
        if (Interlocked.Decrement(ref node.Pending) != 0)
            return;
        if (node.Work != null)
            node.BatchCount = node.Length == 0 ? 0
                : node.Shared ? (int)(((long)node.Length + node.BatchSize - 1) / node.BatchSize) : 1;
        if (node.BatchCount == 0)
        {
            Finish(node);
            return;
        }
        // After Publish another thread may run the node to its end: what is needed of it is read before.
        int version = node.Version;
        int shares = Math.Min(node.BatchCount, JobWorkers.Count + 1);
        bool keep = shares == 1 && JobThread.IsWorker && t_next == null && JobQueue.IsEmpty;
        node.Publish();
        if (SimulatedWorkers.IsOn)
            SimulatedWorkers.Push(node, version);
        else if (keep)
            t_next = node;
        else
            JobQueue.Push(node, version, shares);
    }

    /// <summary>Gives the job that this thread would have run next to whoever comes.</summary>
    internal static void PutBackNext()
    {
        JobNode node = t_next;
        if (node == null)
            return;
        t_next = null;
        JobQueue.Push(node, node.Version, 1);
    }

    static bool RunBatches(JobNode node, int version)
    {
        bool ran = false;
        while (node.TryTake(version, JobWorkers.Count + 1, out int first, out int count))
        {
            ran = true;
            Execute(node, first, count);
            if (node.BatchesDone(count))
            {
                Finish(node);
                break;
            }
        }
        return ran;
    }

    internal static void EndBatches(JobNode node, int count)
    {
        if (node.BatchesDone(count))
            Finish(node);
    }

    internal static void Execute(JobNode node, int first, int count)
    {
        int begin = 0;
        int end = node.Length;
        if (node.Shared)
        {
            begin = first * node.BatchSize;
            end = (int)Math.Min(node.Length, ((long)first + count) * node.BatchSize);
        }
        TempMemory.Mark mark = TempMemory.Now;
        JobThread.Enter();
        double begunMs = JobTimes.AreTaken ? JobTimes.NowMs() : -1;
        try
        {
            node.Work.Execute(begin, end, node.Shared, JobThread.Index);
        }
        catch (Exception exception)
        {
            UnityEngine.Debug.LogException(exception);
        }
        finally
        {
            if (begunMs >= 0)
                JobTimes.Add(node.Work.JobType, JobTimes.NowMs() - begunMs);
            JobThread.Leave();
            TempMemory.FreeSince(mark);
        }
    }

    // A node without work is done as soon as it is ready, and may make the next such node ready: a chain of them would be
    // as deep a recursion.
    static void Finish(JobNode node)
    {
        t_finishStack ??= new JobNode[16];
        if (t_finishCount == t_finishStack.Length)
            Array.Resize(ref t_finishStack, 2 * t_finishCount);
        t_finishStack[t_finishCount++] = node;
        if (t_finishing)
            return;
        t_finishing = true;
        try
        {
            while (t_finishCount > 0)
                FinishOne(t_finishStack[--t_finishCount]);
        }
        finally
        {
            t_finishing = false;
        }
    }

    static void FinishOne(JobNode node)
    {
        try
        {
            node.Work?.Finish();
            node.Callback?.Invoke();
        }
        catch (Exception exception)
        {
            UnityEngine.Debug.LogException(exception);
        }
        int count = node.Close(out JobNode[] dependents);
        Thread.MemoryBarrier();
        if (node.Waited)
            JobQueue.WakeAll();
        for (int i = 0; i < count; i++)
            Release(dependents[i]);
        if (node.LetGo())
            JobNodes.Recycle(node);
    }
}
