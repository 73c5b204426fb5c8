namespace FastPoints.Streaming
{
    /// <summary>What a selection may choose. Blittable, for jobs.</summary>
    public struct SelectionSettings
    {
        /// <summary>Points of all clouds together. The first root is chosen whatever it has.</summary>
        public long PointBudget;

        /// <summary>A node is left out where the points above it lie closer than this on the screen: it would add nothing to
        /// see.</summary>
        public float FinestSpacingPx;

        /// <summary>A node is left out where its box is smaller than this on the screen.</summary>
        public float SmallestNodePx;

        /// <summary>What was chosen the last time counts as so many times as coarse: nodes at the edge of the budget do not come
        /// and go with every small movement. 1 for none.</summary>
        public float Hysteresis;

        public static SelectionSettings Default => new SelectionSettings
        {
            PointBudget = 2_000_000,
            FinestSpacingPx = 0.4f,
            SmallestNodePx = 1,
            Hysteresis = 1.15f,
        };
    }
}
