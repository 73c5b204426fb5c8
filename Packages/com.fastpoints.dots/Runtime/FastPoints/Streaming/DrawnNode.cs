namespace FastPoints.Streaming
{
    /// <summary>A node to draw: complete, as are all above it.</summary>
    public struct DrawnNode
    {
        public int Cloud;
        public int Page;
        public int Node;

        /// <summary>Place of the node above it among those that are drawn; -1 where that one is not drawn, or there is
        /// none.</summary>
        public int Parent;

        /// <summary>Its place in the <see cref="NodeCache"/>.</summary>
        public int Slot;

        /// <summary>See <see cref="CacheSlot.Tint"/>.</summary>
        public uint Tint;

        /// <summary>Its planes, one after the other in the order of <see cref="NodeSource.Planes"/>.</summary>
        public PoolRun Run;
    }
}
