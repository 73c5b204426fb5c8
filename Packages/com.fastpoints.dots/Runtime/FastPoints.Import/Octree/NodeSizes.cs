using FastPoints.Store;

namespace FastPoints.Octree
{
    /// <summary>How large nodes are and how finely they are sampled. Blittable.</summary>
    public struct NodeSizes
    {
        /// <summary>Sampling cells along an edge of a node that is no leaf: 2^this, fewer where the node became too
        /// large.</summary>
        public int CellsLog2;

        /// <summary>A cube with no more points left than this is a leaf and takes them all.</summary>
        public int MaxPointsPerLeaf;

        /// <summary>At most <see cref="StoreFormat.MaxPointsPerNode"/>.</summary>
        public int MaxPointsPerNode;

        public static NodeSizes Default => new NodeSizes
        {
            CellsLog2 = 7,
            MaxPointsPerLeaf = 20000,
            MaxPointsPerNode = StoreFormat.MaxPointsPerNode,
        };
    }
}
