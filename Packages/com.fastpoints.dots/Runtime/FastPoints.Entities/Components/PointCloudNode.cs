using Unity.Entities;
using Unity.Mathematics;

namespace FastPoints.Entities
{
    /// <summary>A node of a cloud's octree that is in flight or in memory, if <see cref="PointCloudNodesWanted"/> asks for it:
    /// its entity lives as long, or is some frames late. It comes with <see cref="PointCloudNodeBounds"/>; with
    /// <see cref="Requested"/>, <see cref="Resident"/> and <see cref="Drawn"/>, which show its state; and with
    /// <see cref="Hidden"/>, <see cref="Pinned"/> and <see cref="Tint"/>, which users may enable.</summary>
    public struct PointCloudNode : IComponentData
    {
        public Entity Cloud;

        /// <summary>Page of the hierarchy, and index in it.</summary>
        public int Page;
        public int Node;

        /// <summary>The node's own points and those of its inlined leaves.</summary>
        public int PointCount;

        /// <summary>Its slot in the stream's <see cref="Streaming.NodeCache"/>, and the slot's version.</summary>
        public int Slot;
        public int SlotVersion;
    }

    /// <summary>A box along the cloud's axes around the points of a node and all below it: from the corner of the cloud's root
    /// cube, in CRS units.</summary>
    public struct PointCloudNodeBounds : IComponentData
    {
        public double3 Center;
        public float3 Half;
    }

    /// <summary>The node is in flight: not all of it is in memory.</summary>
    public struct Requested : IComponentData, IEnableableComponent { }

    /// <summary>All of the node is in memory.</summary>
    public struct Resident : IComponentData, IEnableableComponent { }

    /// <summary>The node is in the list of what to draw.</summary>
    public struct Drawn : IComponentData, IEnableableComponent { }

    /// <summary>Users enable this to hide a node; what is below it is still drawn.</summary>
    public struct Hidden : IComponentData, IEnableableComponent { }

    /// <summary>Users enable this to keep a node as long as the memory budget has any room for it.</summary>
    public struct Pinned : IComponentData, IEnableableComponent { }

    /// <summary>Users enable this to multiply the colours of the node's points.</summary>
    public struct Tint : IComponentData, IEnableableComponent
    {
        /// <summary>sRGB with red, green, blue, alpha from the lowest byte; white leaves colours unchanged.</summary>
        public uint Rgba;
    }
}
