using FastPoints.Rendering;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What points look like, of all clouds: on one entity of the world. Without it they are
    /// <see cref="PointStyle.Default"/>.</summary>
    public struct PointCloudStyle : IComponentData
    {
        public PointStyle Value;
    }
}
