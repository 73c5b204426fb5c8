using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>A node of a cloud's octree that is on its way, or in memory: its entity lives as long as that. With it come
    /// <see cref="PointCloudNodeBounds"/>; <see cref="Requested"/>, <see cref="Resident"/> and <see cref="Drawn"/>, which say how
    /// far it is; and for users to enable <see cref="Hidden"/>, <see cref="Pinned"/> and <see cref="Tint"/>.</summary>
    public struct PointCloudNode : IComponentData
    {
        public Entity Cloud;

        /// <summary>Page of the hierarchy, and place in it.</summary>
        public int Page;
        public int Node;

        /// <summary>The node's own, its guests' included.</summary>
        public int PointCount;

        /// <summary>Its place in the stream's <see cref="Streaming.NodeCache"/>, and that place's version.</summary>
        public int Slot;
        public int SlotVersion;
    }
}
