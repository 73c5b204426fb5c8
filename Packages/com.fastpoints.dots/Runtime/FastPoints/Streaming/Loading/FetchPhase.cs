namespace FastPoints.Streaming
{
    /// <summary>How far a read is.</summary>
    public enum FetchPhase : byte
    {
        Idle,
        Reading,
        /// <summary>A job makes a page of the table that was read.</summary>
        Building,
        /// <summary>A node is read and made: <see cref="NodeMaker"/>.</summary>
        Making,
        /// <summary>Its nodes wait to be copied into the pool, or are being copied.</summary>
        Arrived,
    }
}
