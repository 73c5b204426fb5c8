using Unity.Burst;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using Unity.Mathematics;

namespace FastPoints.Octree
{
    /// <summary>
    /// The random sampler: from the root down, each node takes the point of the highest priority of each of its cells, unless a
    /// node above has a point of that cell already. Which points a node has depends on nothing but the points themselves.
    /// </summary>
    /// <remarks>
    /// Points are in Morton order, so that cubes and cells are ranges, and one byte a point tells where they end. A node's cells
    /// are as fine as 2^-7 of its edge, and coarser where that made it too large: a filled volume. Cubes that would have their
    /// points in one octant only are passed over, and so is a node that gets no point: its children hang on the node above.
    /// </remarks>
    [BurstCompile]
    public unsafe struct SampleRandomJob : IJob
    {
        struct Pending
        {
            public int First;
            public int End;
            public int Parent;
            public int SideLog2;
        }

        public int Count;
        public int RootSideLog2;
        [ReadOnly] public NativeArray<byte> CommonCubeLog2;
        [ReadOnly] public NativeArray<uint> Priority;

        /// <summary>Where the points are the tops of chunks, these: a range that lies in one of them becomes its node. Empty for
        /// whole points.</summary>
        public NativeArray<ChunkTop> Tops;

        /// <summary>Out, by point.</summary>
        public NativeArray<int> NodeOfPoint;

        /// <summary>Out, in breadth-first order but for nodes whose parent was passed over.</summary>
        public NativeList<NodeDraft> Nodes;

        public void Execute()
        {
            Nodes.Clear();
            if (Count == 0)
                return;
            var common = (byte*)CommonCubeLog2.GetUnsafeReadOnlyPtr();
            var priority = (uint*)Priority.GetUnsafeReadOnlyPtr();
            var nodeOfPoint = (int*)NodeOfPoint.GetUnsafePtr();
            for (int i = 0; i < Count; i++)
                nodeOfPoint[i] = Sampling.Unassigned;

            var queue = new NativeList<Pending>(256, Allocator.Temp);
            queue.Add(new Pending { First = 0, End = Count, Parent = -1, SideLog2 = RootSideLog2 });
            for (int q = 0; q < queue.Length; q++)
                Visit(queue[q], ref queue, common, priority, nodeOfPoint);
            queue.Dispose();
        }

        void Visit(Pending range, ref NativeList<Pending> queue, byte* common, uint* priority, int* nodeOfPoint)
        {
            int side = range.SideLog2;
            int left = 0, largest = 0;
            for (int i = range.First; i < range.End; i++)
            {
                left += nodeOfPoint[i] == Sampling.Unassigned ? 1 : 0;
                largest = math.max(largest, i > range.First ? common[i] : 0);
            }

            int firstTop = 0, endTop = 0;
            bool isLeaf = left <= Sampling.MaxPointsPerLeaf;
            byte cell = (byte)math.max(0, side - Sampling.MaxCellsLog2);
            if (Tops.Length > 0)
            {
                firstTop = TopOf(range.First);
                endTop = TopOf(range.End - 1) + 1;
                for (int t = firstTop; t < endTop; t++)
                    isLeaf &= !Tops[t].HasNodes;
                if (endTop - firstTop == 1)
                {
                    TakeTop(range, firstTop, left, nodeOfPoint);
                    return;
                }
            }
            if (isLeaf)
            {
                int leaf = left > 0 ? TakeAll(range, left, side, cell, true, nodeOfPoint) : range.Parent;
                for (int t = firstTop; t < endTop; t++)
                    Attach(t, leaf);
                return;
            }
            if (largest == 0)
            {
                TakeEqual(range, left, nodeOfPoint);
                return;
            }

            side = largest;
            cell = (byte)FinestCell(range, side, common, nodeOfPoint);
            int parent = TakeOnePerCell(range, side, cell, common, priority, nodeOfPoint);
            int first = range.First;
            for (int i = range.First + 1; i <= range.End; i++)
            {
                if (i < range.End && common[i] < side)
                    continue;
                queue.Add(new Pending { First = first, End = i, Parent = parent, SideLog2 = side - 1 });
                first = i;
            }
        }

