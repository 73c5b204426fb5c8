using System;

namespace FastPoints.Streaming
{
    /// <summary>One plane of one node in a read.</summary>
    public struct FetchPart : IComparable<FetchPart>
    {
        public long OffsetBytes;
        public long LengthBytes;

        /// <summary>Place among the read's nodes.</summary>
        public int Node;

        /// <summary>Counted among the planes that are streamed.</summary>
        public int Plane;

        public int CompareTo(FetchPart other) => OffsetBytes.CompareTo(other.OffsetBytes);
    }
}
