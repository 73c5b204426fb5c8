namespace FastPoints.Streaming
{
    /// <summary>How the making of a node ended.</summary>
    public enum MakeOutcome : byte
    {
        Made,
        /// <summary>The node's bytes are not what they should be, or are not there.</summary>
        Damaged,
        /// <summary>The file that holds other nodes too cannot be read.</summary>
        Unreadable,
    }
}
