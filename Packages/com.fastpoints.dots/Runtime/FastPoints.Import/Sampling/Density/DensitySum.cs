using System;

namespace FastPoints.Sampling
{
    /// <summary>Sums over the stretches of a sample, one after the other in the file's order, for one cell. Blittable.</summary>
    internal struct DensitySum
    {
        public double Points;
        public double SquaresOfDifferences;

        /// <summary>Points of the stretch that is being counted.</summary>
        public double InStretch;

        /// <summary>Points of <see cref="LastStretch"/>, the last one that has points here.</summary>
        public double InLast;
        public int LastStretch;
        public int Stretches;

        /// <summary>Adds <see cref="InStretch"/> when its stretch is counted; stretches without points in the cell may be
        /// skipped.</summary>
        public void Close(int stretch)
        {
            if (Stretches > 0 && LastStretch == stretch - 1)
            {
                SquaresOfDifferences += (InStretch - InLast) * (InStretch - InLast);
            }
            else
            {
                SquaresOfDifferences += stretch > 0 ? InStretch * InStretch : 0;
                SquaresOfDifferences += InLast * InLast;
            }
            Points += InStretch;
            InLast = InStretch;
            InStretch = 0;
            LastStretch = stretch;
            Stretches++;
        }

        /// <summary>The estimate after all are counted.</summary>
        /// <param name="stretches">Number of stretches in the sample, with or without points here.</param>
        /// <param name="share">The sampled share of the file's points.</param>
        /// <remarks>Points of one stretch are neighbours in space as well: they say hardly more than one of them would, and a
        /// binomial error would be far too small. Each part of the file has one stretch, so the variance is estimated by the
        /// differences of neighbouring ones (Wolter, "Introduction to variance estimation", 2007, 8.2), with the correction for a
        /// finite population.</remarks>
        public DensityCell ToCell(int stretches, double share)
        {
            if (Stretches == 0)
                return new DensityCell(0, double.NaN, 0);
            double left = Math.Max(0, 1 - share);
            if (stretches < 2)
                return new DensityCell(Points, left > 0 ? Points : 0, Stretches);
            double squares = SquaresOfDifferences + (LastStretch < stretches - 1 ? InLast * InLast : 0);
            return new DensityCell(Points, Math.Sqrt(left * squares * stretches / (2.0 * (stretches - 1))), Stretches);
        }
    }

    /// <summary>How many points of a cloud lie in a cell, as far as a sample shows.</summary>
    internal readonly struct DensityCell
    {
        /// <summary>The estimate; also 0 if nothing is known.</summary>
        public readonly double Points;

        /// <summary>Error of <see cref="Points"/>, in points; NaN if nothing is known.</summary>
        public readonly double StandardError;

        /// <summary>Stretches of the file that have sampled points here.</summary>
        public readonly int Stretches;

        public DensityCell(double points, double standardError, int stretches)
        {
            Points = points;
            StandardError = standardError;
            Stretches = stretches;
        }

        /// <summary>False if no sampled point lies here: there may be none, or some that no stretch reached.</summary>
        public bool IsKnown => Stretches > 0;
    }
}
