using System;
using Unity.Profiling.LowLevel.Unsafe;

namespace FastPoints.Core
{
    /// <summary>How many pieces of work are in flight, so that workers have some until the next tick of a coroutine: at first as
    /// many as quick ones would take, then twice as many each time that they ran out of them. What is made never depends on
    /// it.</summary>
    internal sealed class InFlightLimit
    {
        /// <summary>After a shorter wait more in flight would not have been of use.</summary>
        const double MinMs = 2;

        readonly Func<double> m_ms;
        long m_begun;

        /// <param name="first">Pieces to begin with; see <see cref="ValueFor"/>.</param>
        /// <param name="max">The most that memory has room for.</param>
        /// <param name="ms">A tick that comes later than this after the last one does not count: the machine was busy, or the
        /// work was paused.</param>
        public InFlightLimit(int first, int max, Func<double> ms)
        {
            m_ms = ms;
            Max = Math.Max(1, max);
            Value = Math.Max(1, Math.Min(first, max));
        }

        public int Value { get; private set; }
        public int Max { get; }

        /// <summary>Pieces that so many chains do in a time, and at least those that a coroutine needs which awaits
        /// each.</summary>
        /// <param name="pieceMs">The least that a piece takes.</param>
        public static int ValueFor(int min, double ms, int chains, double pieceMs) =>
            (int)Math.Max(min, Math.Min(int.MaxValue, Math.Ceiling(ms * chains / pieceMs)));

        /// <summary>Call it before a handle is awaited.</summary>
        public void Await() => m_begun = ProfilerUnsafeUtility.Timestamp;

        /// <summary>Call it when the wait is over.</summary>
        /// <param name="isIdle">Whether all that was in flight has ended.</param>
        public void Resume(bool isIdle)
        {
            var ratio = ProfilerUnsafeUtility.TimestampToNanosecondsConversionRatio;
            double waited = (ProfilerUnsafeUtility.Timestamp - m_begun) * (ratio.Numerator * 1e-6 / ratio.Denominator);
            if (isIdle && waited >= MinMs && waited <= m_ms())
                Value = Math.Min(Max, 2 * Value);
        }
    }
}
