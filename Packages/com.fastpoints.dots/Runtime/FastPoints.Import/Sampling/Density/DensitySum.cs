using System;

namespace FastPoints.Sampling
{
    /// <summary>Sums over the segments of a sample, one after the other in the file's order, for one cell. Blittable.</summary>
    internal struct DensitySum
    {
        public double Points;
        public double SquaresOfDifferences;

        /// <summary>Points of the segment that is being counted.</summary>
        public double InSegment;

        /// <summary>Points of <see cref="LastSegment"/>, the last one that has points here.</summary>
        public double InLast;
        public int LastSegment;
        public int Segments;

        /// <summary>Adds <see cref="InSegment"/> when its segment is counted; segments without points in the cell may be
        /// skipped.</summary>
        public void Close(int segment)
        {
            if (Segments > 0 && LastSegment == segment - 1)
            {
                SquaresOfDifferences += (InSegment - InLast) * (InSegment - InLast);
            }
            else
            {
                SquaresOfDifferences += segment > 0 ? InSegment * InSegment : 0;
                SquaresOfDifferences += InLast * InLast;
            }
            Points += InSegment;
            InLast = InSegment;
            InSegment = 0;
            LastSegment = segment;
            Segments++;
        }

        /// <summary>The estimate after all are counted.</summary>
        /// <param name="segments">Number of segments in the sample, with or without points here.</param>
        /// <param name="share">The sampled share of the file's points.</param>
        /// <remarks>Points of one segment are neighbours in space as well: they say hardly more than one of them would, and a
        /// binomial error would be far too small. Each part of the file has one segment, so the variance is estimated by the
        /// differences of neighbouring ones (Wolter, "Introduction to variance estimation", 2007, 8.2), with the correction for a
        /// finite population.</remarks>
        public DensityCell ToCell(int segments, double share)
        {
            if (Segments == 0)
                return new DensityCell(0, double.NaN, 0);
            double left = Math.Max(0, 1 - share);
            if (segments < 2)
                return new DensityCell(Points, left > 0 ? Points : 0, Segments);
            double squares = SquaresOfDifferences + (LastSegment < segments - 1 ? InLast * InLast : 0);
            return new DensityCell(Points, Math.Sqrt(left * squares * segments / (2.0 * (segments - 1))), Segments);
        }
    }

    /// <summary>How many points of a cloud lie in a cell, as far as a sample shows.</summary>
    internal readonly struct DensityCell
    {
        /// <summary>The estimate; also 0 if nothing is known.</summary>
        public readonly double Points;

        /// <summary>Error of <see cref="Points"/>, in points; NaN if nothing is known.</summary>
        public readonly double StandardError;

        /// <summary>Segments of the file that have sampled points here.</summary>
        public readonly int Segments;

        public DensityCell(double points, double standardError, int segments)
        {
            Points = points;
            StandardError = standardError;
            Segments = segments;
        }

        /// <summary>False if no sampled point lies here: there may be none, or some that no segment reached.</summary>
        public bool IsKnown => Segments > 0;
    }
}
