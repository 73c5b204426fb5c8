namespace FastPoints.Verify
{
    /// <summary>Where a file's points of one level that were sampled together lie among all of its sampled points.
    /// Blittable.</summary>
    public struct SampledRun
    {
        public int First;
        public int Count;

        /// <summary>Counted from the root.</summary>
        public int Level;

        /// <summary>Points nearer than this to the file's cube's sides may have neighbours beyond them; CRS units.</summary>
        public double Spacing;

        /// <summary>What upper levels left of the tops of others: not sampled together.</summary>
        public bool IsTop;

        /// <summary>Out: the smallest distance between two of the points, in CRS units.</summary>
        public double MinDistance;
    }
}
