namespace FastPoints.Streaming
{
    /// <summary>One plane of one node in a read.</summary>
    public struct FetchPart
    {
        public long OffsetBytes;
        public long LengthBytes;

        /// <summary>Place among the read's nodes.</summary>
        public int Node;

        /// <summary>Counted among the planes that are streamed.</summary>
        public int Plane;
    }
}
