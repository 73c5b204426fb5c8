using System;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Plans which points a sample takes from a source of fixed stride, and in which order: a range of evenly spaced
    /// points at a hashed position in each of equal strata of the file, the strata in an order whose every prefix is spread
    /// over all of the file. Blittable, for jobs.</summary>
    /// <remarks>Within a stratum each point is taken with the same probability, its share of taken points: ranges that
    /// leave it continue at its start. Strata differ by one point in length, ranges by one point in count; so a sample
    /// of nearly all points may lack one point in each range, and the entries of a sample of all points have
    /// gaps.</remarks>
    internal readonly struct RangePlan
    {
        /// <summary>Points of a usual range: reading a page of the file costs the same for one wanted point as for
        /// sixteen.</summary>
        const int PointsPerDefaultRange = 16;

        /// <summary>Bytes of the file that a usual range spans, if its stratum has as many: about two pages. Longer ranges span
        /// proportionally more.</summary>
        const int SpanBytes = 4096;

        const int MaxSpanPoints = 256;
        const int RemoteRanges = 320; // At least, of a remote file if a sample is large: as many requests.

        readonly SampleStrata m_strata;
        readonly SampleStrata m_entries;
        readonly int m_spanPoints;

        public readonly SampleOrder Order;

        public RangePlan(long points, int wanted, int recordBytes, uint seed, int pointsPerRange = PointsPerDefaultRange)
            : this(points, wanted, seed, pointsPerRange, Math.Max(pointsPerRange, Math.Min(MaxSpanPoints, SpanBytes
                / Math.Max(1, recordBytes)) * Math.Max(1, pointsPerRange / PointsPerDefaultRange)))
        {
        }

        /// <summary>For files of which each range costs a request: few, whose points follow each other.</summary>
        public static RangePlan OfRemote(long points, int wanted, uint seed)
        {
            int pointsPerRange = Math.Max(PointsPerDefaultRange, wanted / RemoteRanges);
            return new RangePlan(points, wanted, seed, pointsPerRange, pointsPerRange);
        }

        RangePlan(long points, int wanted, uint seed, int pointsPerRange, int spanPoints)
        {
            wanted = (int)Math.Min(points, Math.Max(0, wanted));
            m_spanPoints = spanPoints;
            long ranges = Math.Min((wanted + pointsPerRange - 1L) / pointsPerRange, Math.Max(1, points / m_spanPoints));
            m_strata = new SampleStrata(points, (int)ranges, seed);
            // With all points, the longest stratum must fit at any rank.
            m_entries = new SampleStrata(wanted == points ? wanted + ranges : wanted, (int)ranges, seed);
            Order = new SampleOrder((int)ranges, seed);
        }

        public int RangeCount => m_strata.Count;
        public int EntryCount => (int)m_entries.Points; // Number of entries in the sample: as many as its points, or a few more.

        public int MaxSegmentPoints => RangeCount == 0 ? 0 : (int)Math.Min(2 * m_spanPoints, m_strata.Points);

        /// <summary>First entry in the sample of the range with this rank in the order; <see cref="EntryCount"/> for the one
        /// after the last.</summary>
        public int FirstEntryOf(int rank) => (int)m_entries.FirstOf(rank);

        /// <summary>Number of ranges, from the first in the order, that give this many points.</summary>
        public int RangesFor(int points) => points >= EntryCount ? RangeCount : m_entries.StratumOf(points - 1) + 1;

        int PointsOf(int stratum, int rank) => (int)Math.Min(FirstEntryOf(rank + 1) - FirstEntryOf(rank),
            m_strata.FirstOf(stratum + 1) - m_strata.FirstOf(stratum));

        /// <summary>The range of a stratum in the file's order: one segment, or two if it wraps around at its stratum's
        /// end.</summary>
        /// <param name="rank">The stratum's position among the ranges.</param>
        /// <returns>Whether there is a second one.</returns>
        public bool RangeOf(int stratum, int rank, out StridedRange range, out StridedRange second)
        {
            long first = m_strata.FirstOf(stratum);
            long length = m_strata.FirstOf(stratum + 1) - first;
            int index = FirstEntryOf(rank);
            int count = PointsOf(stratum, rank);
            // A stratum that is not much longer than the span is covered from end to end.
            long span = length <= 2 * m_spanPoints ? length : m_spanPoints;
            int step = (int)(span / count);
            long begin = m_strata.Chosen(stratum) - first;
            range = new StridedRange { First = first + begin, Step = step, Count = count, FirstInSample = index };
            second = default;
            int before = (int)((length - begin + step - 1) / step);
            if (before >= count)
                return false;
            second = range;
            second.Count = before;
            range.First = first + (begin + (long)before * step) % length;
            range.Count = count - before;
            range.FirstInSample = index + before;
            return true;
        }
    }
}
