using FastPoints.Points;

namespace FastPoints.Streaming
{
    /// <summary>What its blocks' positions count from: asked for where a node is drawn.</summary>
    public struct NodePlace
    {
        /// <summary>Of the node's cube, from the corner of the root cube, in grid steps.</summary>
        public Grid3 Corner;

        /// <summary>Positions are 64-bit columns.</summary>
        public bool IsWide;

        /// <summary>Of the node's cube: see <see cref="NodeCubes"/>.</summary>
        public byte Level;
    }
}
