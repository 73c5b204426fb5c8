using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>Limits of streaming for all clouds and cameras together, on one entity of the world. Without it the defaults of
    /// <see cref="Streaming.StreamSettings"/> apply.</summary>
    public struct PointCloudBudget : IComponentData
    {
        /// <summary>The most points that are drawn.</summary>
        public long Points;

        /// <summary>The most graphics memory for nodes, in bytes: a hard limit, in whole banks.</summary>
        public long PoolBytes;

        /// <summary>The most bytes that are copied to it in one frame.</summary>
        public int MaxUploadBytesPerFrame;

        /// <summary>Smallest size of a node on the screen, in pixels.</summary>
        public float MinNodePx;

        /// <summary>How long a node takes to appear or to leave, point by point; 0 for at once, as pictures for a comparison
        /// want it.</summary>
        public float FadeSeconds;
    }
}
