using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>As long as any entity of the world has this, each node in flight or in memory has an entity with a
    /// <see cref="PointCloudNode"/>. Without it streaming makes no structural change.</summary>
    public struct PointCloudNodesWanted : IComponentData { }
}
