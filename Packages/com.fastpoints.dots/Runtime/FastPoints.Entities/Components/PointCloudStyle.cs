using FastPoints.Rendering;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What points look like, of all clouds: on one entity of the world. Without it they are squares of 2
    /// pixels.</summary>
    public struct PointCloudStyle : IComponentData
    {
        public PointShape Shape;

        /// <summary>Edge of a square, diameter of a disc, in pixels.</summary>
        public float SizePx;
    }
}
