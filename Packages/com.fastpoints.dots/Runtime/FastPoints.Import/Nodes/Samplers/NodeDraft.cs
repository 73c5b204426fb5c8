namespace FastPoints.Nodes
{
    /// <summary>A node as a sampler makes it: an array of nodes by point says which points are its own. Blittable.</summary>
    internal struct NodeDraft
    {
        /// <summary>All points of the node's cube are in this range of the sorted points.</summary>
        public int First;
        public int End;

        /// <summary>The nearest node above, or -1.</summary>
        public int Parent;

        /// <summary>The node's own points.</summary>
        public int Count;
        public byte SideLog2;
        public byte CellLog2;
        public bool IsLeaf;

        /// <summary>Whether it is what was left of a chunk's top: see <see cref="Store.NodeRecord.IsTop"/>.</summary>
        public bool IsTop;
    }

    /// <summary>A chunk's part in the merge: its top node's points in order, and whether anything is below them.
    /// Blittable.</summary>
    internal struct ChunkTop
    {
        /// <summary>Range of the merged points.</summary>
        public int First;
        public int End;

        /// <summary>The top node's cube and cells, as the chunk's sampler made them.</summary>
        public byte SideLog2;
        public byte CellLog2;
        public bool IsLeaf;

        /// <summary>Whether the chunk has nodes besides the top.</summary>
        public bool HasNodes;

        /// <summary>Out: the node that the chunk's other nodes are attached to.</summary>
        public int AttachNode;
    }
}
