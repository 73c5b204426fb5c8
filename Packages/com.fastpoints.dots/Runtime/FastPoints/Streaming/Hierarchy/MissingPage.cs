namespace FastPoints.Streaming
{
    /// <summary>A page that a selection came to and found not loaded.</summary>
    public struct MissingPage
    {
        public int Cloud;
        public int Page;
    }
}
