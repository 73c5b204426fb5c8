using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Entities
{
    /// <summary>A box, along the cloud's axes, around a node's points and all below: from the corner of the cloud's root cube,
    /// in CRS units.</summary>
    public struct PointCloudNodeBounds : IComponentData
    {
        public double3 Center;
        public float3 Half;
    }
}
