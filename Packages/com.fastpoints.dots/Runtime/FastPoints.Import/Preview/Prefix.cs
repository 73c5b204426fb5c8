namespace FastPoints.Preview
{
    /// <summary>Points of a block's beginning that one wave adds to those of the waves before, and where they go.</summary>
    struct Prefix
    {
        public int Block;

        /// <summary>Points of the block that were taken before.</summary>
        public int First;

        public int Count;

        /// <summary>Of the first one in the sample.</summary>
        public int Place;
    }
}
