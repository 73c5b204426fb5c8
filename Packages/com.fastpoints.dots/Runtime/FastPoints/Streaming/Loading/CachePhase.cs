namespace FastPoints.Streaming
{
    /// <summary>How far a node in the cache is.</summary>
    public enum CachePhase : byte
    {
        Free,
        /// <summary>Its bytes are on their way, or wait for their turn to be copied.</summary>
        Requested,
        /// <summary>A job writes to its memory.</summary>
        Uploading,
        /// <summary>Complete: it can be drawn.</summary>
        Resident,
    }
}
