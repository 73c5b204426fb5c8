using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace FastPoints.Octree
{
    /// <summary>
    /// The random sampler: from the root down, each node takes the point of the highest priority of each of its cells, unless a
    /// node above has a point of that cell already. Which points a node has depends on nothing but the points themselves.
    /// </summary>
    /// <remarks>
    /// Points are in Morton order, so that cubes and cells are ranges, and one byte a point tells where they end. A node's cells
    /// are as fine as the sizes say, and coarser where that made it too large: a filled volume. Cubes that would have their
    /// points in one octant only are passed over, and so is a node that gets no point: its children hang on the node above.
    /// </remarks>
    [BurstCompile]
    public unsafe struct SampleRandomJob : IJob
    {
        public int Count;
        public int RootSideLog2;
        public NodeSizes Sizes;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>Where the points are the tops of chunks, these: a range that lies in one of them becomes its node. Empty for
        /// whole points.</summary>
        public NativeArray<ChunkTop> Tops;

        /// <summary>Out, by point.</summary>
        public NativeArray<int> NodeOfPoint;

        /// <summary>Out, in breadth-first order but for nodes whose parent was passed over.</summary>
        public NativeList<NodeDraft> Nodes;

        public SliceTimes Slices;

        public void Execute()
        {
            long begin = SliceTimes.Begin();
            Run();
            Slices.End(begin);
        }

        void Run()
        {
            Nodes.Clear();
            if (Count == 0)
                return;
            var drafting = new NodeDrafting
            {
                CommonCubeLog2 = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr(),
                NodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr(),
                Sizes = Sizes,
                Tops = Tops,
                Nodes = Nodes,
            };
            for (int i = 0; i < Count; i++)
                drafting.NodeOfPoint[i] = Sampling.Unassigned;

            var queue = new NativeList<SampledRange>(256, Allocator.Temp);
            queue.Add(new SampledRange { First = 0, End = Count, Parent = -1, SideLog2 = (byte)RootSideLog2 });
            for (int q = 0; q < queue.Length; q++)
            {
                var range = queue[q];
                if (drafting.TakeWhole(ref range, out _))
                    continue;
                TakeOnePerCell(ref range, drafting);
                int parent = drafting.AddSampled(range);
                for (int first = range.First; first < range.End;)
                {
                    int end = drafting.EndOfPart(range, first);
                    queue.Add(new SampledRange { First = first, End = end, Parent = parent, SideLog2 = (byte)(range.SideLog2 - 1) });
                    first = end;
                }
            }
            queue.Dispose();
        }

        void TakeOnePerCell(ref SampledRange range, in NodeDrafting drafting)
        {
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            var common = drafting.CommonCubeLog2;
            var nodeOfPoint = drafting.NodeOfPoint;
            int node = drafting.Nodes.Length;
            for (int first = range.First; first < range.End;)
            {
                int best = first, i = first;
                bool isTaken = false;
                do
                {
                    isTaken |= nodeOfPoint[i] >= 0;
                    // Equal priorities: the first in order, so that content decides.
                    if (priority[i] > priority[best])
                        best = i;
                    i++;
                }
                while (i < range.End && common[i] <= range.CellLog2);
                if (!isTaken)
                {
                    nodeOfPoint[best] = node;
                    range.Count++;
                }
                first = i;
            }
        }
    }
}
