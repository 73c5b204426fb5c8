using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>The space that a cloud's transform moves: see <see cref="UnitySpace"/>.</summary>
    public struct PointCloudSpace : IComponentData
    {
        public UnitySpace Value;
    }
}
