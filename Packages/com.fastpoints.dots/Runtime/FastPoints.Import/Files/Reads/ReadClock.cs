using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints.Files
{
    /// <summary>The clock that says how long reads take: one that jobs can look at, since the pump sees a finished read only in
    /// its next update.</summary>
    static class ReadClock
    {
        public static long Now => ProfilerUnsafeUtility.Timestamp;

        public static double Seconds(long from, long to)
        {
            var ratio = ProfilerUnsafeUtility.TimestampToNanosecondsConversionRatio;
            return (to - from) * (double)ratio.Numerator / ratio.Denominator * 1e-9;
        }
    }
}
