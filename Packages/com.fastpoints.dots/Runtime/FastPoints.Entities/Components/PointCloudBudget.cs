using Unity.Entities;

namespace FastPoints.Entities
{
    /// <summary>What streaming may take, of all clouds and cameras together: on one entity of the world. Without it the
    /// defaults of <see cref="Streaming.StreamSettings"/> hold.</summary>
    public struct PointCloudBudget : IComponentData
    {
        /// <summary>Points that are drawn at most.</summary>
        public long Points;

        /// <summary>Graphics memory of nodes at most, in bytes: a hard limit, in whole banks.</summary>
        public long PoolBytes;

        /// <summary>Bytes that are copied into it in one frame at most.</summary>
        public int UploadBytesPerFrame;

        /// <summary>Smallest size of a node on the screen, in pixels.</summary>
        public float SmallestNodePx;
    }
}
