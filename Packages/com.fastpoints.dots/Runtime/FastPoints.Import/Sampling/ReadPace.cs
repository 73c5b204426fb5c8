using System;

namespace FastPoints.Sampling
{
    /// <summary>Chooses how a sample of short runs is read, by the time of a source's first reads.</summary>
    /// <remarks>If reads take long, as from a network or a disk that has to seek, fewer and longer runs make another, coarser
    /// sample of as many points. There are only these two plans, so that the sample is the same wherever the same plan was
    /// chosen.</remarks>
    internal readonly struct ReadPace
    {
        /// <summary>Number of trial reads, of which the quickest counts: anything may delay the others.</summary>
        public const int TrialReads = 4;

        /// <summary>Duration of a slow read: a seek of a disk takes four times as long, a solid state disk a tenth.</summary>
        const double SlowSeconds = 0.002;

        /// <summary>A smaller source is quickly read as a whole.</summary>
        const long MinSlowBytes = 64L << 20;

        const int PointsPerShortRun = 16, PointsPerLongRun = 128;

        /// <summary>Requests in flight: enough to keep a worker busy from frame to frame, and so that slow ones take as long
        /// as one.</summary>
        const int DefaultSlots = 40, SlowSlots = 48;

        /// <summary>Bytes that a slow disk reads in a second after seeking: a gap that takes less time than another read is read
        /// along.</summary>
        const double BytesPerSecondOfGaps = 200e6;

        const int MinGapBytes = 512, MaxGapBytes = 256 << 10, MaxSlowGapBytes = 1 << 20;

        public readonly bool IsSlow;

        ReadPace(bool isSlow) => IsSlow = isSlow;

        /// <param name="quickestSeconds">The quickest of the first reads.</param>
        /// <param name="bytes">Bytes of the source's records.</param>
        public static ReadPace Of(double quickestSeconds, long bytes) =>
            new ReadPace(quickestSeconds >= SlowSeconds && bytes >= MinSlowBytes);

        public int PointsPerRun => IsSlow ? PointsPerLongRun : PointsPerShortRun;

        public int Slots => IsSlow ? SlowSlots : DefaultSlots;

        /// <summary>Number of runs in one request, if there are so many in all: so few that all are in flight at once, and half
        /// as many where they are slow, since slow requests must not wait for each other.</summary>
        public int RunsPerRequest(int runs, int slots, int min, int max) =>
            Math.Max(IsSlow ? 1 : min, Math.Min(max, IsSlow ? runs / (2 * slots) : (runs + slots - 1) / slots));

        /// <summary>The largest gap that is read along.</summary>
        /// <param name="secondsPerRead">The time of reads that lie far apart, with several in flight.</param>
        public int GapBytes(double secondsPerRead) => (int)Math.Max(MinGapBytes,
            Math.Min(IsSlow ? MaxSlowGapBytes : MaxGapBytes, secondsPerRead * BytesPerSecondOfGaps));
    }
}
