using System;
using FastPoints.Reading;

namespace FastPoints.Sampling
{
    /// <summary>Plans which points a sample takes from a source of fixed stride, and in which order: a run of evenly spaced
    /// points at a hashed place in each of equal strata of the file, the strata in an order of which every beginning is spread
    /// over all of the file. Blittable, for jobs.</summary>
    /// <remarks>Within a stratum each point is taken with the same probability, its share of taken points: runs that leave it
    /// continue at its start. Strata differ by one point in length, runs by one point in count; so a sample of nearly all points
    /// may lack one point in each run, and the places of a sample of all points have gaps.</remarks>
    internal readonly struct RunPlan
    {
        /// <summary>Points of a usual run: reading a page of the file costs the same for one wanted point as for
        /// sixteen.</summary>
        const int PointsPerDefaultRun = 16;

        /// <summary>Bytes of the file that a usual run spans, if its stratum has as many: about two pages. Longer runs span
        /// proportionally more.</summary>
        const int SpanBytes = 4096;

        const int MaxSpanPoints = 256;

        readonly SampleStrata m_strata;
        readonly SampleStrata m_places;
        readonly int m_spanPoints;

        public readonly SampleOrder Order;

        /// <param name="points">Points of the source.</param>
        public RunPlan(long points, int wanted, int recordBytes, uint seed, int pointsPerRun = PointsPerDefaultRun)
        {
            wanted = (int)Math.Min(points, Math.Max(0, wanted));
            int times = Math.Max(1, pointsPerRun / PointsPerDefaultRun);
            m_spanPoints = Math.Max(pointsPerRun, Math.Min(MaxSpanPoints, SpanBytes / Math.Max(1, recordBytes)) * times);
            long runs = Math.Min((wanted + pointsPerRun - 1L) / pointsPerRun, Math.Max(1, points / m_spanPoints));
            m_strata = new SampleStrata(points, (int)runs, seed);
            // With all points, the longest stratum's must find room wherever it comes in the order.
            m_places = new SampleStrata(wanted == points ? wanted + runs : wanted, (int)runs, seed);
            Order = new SampleOrder((int)runs, seed);
        }

        public int RunCount => m_strata.Count;

        /// <summary>Number of places in the sample: as many as its points, or a few more.</summary>
        public int PlaceCount => (int)m_places.Points;

        /// <summary>Points of the longest run's segment of the file.</summary>
        public int MaxSegmentPoints => RunCount == 0 ? 0 : (int)Math.Min(2 * m_spanPoints, m_strata.Points);

        /// <summary>First place in the sample of the run with this rank in the order; <see cref="PlaceCount"/> for the one after
        /// the last.</summary>
        public int PlaceOf(int rank) => (int)m_places.FirstOf(rank);

        /// <summary>Number of runs, from the first in the order, that give this many points.</summary>
        public int RunsFor(int points) => points >= PlaceCount ? RunCount : m_places.StratumOf(points - 1) + 1;

        int PointsOf(int stratum, int rank) => (int)Math.Min(PlaceOf(rank + 1) - PlaceOf(rank),
            m_strata.FirstOf(stratum + 1) - m_strata.FirstOf(stratum));

        /// <summary>The run of a stratum in the file's order: one segment, or two if it wraps around at its stratum's
        /// end.</summary>
        /// <param name="rank">The stratum's place among the runs.</param>
        /// <returns>Whether there is a second one.</returns>
        public bool RunOf(int stratum, int rank, out PointRun run, out PointRun second)
        {
            long first = m_strata.FirstOf(stratum);
            long length = m_strata.FirstOf(stratum + 1) - first;
            int place = PlaceOf(rank);
            int count = PointsOf(stratum, rank);
            // A stratum that is not much longer than the span is covered from end to end.
            long span = length <= 2 * m_spanPoints ? length : m_spanPoints;
            int step = (int)(span / count);
            long begin = m_strata.ChosenRun(stratum, 1) - first;
            run = new PointRun { First = first + begin, Step = step, Count = count, Place = place };
            second = default;
            int before = (int)((length - begin + step - 1) / step);
            if (before >= count)
                return false;
            second = run;
            second.Count = before;
            run.First = first + (begin + (long)before * step) % length;
            run.Count = count - before;
            run.Place = place + before;
            return true;
        }
    }
}
