using FastPoints.Store;

namespace FastPoints.Samplers
{
    /// <summary>The size of nodes and how finely they are sampled. Blittable.</summary>
    internal struct NodeSizes
    {
        /// <summary>log2 of the sampling cells along an edge of a node that is not a leaf; it has fewer if the node became too
        /// large.</summary>
        public int CellsLog2;

        /// <summary>A cube with at most this many remaining points is a leaf and takes them all; see <see cref="IsLeaf"/> for
        /// larger ones.</summary>
        public int MaxPointsPerLeaf;

        /// <summary>At most <see cref="StoreFormat.MaxPointsPerNode"/>.</summary>
        public int MaxPointsPerNode;

        /// <summary>Whether a cube becomes a leaf, which it also does if a node that samples it would take most of its points,
        /// and its children a few each.</summary>
        /// <param name="left">The number of its points that no node above has.</param>
        /// <param name="cells">The number of cells with only such points, at the finest size that a node may have.</param>
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
