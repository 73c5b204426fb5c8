using System;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints
{
    // How many pieces of work are in flight, so that workers have some until the next tick of a coroutine: at first as many as
    // quick ones would take, then twice as many each time that they ran out of them. What is made never depends on it.
    internal sealed class InFlightLimit
    {
        const double MinMs = 2; // After a shorter wait more in flight would not have been of use.

        readonly Func<double> m_ms;
        long m_begun;

        // A tick that comes later than ms after the last one does not count: the machine was busy, or the work was paused.
        public InFlightLimit(int first, int max, Func<double> ms)
        {
            m_ms = ms;
            Max = Math.Max(1, max);
            Value = Math.Max(1, Math.Min(first, max));
        }

        public int Value { get; private set; }
        public int Max { get; }

        // Pieces of at least pieceMs that this many chains do in a time, and at least what a coroutine needs.
        public static int ValueFor(int min, double ms, int chains, double pieceMs) =>
            (int)Math.Max(min, Math.Min(int.MaxValue, Math.Ceiling(ms * chains / pieceMs)));

        public void BeginWait() => m_begun = ProfilerUnsafeUtility.Timestamp;

        public void EndWait(bool isIdle)
        {
            var ratio = ProfilerUnsafeUtility.TimestampToNanosecondsConversionRatio;
            double waited = (ProfilerUnsafeUtility.Timestamp - m_begun) * (ratio.Numerator * 1e-6 / ratio.Denominator);
            if (isIdle && waited >= MinMs && waited <= m_ms())
                Value = Math.Min(Max, 2 * Value);
        }
    }
}