        /// <summary>The finest cells with which the node does not become too large.</summary>
        static int FinestCell(Pending range, int side, byte* common, int* nodeOfPoint)
        {
            // By side: neighbours in the order whose smallest common cube has it; first of all points, then of the taken ones.
            // A cell boundary lies between two points where their common cube is larger than the cell.
            int* allBySide = stackalloc int[65];
            int* takenBySide = stackalloc int[65];
            UnsafeUtility.MemClear(allBySide, 65 * sizeof(int));
            UnsafeUtility.MemClear(takenBySide, 65 * sizeof(int));
            int taken = 0, sinceTaken = 0;
            for (int i = range.First; i < range.End; i++)
            {
                if (i > range.First)
                {
                    allBySide[common[i]]++;
                    sinceTaken = math.max(sinceTaken, common[i]);
                }
                if (nodeOfPoint[i] == Sampling.Unassigned)
                    continue;
                if (taken++ > 0)
                    takenBySide[sinceTaken]++;
                sinceTaken = 0;
            }

            int finest = math.max(0, side - Sampling.MaxCellsLog2);
            int cells = 1, takenCells = taken > 0 ? 1 : 0;
            int best = side;
            for (int cell = side - 1; cell >= finest; cell--)
            {
                cells += allBySide[cell + 1];
                takenCells += takenBySide[cell + 1];
                if (cells - takenCells > Store.StoreFormat.MaxPointsPerNode)
                    break;
                best = cell;
            }
            return best;
        }

        int TakeOnePerCell(Pending range, int side, byte cell, byte* common, uint* priority, int* nodeOfPoint)
        {
            int node = Nodes.Length, count = 0;
            for (int first = range.First; first < range.End;)
            {
                int best = first, i = first;
                bool isTaken = false;
                do
                {
                    isTaken |= nodeOfPoint[i] != Sampling.Unassigned;
                    // Equal priorities: the first in order, so that content decides.
                    if (priority[i] > priority[best])
                        best = i;
                    i++;
                }
                while (i < range.End && common[i] <= cell);
                if (!isTaken)
                {
                    nodeOfPoint[best] = node;
                    count++;
                }
                first = i;
            }
            if (count == 0)
                return range.Parent;
            AddNode(range, range.Parent, count, side, cell, false);
            return node;
        }

        int TakeAll(Pending range, int left, int side, byte cell, bool isLeaf, int* nodeOfPoint)
        {
            int node = Nodes.Length;
            for (int i = range.First; i < range.End; i++)
                if (nodeOfPoint[i] == Sampling.Unassigned)
                    nodeOfPoint[i] = node;
            AddNode(range, range.Parent, left, side, cell, isLeaf);
            return node;
        }

        /// <summary>Points at one place: a chain of nodes of one step's cube.</summary>
        void TakeEqual(Pending range, int left, int* nodeOfPoint)
        {
            int parent = range.Parent;
            int i = range.First;
            while (left > 0)
            {
                int node = Nodes.Length, count = math.min(left, Store.StoreFormat.MaxPointsPerNode);
                for (int taken = 0; taken < count; i++)
                {
                    if (nodeOfPoint[i] != Sampling.Unassigned)
                        continue;
                    nodeOfPoint[i] = node;
                    taken++;
                }
                left -= count;
                AddNode(range, parent, count, 0, 0, left == 0);
                parent = node;
            }
        }

        /// <summary>What the upper nodes have left of a chunk's top is that chunk's top node.</summary>
        void TakeTop(Pending range, int index, int left, int* nodeOfPoint)
        {
            var top = Tops[index];
            Attach(index, left > 0
                ? TakeAll(range, left, top.SideLog2, top.CellLog2, top.IsLeaf, nodeOfPoint)
                : range.Parent);
        }

        void Attach(int index, int node)
        {
            var top = Tops[index];
            top.AttachNode = node;
            Tops[index] = top;
        }

        /// <summary>The chunk whose top has this point.</summary>
        int TopOf(int point)
        {
            int low = 0, high = Tops.Length - 1;
            while (low < high)
            {
                int middle = (low + high) >> 1;
                if (point < Tops[middle].End)
                    high = middle;
                else
                    low = middle + 1;
            }
            return low;
        }

        void AddNode(Pending range, int parent, int count, int side, int cell, bool isLeaf)
        {
            Nodes.Add(new NodeDraft
            {
                First = range.First,
                End = range.End,
                Parent = parent,
                Count = count,
                SideLog2 = (byte)side,
                CellLog2 = (byte)cell,
                IsLeaf = isLeaf,
            });
        }
    }
}
