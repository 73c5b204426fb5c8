namespace FastPoints.Streaming
{
    /// <summary>Limits of a selection. Blittable, for jobs.</summary>
    public struct LodSettings
    {
        /// <summary>The point budget of all clouds together. The first root is chosen however many points it has.</summary>
        public long PointBudget;

        /// <summary>A node is left out if the points above it lie closer than this on the screen: it would add nothing
        /// visible.</summary>
        public float MinScreenErrorPx;

        /// <summary>A node is left out if its box is smaller than this on the screen.</summary>
        public float SmallestNodePx;

        /// <summary>Nodes chosen last time count as this many times as coarse, so that nodes at the edge of the budget do not
        /// flicker with every small movement. 1 turns this off.</summary>
        public float Hysteresis;

        public static LodSettings Default => new LodSettings
        {
            PointBudget = 2_000_000,
            MinScreenErrorPx = 0.4f,
            SmallestNodePx = 1,
            Hysteresis = 1.15f,
        };
    }
}
