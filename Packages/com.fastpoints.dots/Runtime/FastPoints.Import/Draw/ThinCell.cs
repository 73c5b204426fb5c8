using Unity.Mathematics;

namespace FastPoints.Draw
{
    /// <summary>A cell of a cloud, and how many points of it are drawn.</summary>
    public struct ThinCell
    {
        /// <summary>Georeferenced.</summary>
        public double3 Center;

        public double Edge;

        public double PointsDrawn;
    }
}
