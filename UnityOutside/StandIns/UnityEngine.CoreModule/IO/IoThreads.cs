namespace StandIns.Io;

/// <summary>Two threads that open, read and close files, first come first served.</summary>
/// <remarks>Job threads that have nothing to run do it first: whoever reads a block finds its bytes in the core's own cache when
/// it decodes them, and nobody has to be woken. The threads here take what has waited for <see cref="RestMs"/>, so that reading
/// goes on beside long jobs.</remarks>
static class IoThreads
{
    readonly struct Entry(Action work)
    {
        public readonly Action Work = work;
        public readonly long Queued = Stopwatch.GetTimestamp();

        public bool HasRested => Stopwatch.GetTimestamp() - Queued >= RestMs * Stopwatch.Frequency / 1000;
    }

    const int Count = 2;
    const int RestMs = 1;

    static readonly object s_gate = new object();
    static readonly Queue<Entry> s_queue = new Queue<Entry>();
    static int s_waiting;
    static int s_started;
    static int s_sleepers;
    // Threads that will look again within RestMs.
    static int s_resting;
    static bool s_paused;

    internal static bool HasWaiting => Volatile.Read(ref s_waiting) > 0 && !Volatile.Read(ref s_paused);

    internal static void Enqueue(Action work)
    {
        if (SimulatedWorkers.IsOn)
        {
            work();
            return;
        }
        lock (s_gate)
        {
            s_queue.Enqueue(new Entry(work));
            s_waiting++;
            if (s_sleepers == 0 && s_started < Count)
            {
                s_started++;
                new Thread(Run, 1 << 20) { IsBackground = true, Name = $"File reader {s_started}" }.Start();
            }
            if (s_resting == 0)
                Monitor.Pulse(s_gate);
        }
        JobQueue.WakeOne();
    }

    /// <summary>Makes what so many open files and their reads take. Unity has it in native memory: whoever measures the garbage
    /// of frames does not count it.</summary>
    internal static void Prepare(int files)
    {
        OpenFile.Prepare(files);
        ReadRequest.Prepare(files);
        FileHandle.All.Prepare(files);
        ReadRequest.All.Prepare(files);
        JobNodes.Prepare(8 * files);
#if NET
        lock (s_gate)
            s_queue.EnsureCapacity(2 * files);
#endif
    }

    /// <summary>Holds back what has not begun, so that a test can look at reads in progress.</summary>
    internal static void Pause(bool paused)
    {
        lock (s_gate)
        {
            Volatile.Write(ref s_paused, paused);
            Monitor.PulseAll(s_gate);
        }
    }

    /// <summary>Does what is first in the queue on the calling thread, if there is something.</summary>
    internal static bool TryRunOne()
    {
        if (!HasWaiting)
            return false;
        Action work;
        lock (s_gate)
        {
            if (s_queue.Count == 0 || s_paused)
                return false;
            work = Take();
        }
        work();
        return true;
    }

    static void Run()
    {
        while (true)
        {
            Action work;
            lock (s_gate)
            {
                while (s_queue.Count == 0 || s_paused)
                {
                    s_sleepers++;
                    Monitor.Wait(s_gate);
                    s_sleepers--;
                }
                if (!s_queue.Peek().HasRested)
                {
                    s_resting++;
                    Monitor.Wait(s_gate, RestMs);
                    s_resting--;
                    continue;
                }
                work = Take();
                // While this one reads, the other looks after the rest.
                if (s_queue.Count > 0)
                    Monitor.Pulse(s_gate);
            }
            work();
        }
    }

    static Action Take()
    {
        s_waiting--;
        return s_queue.Dequeue().Work;
    }
}
