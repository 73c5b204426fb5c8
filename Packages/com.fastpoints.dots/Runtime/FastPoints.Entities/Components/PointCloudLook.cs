using FastPoints.Gpu;
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
}
