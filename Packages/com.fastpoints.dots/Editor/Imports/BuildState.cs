namespace FastPoints.Editor
{
    /// <summary>Where a <see cref="BuildSession"/> stands.</summary>
    public enum BuildState
    {
        /// <summary>The sources' headers are being read.</summary>
        Opening,
        Building,
        Paused,
        Done,
        Failed,
        /// <summary>Ended before its end; nothing is left of it.</summary>
        Cancelled,
        /// <summary>Ended before its end; what lies on disk is continued by the next session of the same target.</summary>
        Suspended,
    }
}
