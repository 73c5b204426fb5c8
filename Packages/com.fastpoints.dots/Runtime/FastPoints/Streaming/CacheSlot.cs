namespace FastPoints.Streaming
{
    /// <summary>A node that has memory in the pool.</summary>
    public struct CacheSlot
    {
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

        /// <summary>Neighbours in the order of use.</summary>
        public int LessUseful;
        public int MoreUseful;
    }
}
