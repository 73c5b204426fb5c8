using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>An entity with this is a cloud that is streamed, once it has a source (<see cref="PointCloudSource"/>).</summary>
    public struct PointCloud : IComponentData
    {
        /// <summary>Where the cloud stands. By itself an entity's transform is too coarse for coordinates of a map: this is in
        /// double.</summary>
        public Streaming.CloudPlacement Placement;
    }
}
