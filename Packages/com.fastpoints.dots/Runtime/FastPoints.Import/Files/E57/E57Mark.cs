namespace FastPoints.Files
{
    /// <summary>
    /// The packet in which one bytestream comes to a multiple of so many records: where reading can start.
    /// </summary>
    struct E57Mark
    {
        public int Stream;

        /// <summary>Bytes of the packet.</summary>
        public int PacketBytes;

        /// <summary>Logical offset of the packet.</summary>
        public long PacketOffset;

        /// <summary>Bytes of the bytestream in the packets before it.</summary>
        public long BytesBefore;
    }
}
