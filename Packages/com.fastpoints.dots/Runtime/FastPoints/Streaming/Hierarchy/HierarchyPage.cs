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
        public PageStatus Status;

        public bool IsLoaded => Status == PageStatus.Loaded;

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
            Status = PageStatus.Absent;
        }

        /// <summary>The box of a chunk, as far as the cloud's bounds go.</summary>
        public static HierarchyPage OfChunk(in ChunkRecord chunk, in PageGrid grid)
        {
            var page = new HierarchyPage();
            long last = chunk.Cube.Side - 1;
            var max = Grid3.Min(chunk.Corner + new Grid3(last, last, last), grid.BoundsMax);
            grid.Box(Grid3.Max(chunk.Corner, grid.BoundsMin), max, out page.Center, out page.Half);
            return page;
        }
    }
}
