namespace FastPoints.Streaming
{
    /// <summary>A node that has memory in the pool.</summary>
    public struct CacheSlot
    {
        public const uint White = 0xFFFFFFFF;

        public int Cloud;
        public int Page;
        public int Node;
        public PoolRun Run;
        public CachePhase Phase;

        /// <summary>Whoever remembers a slot by its number remembers this as well: it rises when the slot is given up.</summary>
        public int Version;

        /// <summary>Frame of the last selection or forecast that wanted it, and its place there: 0 is the most needed.</summary>
        public uint UsedFrame;
        public int Rank;

        /// <summary>Not drawn, though it may be there.</summary>
        public bool IsHidden;

        /// <summary>Not given up while there is memory for it at all.</summary>
        public bool IsPinned;

        /// <summary>Its points' colours are multiplied by this: sRGB, red, green, blue, alpha from the lowest byte; white leaves
        /// them.</summary>
        public uint Tint;

        /// <summary>Neighbours in the order of use.</summary>
        public int LessUseful;
        public int MoreUseful;
    }
}
