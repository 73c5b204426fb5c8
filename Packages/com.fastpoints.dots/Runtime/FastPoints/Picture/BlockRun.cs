using FastPoints.Points;

namespace FastPoints.Picture
{
    /// <summary>A node's blocks as a drawing job sees them; its planes are listed beside.</summary>
    public struct BlockRun
    {
        /// <summary>Positions are offsets from here, in grid steps from the corner of the cloud's root cube.</summary>
        public Grid3 Corner;
        public int BlockCount;
    }
}
