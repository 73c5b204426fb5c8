using FastPoints.Drawing;
using FastPoints.Rendering;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>How a cloud is coloured, and which classes it shows. Clouds opened from files have one that follows their
    /// <see cref="PointCloudFile"/>; users may write another that uses streamed planes.</summary>
    public struct PointCloudLook : IComponentData
    {
        /// <summary>Made by <c>CloudLooks.Of</c>.</summary>
        public CloudLook Value;
    }

    /// <summary>How the points of all clouds look, on one entity of the world. Without it <see cref="PointStyle.Default"/>
    /// applies.</summary>
    public struct PointCloudStyle : IComponentData
    {
        public PointStyle Value;
    }

    /// <summary>All clouds are clipped by the cube of edge 1 around this entity's origin, as its LocalToWorld places it. Cubes
    /// that do not cut keep only what is inside at least one of them.</summary>
    public struct PointCloudClip : IComponentData
    {
        /// <summary>Whether what is inside the cube is removed.</summary>
        public bool Cuts;
    }
}
