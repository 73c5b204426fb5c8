using FastPoints.Points;

namespace FastPoints.Draw
{
    /// <summary>One node to decode: where its blocks are in a file's bytes, and where its points go. Blittable.</summary>
    public struct ChosenNode
    {
        public int FirstBlock;
        public int BlockCount;
        public int HostedBlocks;
        public bool IsWide;

        /// <summary>Corner that the positions count from, as seen from the batch's corner.</summary>
        public Grid3 Corner;

        /// <summary>The first point's place in the batch.</summary>
        public int FirstPoint;

        /// <summary>The node's planes among the job's ranges: the first of them.</summary>
        public int FirstRange;
    }
}
