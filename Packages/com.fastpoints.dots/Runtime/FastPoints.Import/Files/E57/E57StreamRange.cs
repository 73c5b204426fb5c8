namespace FastPoints.Files
{
    /// <summary>Where the bytes of a bytestream that a range takes are to be found. Blittable, for jobs.</summary>
    struct E57StreamRange
    {
        /// <summary>Logical offset of a packet at or before the first byte.</summary>
        public long PacketOffset;

        /// <summary>Bytes of the bytestream in the packets before that.</summary>
        public long BytesBefore;

        /// <summary>Logical offset at which the packets that are read end.</summary>
        public long End;
    }
}
