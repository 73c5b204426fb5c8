namespace FastPoints.Streaming
{
    /// <summary>A node in a read; whether it is still wanted, its slot says.</summary>
    public struct FetchedNode
    {
        public int Node;
        public int Slot;
        public int Version;
    }
}
