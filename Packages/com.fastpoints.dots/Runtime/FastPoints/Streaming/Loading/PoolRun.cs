namespace FastPoints.Streaming
{
    /// <summary>A piece of a <see cref="NodePool"/>: pages that follow one another in one bank.</summary>
    public struct PoolRun
    {
        public int Bank;
        public int FirstPage;
        public int PageCount;

        public bool IsNone => PageCount == 0;
    }
}
