using System;

namespace FastPoints.Editor
{
    /// <summary>How much main-thread time background work gets in an update of the editor. Without focus updates are rare and
    /// unseen: slices grow, so that the share of the time stays what it is at 60 updates a second.</summary>
    internal sealed class EditorTimeBudget
    {
        const double FocusedMs = 1000.0 / 60;

        /// <summary>The next slice is a share of an interval that contains this one: below 1, slices cannot grow
        /// without bound.</summary>
        const double MaxShare = 0.5;
        const double MaxMs = 250;
        const double MinInFlightMs = 250;
        const double MaxInFlightMs = 1000;

        DateTime m_before;

        /// <summary>The longest interval between updates for which jobs are scheduled.</summary>
        public double InFlightMs { get; private set; } = MinInFlightMs;

        /// <summary>Call it once an update.</summary>
        /// <param name="updateMs">What an update gets while the editor has the focus.</param>
        /// <returns>What this one gets.</returns>
        public double Next(DateTime nowUtc, double updateMs, bool isFocused)
        {
            double intervalMs = m_before == default ? 0 : Math.Max(0, (nowUtc - m_before).TotalMilliseconds);
            m_before = nowUtc;
            InFlightMs = Math.Max(MinInFlightMs, Math.Min(MaxInFlightMs, 2 * intervalMs));
            return isFocused ? updateMs
                : Math.Max(updateMs, Math.Min(MaxMs, intervalMs * Math.Min(MaxShare, updateMs / FocusedMs)));
        }
    }
}
