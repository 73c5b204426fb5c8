using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Samplers
{
    /// <summary>What all samplers share: which cubes become leaves, chains or chunks' tops, how fine cells may be, and how a
    /// cube's points are divided. Points that belong to no node yet have a negative number.</summary>
    internal unsafe struct NodeDrafting
    {
        [NativeDisableUnsafePtrRestriction] public byte* CommonCubeLog2;
        [NativeDisableUnsafePtrRestriction] public int* NodeOfPoint;
        public NodeSizes Sizes;
        public NativeArray<ChunkTop> Tops;
        public NativeList<NodeDraft> Nodes;

        /// <summary>Puts all remaining points of a range into a leaf, a chunk's top or a chain, if it should be one.</summary>
        /// <param name="look">The survey of the range's points.</param>
        /// <param name="top">The chunk whose top it was, or -1.</param>
        /// <returns>False if the range is to be sampled: its cube and cells are then set.</returns>
        public bool TakeWhole(ref SampledRange range, in RangeSurvey look, out int top)
        {
            top = -1;
            int left = look.Left, firstTop = 0, endTop = 0;
            byte finest = (byte)look.FinestCell(Sizes, out int cells);
            bool isLeaf = Sizes.IsLeaf(left, cells);
            if (Tops.Length > 0)
            {
                firstTop = TopOf(range.First);
                endTop = TopOf(range.End - 1) + 1;
                for (int t = firstTop; t < endTop; t++)
                    isLeaf &= !Tops[t].HasNodes;
                if (endTop - firstTop == 1)
                {
                    top = firstTop;
                    TakeTop(range, firstTop, left);
                    return true;
                }
            }
            if (isLeaf)
            {
                byte cell = (byte)math.max(0, range.SideLog2 - Sizes.CellsLog2);
                int leaf = left > 0 ? TakeAll(range, left, range.SideLog2, cell, true) : range.Parent;
                for (int t = firstTop; t < endTop; t++)
                    Attach(t, leaf);
                return true;
            }
            if (look.Largest == 0)
            {
                bool hasNodes = false;
                for (int t = firstTop; t < endTop; t++)
                    hasNodes |= Tops[t].HasNodes;
                int last = TakeEqual(range, left, !hasNodes);
                for (int t = firstTop; t < endTop; t++)
                    Attach(t, last);
                return true;
            }
            range.SideLog2 = (byte)look.Largest;
            range.CellLog2 = finest;
            return false;
        }

        /// <summary>Makes the node of a range that was sampled.</summary>
        /// <returns>The node that the range's parts are attached to: the one above if this one got no point.</returns>
        public int AddSampled(in SampledRange range)
        {
            if (range.Count == 0)
                return range.Parent;
            AddNode(range, range.Parent, range.Count, range.SideLog2, range.CellLog2, false);
            return Nodes.Length - 1;
        }

        /// <summary>The end of the part of a range that begins at a point: one of the octants of the range's cube.</summary>
        public int EndOfPart(in SampledRange range, int first)
        {
            int i = first + 1;
            while (i < range.End && CommonCubeLog2[i] < range.SideLog2)
                i++;
            return i;
        }

        int TakeAll(in SampledRange range, int left, int side, byte cell, bool isLeaf)
        {
            int node = Nodes.Length;
            for (int i = range.First; i < range.End; i++)
                if (NodeOfPoint[i] < 0)
                    NodeOfPoint[i] = node;
            AddNode(range, range.Parent, left, side, cell, isLeaf);
            return node;
        }

        /// <summary>Takes points at one place: into a chain of nodes of one step's cube.</summary>
        /// <returns>The chain's end, or the node above if all points are in nodes already.</returns>
        int TakeEqual(in SampledRange range, int left, bool endsInLeaf)
        {
            int parent = range.Parent;
            int i = range.First;
            while (left > 0)
            {
                int node = Nodes.Length, count = math.min(left, Sizes.MaxPointsPerNode);
                for (int taken = 0; taken < count; i++)
                {
                    if (NodeOfPoint[i] >= 0)
                        continue;
                    NodeOfPoint[i] = node;
                    taken++;
                }
                left -= count;
                AddNode(range, parent, count, 0, 0, left == 0 && endsInLeaf);
                parent = node;
            }
            return parent;
        }

        /// <summary>Makes what the upper nodes left of a chunk's top that chunk's top node.</summary>
        void TakeTop(in SampledRange range, int index, int left)
        {
            var top = Tops[index];
            if (left == 0)
            {
                Attach(index, range.Parent);
                return;
            }
            int node = TakeAll(range, left, top.SideLog2, top.CellLog2, top.IsLeaf);
            Nodes.ElementAt(node).IsTop = true;
            Attach(index, node);
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

        void AddNode(in SampledRange range, int parent, int count, int side, byte cell, bool isLeaf)
        {
            Nodes.Add(new NodeDraft
            {
                First = range.First,
                End = range.End,
                Parent = parent,
                Count = count,
                SideLog2 = (byte)side,
                CellLog2 = cell,
                IsLeaf = isLeaf,
            });
        }
    }
}
