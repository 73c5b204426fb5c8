namespace FastPoints.Octree
{
    /// <summary>Where a file's sampled points of one level lie among all of its sampled points. Blittable.</summary>
    public struct SampledRun
    {
        public int First;
        public int Count;

        /// <summary>Counted from the root.</summary>
        public int Level;

        /// <summary>Points nearer than this to the file's cube's sides may have neighbours beyond them; CRS units.</summary>
        public double Spacing;

        /// <summary>Nodes of the upper levels that chunks hang on.</summary>
        public bool HasChunks;

        /// <summary>Out: the smallest distance between two of the points, in CRS units.</summary>
        public double MinDistance;
    }
}
