namespace Unity.Profiling.LowLevel.Unsafe;

/// <summary>The clock that jobs may read.</summary>
public static class ProfilerUnsafeUtility
{
    public struct TimestampConversionRatio
    {
        public long Numerator;
        public long Denominator;
    }

    public static long Timestamp => SimulatedWorkers.IsOn ? SimulatedWorkers.Ticks : SimulatedLatency.Now;

    public static TimestampConversionRatio TimestampToNanosecondsConversionRatio => new TimestampConversionRatio
    {
        Numerator = 1000000000,
        Denominator = Stopwatch.Frequency,
    };
}
