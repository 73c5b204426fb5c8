using FastPoints.Store;

namespace FastPoints.Samplers
{
    /// <summary>How large nodes are and how finely they are sampled. Blittable.</summary>
    internal struct NodeSizes
    {
        /// <summary>Sampling cells along an edge of a node that is no leaf: 2^this, fewer where the node became too
        /// large.</summary>
        public int CellsLog2;

        /// <summary>A cube with no more points left than this is a leaf and takes them all; see <see cref="IsLeaf"/> for larger
        /// ones.</summary>
        public int MaxPointsPerLeaf;

        /// <summary>At most <see cref="StoreFormat.MaxPointsPerNode"/>.</summary>
        public int MaxPointsPerNode;

        /// <summary>Whether a cube becomes a leaf: also where a node that samples it would take most of its points, and its
        /// children a few each.</summary>
        /// <param name="left">Its points that no node above has.</param>
        /// <param name="cells">At the finest cells that a node may have, those with such points only.</param>
        public readonly bool IsLeaf(int left, int cells) =>
            left <= MaxPointsPerLeaf || (left <= MaxPointsPerNode && cells >= left - left / 4);

        public static NodeSizes Default => new NodeSizes
        {
            CellsLog2 = 7,
            MaxPointsPerLeaf = 20000,
            MaxPointsPerNode = StoreFormat.MaxPointsPerNode,
        };
    }
}
