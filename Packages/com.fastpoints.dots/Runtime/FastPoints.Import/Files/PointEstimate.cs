namespace FastPoints.Files
{
    /// <summary>How many points there are, as far as a sample tells.</summary>
    public readonly struct PointEstimate
    {
        public readonly double Points;

        /// <summary>0 where they were counted, or the source says so.</summary>
        public readonly double StandardError;

        public PointEstimate(double points, double standardError)
        {
            Points = points;
            StandardError = standardError;
        }
    }
}
