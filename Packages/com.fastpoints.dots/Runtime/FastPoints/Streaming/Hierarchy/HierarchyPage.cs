using FastPoints.Points;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Streaming
{
    /// <summary>
    /// A part of a cloud's hierarchy that is loaded as a whole: the upper levels (page 0), or one chunk (pages 1 and on). Its
    /// box is known before its nodes are. Blittable; owns its memory.
    /// </summary>
    public unsafe struct HierarchyPage
    {
        /// <summary>Null while the page is not loaded, as are the others.</summary>
        public StreamNode* Nodes;
        public NodeState* States;
        public NodePlace* Places;

        /// <summary>By node times planes that are streamed, plus plane.</summary>
        public PlaneRange* Planes;
        public int NodeCount;

        /// <summary>The first so many nodes have no parent in the page.</summary>
        public int RootCount;

        /// <summary>Around all points of the page: see <see cref="StreamNode.Center"/>.</summary>
        public double3 Center;
        public float3 Half;

        /// <summary>Frame of the last selection that had its box in view, with the node that it hangs on chosen.</summary>
        public uint SeenFrame;

        /// <summary>Nodes that are on their way or in the cache.</summary>
        public int NodesInCache;

        /// <summary>Reads of its file that failed one after the other, when the last one did, and until when none is
        /// tried.</summary>
        public int Failures;
        public uint LastFailureFrame;
        public uint RetryFrame;

        /// <summary>Its file cannot be read: what is not in the cache is a hole.</summary>
        public bool IsBroken;
        public HierarchyPageStatus Status;

        public bool IsLoaded => Status == HierarchyPageStatus.Loaded;

        /// <summary>Whether a node will never be there: it takes nothing of the budget, and what is below it is shown
        /// without it.</summary>
        public bool IsHole(int node) =>
            States[node].Slot == NodeState.NoSlot && (IsBroken || States[node].Failures == NodeState.IsHole);

        /// <summary>Bytes that a loaded page takes.</summary>
        public static long BytesFor(int nodeCount, int planeCount) =>
            nodeCount * ((long)sizeof(StreamNode) + sizeof(NodeState) + sizeof(NodePlace) +
                (long)planeCount * sizeof(PlaneRange));

        /// <summary>Makes room for the nodes, in one piece; the page is not loaded yet.</summary>
        public void Allocate(int nodeCount, int planeCount)
        {
            Nodes = (StreamNode*)UnsafeUtility.Malloc(math.max(64, BytesFor(nodeCount, planeCount)), 64, Allocator.Persistent);
            States = (NodeState*)(Nodes + nodeCount);
            Places = (NodePlace*)(States + nodeCount);
            Planes = (PlaneRange*)(Places + nodeCount);
            NodeCount = nodeCount;
            RootCount = 0;
        }

        /// <summary>Gives the nodes up; the page can be loaded again.</summary>
        public void Free()
        {
            UnsafeUtility.Free(Nodes, Allocator.Persistent);
            Nodes = null;
            States = null;
            Places = null;
            Planes = null;
            NodeCount = 0;
            Status = HierarchyPageStatus.Absent;
        }

        /// <summary>The box of a chunk, as far as the cloud's bounds go.</summary>
        public static HierarchyPage OfChunk(in ChunkRecord chunk, in HierarchyGrid grid)
        {
            var page = new HierarchyPage();
            long last = chunk.Cube.Side - 1;
            var max = Grid3.Min(chunk.Corner + new Grid3(last, last, last), grid.BoundsMax);
            grid.Box(Grid3.Max(chunk.Corner, grid.BoundsMin), max, out page.Center, out page.Half);
            return page;
        }
    }

    public enum HierarchyPageStatus : byte
    {
        Absent,
        /// <summary>Its table is being read.</summary>
        Loading,
        Loaded,
        /// <summary>It could not be read, was reported, and is a hole.</summary>
        Failed,
    }

    /// <summary>A page that a selection came to and found not loaded.</summary>
    internal struct MissingHierarchyPage
    {
        public int Cloud;
        public int Page;
    }

    /// <summary>What its blocks' positions count from: asked for where a node is drawn.</summary>
    public struct NodePlace
    {
        /// <summary>Of the node's cube, from the corner of the root cube, in grid steps.</summary>
        public Grid3 Corner;

        /// <summary>Positions are 64-bit columns.</summary>
        public bool IsWide;

        /// <summary>Of the node's cube: see <see cref="NodeCubes"/>.</summary>
        public byte Level;
    }

    /// <summary>What changes about a node: the only place where it is kept.</summary>
    public struct NodeState
    {
        public const int NoSlot = -1;
        public const int IsHole = int.MaxValue;

        /// <summary>Frame of the last selection that chose the node.</summary>
        public uint SelectedFrame;

        /// <summary>Frame of the last selection that had it in view, with its parent chosen.</summary>
        public uint SeenFrame;

        /// <summary>Its place in the cache, or <see cref="NoSlot"/>.</summary>
        public int Slot;

        /// <summary>Times that its bytes were damaged, or <see cref="IsHole"/>: it is not asked for any more.</summary>
        public int Failures;

        /// <summary>Of a node that is made: whether it was, so that its length is known.</summary>
        public bool WasMade;
    }

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
