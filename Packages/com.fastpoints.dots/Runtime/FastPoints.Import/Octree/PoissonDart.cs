namespace FastPoints.Octree
{
    /// <summary>A point to try, and where it is, so that the darts are read one after the other. Blittable.</summary>
    public struct PoissonDart
    {
        /// <summary>In grid steps from the corner; not set where those need more bits.</summary>
        public uint X;
        public uint Y;
        public uint Z;
        public int Point;
    }
}
