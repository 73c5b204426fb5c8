using Unity.Entities;
using Unity.Mathematics;

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

    /// <summary>A box, along the cloud's axes, around a node's points and all below: from the corner of the cloud's root cube,
    /// in CRS units.</summary>
    public struct PointCloudNodeBounds : IComponentData
    {
        public double3 Center;
        public float3 Half;
    }

    /// <summary>The node is on its way: not all of it is in memory.</summary>
    public struct Requested : IComponentData, IEnableableComponent
    {
    }

    /// <summary>All of the node is in memory.</summary>
    public struct Resident : IComponentData, IEnableableComponent
    {
    }

    /// <summary>The node is in the list of what to draw.</summary>
    public struct Drawn : IComponentData, IEnableableComponent
    {
    }

    /// <summary>Users enable this: the node is not drawn, though what is below it is.</summary>
    public struct Hidden : IComponentData, IEnableableComponent
    {
    }

    /// <summary>Users enable this: the node is not given up while the memory budget has room for it at all.</summary>
    public struct Pinned : IComponentData, IEnableableComponent
    {
    }

    /// <summary>Users enable this: the colours of the node's points are multiplied by it.</summary>
    public struct Tint : IComponentData, IEnableableComponent
    {
        /// <summary>sRGB: red, green, blue, alpha from the lowest byte; white leaves colours as they are.</summary>
        public uint Rgba;
    }
}
