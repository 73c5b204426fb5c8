namespace FastPoints.Streaming
{
    public enum PageStatus : byte
    {
        Absent,
        /// <summary>Its table is being read.</summary>
        Loading,
        Loaded,
        /// <summary>It could not be read, was reported, and is a hole.</summary>
        Failed,
    }
}
