using FastPoints.Streaming;
using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Where a cloud stands, in double: an entity with this and a source
    /// (<see cref="PointCloudSystemGroup.SetSource"/>) is streamed. If the entity has a transform and a
    /// <see cref="PointCloudFile"/>, <see cref="PlaceCloudsSystem"/> writes it.</summary>
    public struct PointCloudPlacement : IComponentData
    {
        public CloudPlacement Value;
    }

    /// <summary>The space that a cloud's transform moves: see <see cref="UnityLocalSpace"/>.</summary>
    public struct PointCloudSpace : IComponentData
    {
        public UnityLocalSpace Value;
    }
}
