namespace FastPoints.Gpu
{
    /// <summary>A node of a <see cref="SizeTree"/> while a <see cref="BuildSizeTreeJob"/> works.</summary>
    public unsafe struct SizeTreeLink
    {
        /// <summary>By octant: the link below; 0 for none, as no link is below the first.</summary>
        public fixed int Children[8];

        /// <summary>Between points, in world units.</summary>
        public float Gap;

        /// <summary>Stands for a node that is drawn, and not only for a level between two of these.</summary>
        public bool IsDrawn;

        /// <summary>Nothing is above it.</summary>
        public bool IsRoot;

        /// <summary>Its place in the tree.</summary>
        public int Node;
    }
}
