using FastPoints.Gpu;
using FastPoints.Points;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    /// <summary>A node's blocks as a drawing job sees them; its planes are listed beside.</summary>
    public struct BlockRun
    {
        /// <summary>Positions are offsets from here, in grid steps from the corner of the cloud's root cube.</summary>
        public Grid3 Corner;
        public int BlockCount;

        /// <summary>In the <see cref="SizeTree"/>, where sizes are adaptive.</summary>
        public int SizeNode;

        /// <summary>Of the node's cube, in grid steps from the corner of the cloud's root cube.</summary>
        public double3 CubeCorner;

        /// <summary>Edges of the cube in one grid step.</summary>
        public double3 CubesPerStep;
    }
}
