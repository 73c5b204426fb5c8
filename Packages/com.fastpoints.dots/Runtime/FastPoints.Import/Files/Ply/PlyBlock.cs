namespace FastPoints.Files
{
    /// <summary>A stretch of a PLY file with the vertices that start in it, where these have no fixed length.</summary>
    struct PlyBlock
    {
        public long OffsetBytes;
        public int Bytes;

        /// <summary>Index of the first vertex in the whole file.</summary>
        public long FirstPoint;
        public int Points;

        /// <summary>For ascii: lines of the block that belong to elements before the vertices.</summary>
        public int RowsBefore;

        /// <summary>For ascii: whether the block starts within a line that belongs to an earlier block.</summary>
        public bool StartsInRow;
    }
}
