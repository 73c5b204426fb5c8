using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Store
{
    /// <summary>A part of a hierarchy that is loaded as a whole; page 0 has the root. Its box is known before its nodes are. Owns
    /// its memory.</summary>
    public unsafe struct HierarchyPage
    {
        /// <summary>Null while the page is not loaded, as are the other pointers.</summary>
        public StreamNode* Nodes;
        public NodeState* States;
        public NodeAddress* Addresses;

        /// <summary>Indexed by node times streamed planes, plus plane.</summary>
        public PlaneRange* Planes;
        public int NodeCount;

        /// <summary>This many nodes at the start have no parent in the page.</summary>
        public int RootCount;

        /// <summary>Centre of the box around all points of the page: see <c>StreamNode.Center</c>.</summary>
        public double3 Center;
        public float3 Half;

        /// <summary>Frame of the last selection whose frustum its box intersected and that chose the node above.</summary>
        public uint VisitedFrame;

        /// <summary>Number of its nodes in flight or in the cache.</summary>
        public int NodesInCache;

        /// <summary>Consecutive failed reads of its file, the frame of the last one, and the frame of the next try.</summary>
        public int Failures;
        public uint LastFailureFrame;
        public uint RetryFrame;

        /// <summary>Whether its file cannot be read, so that nodes outside the cache are holes.</summary>
        public bool IsBroken;
        internal HierarchyPageStatus Status;

        public bool IsLoaded => Status == HierarchyPageStatus.Loaded;

        /// <summary>A node that will never be loaded takes nothing of the budget; what is below it is shown.</summary>
        public bool IsHole(int node) =>
            States[node].Slot == NodeState.NoSlot && (IsBroken || States[node].Failures == NodeState.HoleFailures);

        /// <summary>Bytes that a loaded page takes.</summary>
        public static long BytesFor(int nodeCount, int planeCount) =>
            nodeCount * ((long)sizeof(StreamNode) + sizeof(NodeState) + sizeof(NodeAddress) +
                (long)planeCount * sizeof(PlaneRange));

        /// <summary>Makes room for the nodes in one piece; the page does not count as loaded yet.</summary>
        public void Allocate(int nodeCount, int planeCount)
        {
            Nodes = (StreamNode*)UnsafeUtility.Malloc(math.max(64, BytesFor(nodeCount, planeCount)), 64, Allocator.Persistent);
            States = (NodeState*)(Nodes + nodeCount);
            Addresses = (NodeAddress*)(States + nodeCount);
            Planes = (PlaneRange*)(Addresses + nodeCount);
            NodeCount = nodeCount;
            RootCount = 0;
        }

        /// <summary>Frees the nodes; the page can be loaded again.</summary>
        public void Free()
        {
            UnsafeUtility.Free(Nodes, Allocator.Persistent);
            Nodes = null;
            States = null;
            Addresses = null;
            Planes = null;
            NodeCount = 0;
            Status = HierarchyPageStatus.Absent;
        }

        // The cube of what is below the link, cut to the cloud's bounds.
        internal static HierarchyPage OfLink(in PageLink link, in CloudLocalSpace grid)
        {
            var page = new HierarchyPage();
            grid.BoxOf(link.Cube, out page.Center, out page.Half);
            return page;
        }
    }

    /// <summary>Whether a page of a hierarchy is in memory.</summary>
    internal enum HierarchyPageStatus : byte
    {
        Absent,
        Loading, // Its table is being read.
        Loaded,
        Failed, // Its table could not be read, which was reported; the page is a hole.
    }

    internal struct MissingHierarchyPage
    {
        public int Cloud;
        public int Page;
    }

    /// <summary>Where a node lies: the corner that its blocks' positions count from.</summary>
    public struct NodeAddress
    {
        /// <summary>Corner of the node's cube relative to that of the root cube, in grid steps.</summary>
        public Grid3 Corner;

        /// <summary>Whether positions are 64-bit columns.</summary>
        public bool IsWide;

        /// <summary>Level of the node's cube: see <c>NodeCubes</c>.</summary>
        public byte Level;
    }

    /// <summary>The changing state of a node, which is kept only here.</summary>
    public struct NodeState
    {
        public const int NoSlot = -1;
        public const int HoleFailures = int.MaxValue;

        /// <summary>Frame of the last selection that chose the node.</summary>
        public uint SelectedFrame;

        /// <summary>Frame of the last selection whose frustum its box intersected and that chose its parent.</summary>
        public uint VisitedFrame;

        /// <summary>First frame of the current unbroken run of selections whose frustum its box intersected.</summary>
        public uint InViewSinceFrame;

        /// <summary>Its slot in the cache, or <see cref="NoSlot"/>.</summary>
        public int Slot;

        /// <summary>How often its bytes were damaged, or <see cref="HoleFailures"/>: then it is never requested again.</summary>
        public int Failures;

        /// <summary>Whether a node of a source that transcodes was transcoded, so that its length is known.</summary>
        public bool WasTranscoded;
    }

    /// <summary>What the selection knows of a node: 64 bytes, one line of the cache.</summary>
    public struct StreamNode
    {
        /// <summary>Centre of the box around all points from the node down, from the root's corner, in CRS units.</summary>
        public double3 Center;
        public float3 Half;

        /// <summary>Spacing of the node's points in CRS units: the gap that its children fill.</summary>
        public float Spacing;

        /// <summary>Index of its first child in the same page.</summary>
        public int FirstChild;
        public int ChildCount;

        /// <summary>Number of the first page below the node, once its own page is registered; the others follow.</summary>
        public int FirstPage;
        public int PageCount;

        /// <summary>With inlined leaves; 0 for an inlined leaf, which is read, kept and drawn with its parent.</summary>
        public int PointCount;

        /// <summary>Blocks in the node's planes.</summary>
        public int BlockCount;
    }
}
