namespace StandIns.Scheduling;

/// <summary>The worker threads. They start when the first job is scheduled, and are background threads.</summary>
static class JobWorkers
{
    // Unity's is the number of cores less one. More is allowed here, so that tests can ask for more threads than there are cores.
    internal static readonly int MaximumCount = Math.Max(Environment.ProcessorCount - 1, 8);

    internal static readonly int DefaultCount = Math.Max(1, Environment.ProcessorCount - 1);
    const int Spins = 60; // About 30 us: a slice of a chain follows the last one sooner than a thread wakes up.

    static readonly object s_lock = new object();
    static int s_count = DefaultCount;
    static int s_started;
    static readonly ManualResetEventSlim[] s_wanted = new ManualResetEventSlim[MaximumCount];

    internal static int Count
    {
        get => Volatile.Read(ref s_count);
        set
        {
            if (value < 0 || value > MaximumCount)
                throw new ArgumentOutOfRangeException(nameof(value), value,
                    $"Invalid JobWorkerCount: it must be between 0 and {MaximumCount}.");
            lock (s_lock)
            {
                Volatile.Write(ref s_count, value);
                for (int i = 0; i < s_started; i++)
                {
                    if (i < value)
                        s_wanted[i].Set();
                    else
                        s_wanted[i].Reset();
                }
            }
            JobQueue.WakeAll();
            if (s_started > 0)
                Start();
        }
    }

    /// <summary>Threads for the current count, those that are missing.</summary>
    internal static void Start()
    {
        if (Volatile.Read(ref s_started) >= Volatile.Read(ref s_count))
            return;
        lock (s_lock)
        {
            while (s_started < s_count)
            {
                int worker = s_started;
                s_wanted[worker] = new ManualResetEventSlim(true);
                var thread = new Thread(() => Run(worker), 4 << 20)
                {
                    IsBackground = true,
                    Name = $"Job worker {worker}",
                };
                Volatile.Write(ref s_started, s_started + 1);
                thread.Start();
            }
        }
    }

    static void Run(int worker)
    {
        JobThread.BecomeWorker(worker + 1);
        while (true)
        {
            if (worker >= Volatile.Read(ref s_count))
            {
                // What this worker took on, or was woken for, is for those that stay.
                JobScheduler.PutBackNext();
                JobQueue.PassOn();
                s_wanted[worker].Wait();
                continue;
            }
            if (JobScheduler.RunOne() || IoThreads.TryRunOne())
                continue;
            bool found = false;
            for (int i = 0; i < Spins && !found; i++)
            {
                Thread.SpinWait(10);
                found = !JobQueue.IsEmpty || IoThreads.HasWaiting;
            }
            if (!found)
                JobQueue.WaitForWork();
        }
    }
}
