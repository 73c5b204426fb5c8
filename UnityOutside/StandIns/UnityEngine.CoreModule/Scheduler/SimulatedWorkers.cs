namespace StandIns.Scheduling;

/// <summary>Workers in a clock of their own, as many as wanted, whatever the machine has: the calling thread runs their jobs, all
/// of which take the same time by that clock, and they are done when it says so. Reads take no time. What happens when is the
/// same in every run.</summary>
static class SimulatedWorkers
{
    static readonly Queue<(JobNode Node, int Version)> s_ready = new Queue<(JobNode, int)>();

    static readonly SortedDictionary<(double EndMs, long Number), (JobNode Node, int Batches)> s_running =
        new SortedDictionary<(double, long), (JobNode, int)>();

    static double s_jobMs;
    static double s_callMs;
    static long s_begun;
    static int s_idle;

    internal static bool IsOn { get; private set; }
    internal static double NowMs { get; private set; }
    internal static long Ticks => (long)(NowMs * Stopwatch.Frequency / 1000);

    /// <param name="callMs">The main thread's time to schedule a job, or to look whether it is done.</param>
    internal static void Begin(int workers, double jobMs, double callMs)
    {
        IsOn = true;
        NowMs = s_begun = 0;
        s_idle = workers;
        s_jobMs = jobMs;
        s_callMs = callMs;
        JobWorkers.Count = workers;
    }

    internal static void End()
    {
        IsOn = false;
        JobWorkers.Count = JobWorkers.DefaultCount;
        if (s_ready.Count + s_running.Count > 0)
            throw new InvalidOperationException("there are jobs that have not ended");
    }

    internal static void Push(JobNode node, int version) => s_ready.Enqueue((node, version));

    /// <summary>The main thread schedules a job, or looks at one.</summary>
    internal static void Call() => AdvanceTo(NowMs + s_callMs);

    internal static void AdvanceTo(double ms)
    {
        Start();
        while (s_running.Count > 0 && s_running.First().Key.EndMs <= ms)
            EndNext();
        NowMs = Math.Max(NowMs, ms);
    }

    internal static bool EndNext()
    {
        Start();
        if (s_running.Count == 0)
            return false;
        var next = s_running.First();
        s_running.Remove(next.Key);
        NowMs = Math.Max(NowMs, next.Key.EndMs);
        s_idle++;
        JobScheduler.EndBatches(next.Value.Node, next.Value.Batches);
        Start();
        return true;
    }

    static void Start()
    {
        while (s_idle > 0 && s_ready.TryPeek(out var ready))
        {
            if (!ready.Node.TryTake(ready.Version, JobWorkers.Count, out int first, out int count))
            {
                s_ready.Dequeue();
                continue;
            }
            s_idle--;
            JobScheduler.Execute(ready.Node, first, count);
            s_running.Add((NowMs + s_jobMs, s_begun++), (ready.Node, count));
        }
    }
}
