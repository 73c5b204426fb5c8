using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>All clouds are clipped by the cube of edge 1 around this entity's origin, as its LocalToWorld places it. Of cubes
    /// that do not cut, only what is in one of them is drawn.</summary>
    public struct PointCloudClip : IComponentData
    {
        /// <summary>Takes away what is in the cube.</summary>
        public bool Cuts;
    }
}
