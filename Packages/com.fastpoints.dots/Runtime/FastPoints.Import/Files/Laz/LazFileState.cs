namespace FastPoints.Files
{
    /// <summary>How far a whole LAZ file in memory has been decoded, from slice to slice.</summary>
    struct LazFileState
    {
        /// <summary>Points by its header.</summary>
        public long PointsInFile;

        /// <summary>Of every chunk but the last; 0 where chunks say so themselves.</summary>
        public long PointsOfChunks;

        /// <summary>Byte at which the chunk in work starts.</summary>
        public long ChunkOffset;

        /// <summary>Byte behind it; known beforehand of layered chunks only.</summary>
        public long ChunkEnd;

        /// <summary>Points of the chunk in work, and those that are done; both 0 before a chunk is started.</summary>
        public long ChunkPoints;
        public long ChunkDone;

        /// <summary>Behind the last chunk's last byte.</summary>
        public long End;

        public LazFilePlacing Placing;
    }
}
