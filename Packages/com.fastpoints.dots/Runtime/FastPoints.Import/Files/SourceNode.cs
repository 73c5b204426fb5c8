using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>A node of a source's own octree. One whose points are more than a block's is there several times, a block
    /// each.</summary>
    public struct SourceNode
    {
        /// <summary>0 for the root; a node of level L has an edge of the cube's over 2^L.</summary>
        public int Level;

        /// <summary>Its place among the 2^Level nodes of each axis.</summary>
        public int3 Cell;

        /// <summary>The block that holds its points, or -1 for a node without points.</summary>
        public int Block;

        /// <summary>Points of the block, as the hierarchy claims.</summary>
        public int PointCount;

        /// <summary>What nodes of an octree are told apart by.</summary>
        public int4 Key => new int4(Cell, Level);
    }
}
