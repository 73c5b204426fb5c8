namespace FastPoints.Files
{
    /// <summary>How far a walk through packets has come in one bytestream.</summary>
    struct E57StreamWalk
    {
        /// <summary>Of one value.</summary>
        public int Bits;

        /// <summary>Bytes in the packets so far.</summary>
        public long Bytes;

        /// <summary>Bytes that all records take; 0 for a stream that need not be followed.</summary>
        public long BytesWanted;

        /// <summary>Bytes from mark to mark, and where the next one is due.</summary>
        public long MarkStep;
        public long NextMark;

        /// <summary>Logical offset behind the packet with the last byte wanted; 0 while it has not come.</summary>
        public long EndOffset;
    }
}
