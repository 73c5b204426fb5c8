using System;

namespace FastPoints.Preview
{
    /// <summary>How a sample of short runs is read, by what a source's first reads took.</summary>
    /// <remarks>
    /// Where reads take long, as from a network or a disk that has to seek, fewer and longer runs are another sample of as many
    /// points, and a coarser one: there are these two plans and no others, so that the sample is the same wherever the same one
    /// was taken.
    /// </remarks>
    internal readonly struct ReadPace
    {
        /// <summary>Reads that are tried first, of which the quickest counts: anything may keep the others waiting.</summary>
        public const int Tries = 4;

        /// <summary>Of a read that is slow: a seek of a disk takes four times as long, a solid state disk a tenth.</summary>
        const double SlowSeconds = 0.002;

        /// <summary>A smaller source is soon read as a whole.</summary>
        const long LeastSlowBytes = 64L << 20;

        const int PointsPerShortRun = 16, PointsPerLongRun = 128;

        /// <summary>Requests in flight: enough for a solid state disk to work at depth, and so that slow ones take as long as
        /// one.</summary>
        const int UsualSlots = 8, SlowSlots = 16;

        /// <summary>What a slow disk reads in a second once it is there: a gap that takes less time than another read is
        /// read.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10, MaxSlowGapBytes = 1 << 20;

        public readonly bool IsSlow;

        ReadPace(bool isSlow)
        {
            IsSlow = isSlow;
        }

        /// <param name="quickestSeconds">Of the first reads.</param>
        /// <param name="bytes">Of the source's records.</param>
        public static ReadPace Of(double quickestSeconds, long bytes) =>
            new ReadPace(quickestSeconds >= SlowSeconds && bytes >= LeastSlowBytes);

        public int PointsPerRun => IsSlow ? PointsPerLongRun : PointsPerShortRun;

        public int Slots => IsSlow ? SlowSlots : UsualSlots;

        /// <summary>Runs of one request, where there are so many in all: slow ones must not wait for each other.</summary>
        public int RunsPerRequest(int runs, int slots, int least, int most) =>
            Math.Max(IsSlow ? 1 : least, Math.Min(most, runs / (2 * slots)));

        /// <summary>Gaps that are read along.</summary>
        /// <param name="secondsPerRead">What reads that lie far apart take, several in flight.</param>
        public int GapBytes(double secondsPerRead) => (int)Math.Max(MinGapBytes,
            Math.Min(IsSlow ? MaxSlowGapBytes : MaxGapBytes, secondsPerRead * BytesPerSecondOfGaps));
    }
}
