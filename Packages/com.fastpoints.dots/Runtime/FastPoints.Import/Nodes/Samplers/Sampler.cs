using FastPoints.Store;

namespace FastPoints.Nodes
{
    /// <summary>How the points of a cube are chosen that represent the others.</summary>
    public enum Sampler
    {
        /// <summary>One random point of each cell of a grid.</summary>
        Random,

        /// <summary>Blue noise: no two points of a chunk are nearer than the spacing; off its faces no other would fit.</summary>
        Poisson,

        /// <summary>Like <see cref="Poisson"/>, with colour and intensity averaged over the points that each point represents, in
        /// planes of their own.</summary>
        Average,
    }

    internal struct NodeSizes
    {
        /// <summary>Incremented when the same points, settings and chunks give other nodes than before: killed builds
        /// are then not continued, and clouds count as different.</summary>
        public const int SamplingVersion = 3;

        /// <summary>log2 of the sampling cells along an edge of a node that is not a leaf; it has fewer if the node became too
        /// large.</summary>
        public int CellsLog2;
        public int TargetPointsPerLeaf; // A leaf has about this many points that no node above has taken; see IsLeaf.
        public int MaxPointsPerNode; // At most StoreFormat.MaxPointsPerNode.

        /// <summary>Whether a cube becomes a leaf: if it has few points, of which nodes above take about a fifth, or if
        /// sampling would take most of them and leave a few for each child.</summary>
        /// <param name="points">The number of its points.</param>
        /// <param name="cells">The number of cells with points, at the finest size that a node may have.</param>
        public readonly bool IsLeaf(int points, int cells) => points <= MaxPointsPerNode &&
            (points <= TargetPointsPerLeaf / 4 * 5 || cells >= points - points / 4);

        public static NodeSizes Default => new NodeSizes
        {
            CellsLog2 = 7,
            TargetPointsPerLeaf = 20000,
            MaxPointsPerNode = StoreFormat.MaxPointsPerNode,
        };
    }

    internal struct NodeDraft
    {
        public int First; // All points of the node's cube are in this range of the sorted points.
        public int End;
        public int Parent; // The nearest node above, or -1.

        public int OwnCount; // Of the node's own points, which lie in that range among others.
        public byte SideLog2;
        public byte CellLog2;
        public bool IsLeaf;
        public bool IsTopRemainder; // Of a merge: what upper nodes left of a chunk's top. See Store.NodeRecord.TopFlag.
    }

    /// <summary>A chunk's part in the merge: its top node's points in order, and whether anything is below them.
    /// Blittable.</summary>
    internal struct TopNode
    {
        public int First;
        public int End;
        public byte SideLog2; // The top node's cube and cells, from the chunk's sampler.
        public byte CellLog2;
        public bool IsLeaf;

        public bool HasNodes;
        public int AttachNode; // Out: the node that the chunk's other nodes are attached to.

        public static TopNode Of(in NodeDraft top, bool hasNodes) => new TopNode
        {
            SideLog2 = top.SideLog2,
            CellLog2 = top.CellLog2,
            IsLeaf = top.IsLeaf,
            HasNodes = hasNodes,
            AttachNode = -1,
        };
    }
}
