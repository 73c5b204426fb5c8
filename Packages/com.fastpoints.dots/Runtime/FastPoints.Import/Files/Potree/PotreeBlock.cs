namespace FastPoints.Files
{
    /// <summary>A block of a Potree cloud: the points of a node, or a part of one that is too long.</summary>
    struct PotreeBlock
    {
        /// <summary>Index in the tree.</summary>
        public int Node;

        /// <summary>First point over the whole source.</summary>
        public long FirstPoint;

        public int Points;

        /// <summary>Where it starts in the file that holds it.</summary>
        public long Offset;

        /// <summary>Bytes of the file that it takes.</summary>
        public long Bytes;
    }
}
