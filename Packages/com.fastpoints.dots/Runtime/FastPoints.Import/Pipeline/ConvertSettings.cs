using FastPoints.Octree;

namespace FastPoints.Pipeline
{
    /// <summary>How a cloud is converted.</summary>
    public sealed class ConvertSettings
    {
        /// <summary>Names of the attributes that are kept; null for all. The position is always kept.</summary>
        public string[] Attributes;

        public Sampler Sampler;

        /// <summary>log2 of the sampling cells along a node's edge, 4 to 8: the spacing is the node's edge by that; 0 for the default
        /// of <see cref="NodeSizes"/>.</summary>
        public int CellsLog2;

        /// <summary>Chunks have at most about so many points, and are no smaller than they need be; 0 for a number that suits the
        /// cloud. The stored bytes depend on it, and on nothing about the machine.</summary>
        public long PointsPerChunk;

        /// <summary>Chunks in work at once; 0 for one a worker and one more. Memory only: the stored bytes are the
        /// same.</summary>
        public int ChunksAtOnce;
    }
}
