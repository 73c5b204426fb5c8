namespace FastPoints.Files
{
    /// <summary>A block of a LAZ file: a chunk, or a part of one that is too long.</summary>
    struct LazBlock
    {
        public int Chunk;

        /// <summary>First point, counted from the chunk's start.</summary>
        public long FirstInChunk;

        /// <summary>First point over the whole source.</summary>
        public long FirstPoint;

        public int Points;

        /// <summary>Where its last point ends in the file: the chunk's end but for parts of one.</summary>
        public long EndOffset;

        /// <summary>Whether it takes the chunk to its end.</summary>
        public bool IsToEnd;

        /// <summary>Index of the checkpoint from which it is decoded, or -1 for the chunk's start.</summary>
        public int Checkpoint;
    }
}
