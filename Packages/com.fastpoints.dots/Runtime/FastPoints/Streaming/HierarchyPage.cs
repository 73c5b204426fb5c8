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
        public int Failures;
        public PageStatus Status;

        public bool IsLoaded => Status == PageStatus.Loaded;

        /// <summary>Bytes that a loaded page takes.</summary>
        public static long BytesFor(int nodeCount, int planeCount) =>
            nodeCount * ((long)sizeof(StreamNode) + sizeof(NodeState) + (long)planeCount * sizeof(PlaneRange));

        /// <summary>Makes room for the nodes, in one piece; the page is not loaded yet.</summary>
        public void Allocate(int nodeCount, int planeCount)
        {
            Nodes = (StreamNode*)UnsafeUtility.Malloc(math.max(64, BytesFor(nodeCount, planeCount)), 64, Allocator.Persistent);
            States = (NodeState*)(Nodes + nodeCount);
            Planes = (PlaneRange*)(States + nodeCount);
            NodeCount = nodeCount;
            RootCount = 0;
        }

        /// <summary>Gives the nodes up; the page can be loaded again.</summary>
        public void Free()
        {
            UnsafeUtility.Free(Nodes, Allocator.Persistent);
            Nodes = null;
            States = null;
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
