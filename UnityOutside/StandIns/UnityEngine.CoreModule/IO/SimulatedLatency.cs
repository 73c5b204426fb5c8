namespace StandIns.Io;

/// <summary>Reads that take long, without waiting: each read sets the clock that jobs may look at forward. Nothing else does, so
/// that a busy machine changes nothing.</summary>
static class SimulatedLatency
{
    static long s_ticksPerRead;
    static long s_ticks;
    static long s_reads;
    static long s_begunAt;
    internal static long Reads => Interlocked.Read(ref s_reads); // Reads since Begin.

    internal static long Now
    {
        get
        {
            long begunAt = Volatile.Read(ref s_begunAt);
            return (begunAt > 0 ? begunAt : Stopwatch.GetTimestamp()) + Volatile.Read(ref s_ticks);
        }
    }

    /// <param name="secondsPerRead">0 ends it; the clock never goes back.</param>
    internal static void Begin(double secondsPerRead)
    {
        Volatile.Write(ref s_ticksPerRead, (long)(secondsPerRead * Stopwatch.Frequency));
        Volatile.Write(ref s_begunAt, secondsPerRead > 0 ? Stopwatch.GetTimestamp() : 0);
        Interlocked.Exchange(ref s_reads, 0);
    }

    internal static void Read()
    {
        Interlocked.Increment(ref s_reads);
        long ticks = Volatile.Read(ref s_ticksPerRead);
        if (ticks > 0)
            Interlocked.Add(ref s_ticks, ticks);
    }
}
