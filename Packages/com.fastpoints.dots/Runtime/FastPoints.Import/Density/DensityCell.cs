namespace FastPoints.Density
{
    /// <summary>How many points of a cloud lie in a cell, as far as a sample tells.</summary>
    public readonly struct DensityCell
    {
        /// <summary>Estimate; 0 also where nothing is known.</summary>
        public readonly double Points;

        /// <summary>Of <see cref="Points"/>, in points; NaN where nothing is known.</summary>
        public readonly double StandardError;

        /// <summary>Stretches of the file that have sampled points here.</summary>
        public readonly int Stretches;

        public DensityCell(double points, double standardError, int stretches)
        {
            Points = points;
            StandardError = standardError;
            Stretches = stretches;
        }

        /// <summary>False where no sampled point lies: there may be none, or some that no stretch came to.</summary>
        public bool IsKnown => Stretches > 0;
    }
}
