using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>What the selection knows of a node: 64 bytes, one line of the cache.</summary>
    public struct StreamNode
    {
        /// <summary>Of the box around the node's points and all below, from the corner of the root cube, in CRS units.</summary>
        public double3 Center;
        public float3 Half;

        /// <summary>Of the node's points, in CRS units: the gap that its children fill.</summary>
        public float Spacing;

        /// <summary>In the same page.</summary>
        public int FirstChild;
        public int ChildCount;

        /// <summary>Chunks that hang on the node, page <see cref="FirstChunk"/> + 1 and on: in page 0 only.</summary>
        public int FirstChunk;
        public int ChunkCount;

        /// <summary>Points of the node and its guests; 0 for a guest, which is read, kept and drawn with its host.</summary>
        public int PointCount;

        /// <summary>Blocks in the node's planes.</summary>
        public int BlockCount;
    }
}
