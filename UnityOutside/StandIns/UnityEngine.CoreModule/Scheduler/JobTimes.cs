namespace StandIns.Scheduling;

/// <remarks>On Linux in time of the processor, to which other load of the machine adds little; elsewhere by the clock.</remarks>
static class JobTimes
{
    static readonly bool s_isLinux = RuntimeInformation.IsOSPlatform(OSPlatform.Linux) && IntPtr.Size == 8;

    static Dictionary<Type, JobRuns> s_runsOfKind;

    internal static bool AreTaken => Volatile.Read(ref s_runsOfKind) != null;

    internal static void Begin() => Volatile.Write(ref s_runsOfKind, []);

    /// <summary>What was measured, by kind of job; ends the measurement.</summary>
    internal static Dictionary<Type, JobRuns> End() => Interlocked.Exchange(ref s_runsOfKind, null);

    /// <summary>Of the thread that asks: a run is from one to another.</summary>
    internal static double NowMs()
    {
        const int ThreadCpuTime = 3;
        var time = default(ClockTime);
        if (s_isLinux && GetTime(ThreadCpuTime, ref time) == 0)
            return time.Seconds * 1e3 + time.Nanoseconds / 1e6;
        return 1000.0 * Stopwatch.GetTimestamp() / Stopwatch.Frequency;
    }

    internal static void Add(Type kind, double ms)
    {
        var taken = Volatile.Read(ref s_runsOfKind);
        if (taken == null)
            return;
        lock (taken)
        {
            if (!taken.TryGetValue(kind, out var runs))
                taken.Add(kind, runs = new JobRuns());
            runs.Add(ms);
        }
    }

    [DllImport("libc", EntryPoint = "clock_gettime")] static extern int GetTime(int clock, ref ClockTime time);

    struct ClockTime
    {
        internal long Seconds;
        internal long Nanoseconds;
    }
}
