using FastPoints.Points;

namespace FastPoints.Samplers
{
    /// <summary>A point that was taken, in the hash grid that keeps others away from it. Blittable.</summary>
    public struct PoissonSample
    {
        /// <summary>In grid steps from the corner.</summary>
        public Grid3 Place;
        public int Point;

        /// <summary>The next sample of the same slot, or -1.</summary>
        public int Next;
    }
}
