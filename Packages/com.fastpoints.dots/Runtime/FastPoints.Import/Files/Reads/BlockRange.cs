namespace FastPoints.Files
{
    /// <summary>Some consecutive points of one of a source's natural blocks.</summary>
    public readonly struct BlockRange
    {
        public readonly int Block;

        /// <summary>First point, counted from the block's start.</summary>
        public readonly int First;

        public readonly int Count;

        public BlockRange(int block, int first, int count)
        {
            Block = block;
            First = first;
            Count = count;
        }
    }
}
