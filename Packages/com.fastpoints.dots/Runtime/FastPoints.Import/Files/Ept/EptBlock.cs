using Unity.Mathematics;

namespace FastPoints.Files
{
    /// <summary>A block of an EPT octree: a node's file, or some of the points in it.</summary>
    struct EptBlock
    {
        public int Level;
        public int3 Cell;

        /// <summary>First point over the whole source.</summary>
        public long FirstPoint;

        /// <summary>First point, counted from the file's start.</summary>
        public long FirstInNode;

        public int Points;

        /// <summary>Of the node, as the hierarchy claims.</summary>
        public long NodePoints;

        public long FileBytes;
    }
}
