using FastPoints.Gpu;
using FastPoints.Rendering;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>How a cloud is coloured, and which classes it shows. Clouds that are opened from files have one as their
    /// <see cref="PointCloudFile"/> says; users may write another, of planes that are streamed.</summary>
    public struct PointCloudLook : IComponentData
    {
        /// <summary>See <c>CloudLooks.Of</c>.</summary>
        public CloudLook Value;
    }

    /// <summary>What points look like, of all clouds: on one entity of the world. Without it they are
    /// <see cref="PointStyle.Default"/>.</summary>
    public struct PointCloudStyle : IComponentData
    {
        public PointStyle Value;
    }

    /// <summary>All clouds are clipped by the cube of edge 1 around this entity's origin, as its LocalToWorld places it. Of cubes
    /// that do not cut, only what is in one of them is drawn.</summary>
    public struct PointCloudClip : IComponentData
    {
        /// <summary>Takes away what is in the cube.</summary>
        public bool Cuts;
    }
}
