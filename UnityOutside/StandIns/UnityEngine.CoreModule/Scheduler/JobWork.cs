namespace StandIns.Scheduling;

/// <summary>How one kind of job runs over a range: a struct, so that the call is a direct one.</summary>
interface IJobKind<T> where T : struct
{
    void Execute(ref T job, int begin, int end);
}

abstract class JobWork
{
    internal abstract Type JobType { get; }

    /// <param name="shared">Other threads run other ranges of the same job.</param>
    internal abstract void Execute(int begin, int end, bool shared, int threadIndex);

    internal abstract void Finish();
}

sealed class JobWork<T, TKind> : JobWork where T : struct where TKind : struct, IJobKind<T>
{
    static readonly object s_lock = new object();
    static JobWork<T, TKind> s_free;

    JobWork<T, TKind> m_nextFree;
    internal T Data;

    internal override Type JobType => typeof(T);

    internal static JobWork<T, TKind> Take(ref T data)
    {
        JobWork<T, TKind> work;
        lock (s_lock)
        {
            work = s_free;
            if (work != null)
                s_free = work.m_nextFree;
        }
        work ??= new JobWork<T, TKind>();
        work.Data = data;
        return work;
    }

    internal void Return()
    {
        lock (s_lock)
        {
            m_nextFree = s_free;
            s_free = this;
        }
    }

    internal override void Execute(int begin, int end, bool shared, int threadIndex)
    {
        // On the stack: a job may hold pointers to its own fields, and this object may be moved. And a copy for each range: a
        // job's fields are no way from one index to another, and the range that a thread may write is kept in them.
        T data = Data;
        JobPatch<T>.SetThreadIndex(ref data, threadIndex);
        if (shared)
            JobPatch<T>.Restrict(ref data, begin, end);
        default(TKind).Execute(ref data, begin, end);
    }

    internal override void Finish()
    {
        JobPatch<T>.Deallocate(ref Data);
        Return();
    }
}
