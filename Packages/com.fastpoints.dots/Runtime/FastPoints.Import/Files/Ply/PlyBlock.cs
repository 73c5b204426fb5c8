namespace FastPoints.Files
{
    /// <summary>A stretch of a PLY file with the vertices that start in it, where these have no fixed length.</summary>
    struct PlyBlock
    {
        public long OffsetBytes;
        public int Bytes;

        /// <summary>Index, over the whole file, of the first vertex.</summary>
        public long FirstPoint;
        public int Points;

        /// <summary>ascii: lines of the block that belong to elements before the vertices.</summary>
        public int RowsBefore;

        /// <summary>ascii: whether the block starts within a line that belongs to an earlier block.</summary>
        public bool StartsInRow;
    }
}
