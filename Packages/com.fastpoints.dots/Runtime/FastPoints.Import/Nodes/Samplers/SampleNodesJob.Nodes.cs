using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.SampleScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>What follows the choice: averages, and the nodes that ranges become.</summary>
    internal unsafe partial struct SampleNodesJob
    {
        /// <summary>The range that a point belongs to, barred or not.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int RangeOf(int point) => m_rangeOfPoint[point] ^ m_rangeOfPoint[point] >> 31;

        /// <summary>Begins the averages of the next range of the current spacing, or the next spacing.</summary>
        void BeginAverages(int number)
        {
            m_now.Stage = Stage.NextSpacing;
            if (!Averaged.IsOn)
                return;
            for (number++; number < Scratch.Ranges.Length; number++)
            {
                if (!IsOfSpacing(Scratch.Ranges[number]))
                    continue;
                m_now.Range = number;
                m_now.Point = Scratch.Ranges[number].First;
                m_now.Darts = 0;
                m_now.Stage = Stage.Average;
                return;
            }
        }

        /// <summary>Adds what each candidate that was not taken represents to the nearest sample.</summary>
        void AddToAverages()
        {
            var range = Scratch.Ranges[m_now.Range];
            var grid = Grid;
            for (; m_now.Point < range.End && m_budget > 0; m_now.Point++)
            {
                int i = m_now.Point, own = RangeOf(i);
                m_budget -= CostOfAverageLook;
                if (own == m_now.Range || Scratch.Ranges[own].Parent != m_now.Range)
                    continue;
                m_budget -= CostOfAverage;
                var place = PositionAt(i);
                var tile = grid.TileOf(place);
                if (m_now.Darts == 0 || (tile.X ^ m_now.Tile.X | tile.Y ^ m_now.Tile.Y | tile.Z ^ m_now.Tile.Z) != 0)
                    grid.BeginTile(tile);
                m_now.Tile = tile;
                m_now.Darts = 1;
                if (grid.Nearest(grid.DartOf(place, 0), out int nearest) && nearest >= 0)
                    AddAverage(i, nearest);
            }
            if (m_now.Point == range.End)
                BeginAverages(m_now.Range);
        }

        void AddAverage(int from, int to)
        {
            int stride = Layout.StrideBytes;
            if (Averaged.AverageOfPoint[to] < 0)
            {
                var first = Averaged.Of(to, m_records + (long)to * stride, Layout);
                Averaged.AverageOfPoint[to] = Averaged.Averages.Length;
                Averaged.Averages.Add(first);
            }
            var more = Averaged.Of(from, m_records + (long)from * stride, Layout);
            ref var sum = ref Averaged.Averages.ElementAt(Averaged.AverageOfPoint[to]);
            sum.Points += more.Points;
            sum.Sum += more.Sum;
        }

        /// <summary>Counts what each range has in the end, and makes the nodes.</summary>
        void CountPoints()
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int end = Spend(m_now.Point, Count, CostOfLook);
            for (int i = m_now.Point; i < end; i++)
                ranges[RangeOf(i)].Count++;
            m_now.Point = end;
            if (end < Count)
                return;
            for (int r = 0; r < Scratch.Ranges.Length; r++)
                AddNodes(ref ranges[r], ranges);
            m_now.Point = 0;
            m_now.Stage = Stage.Renumber;
        }

        void AddNodes(ref SampledRange range, SampledRange* ranges)
        {
            int node = range.Parent < 0 ? -1 : ranges[range.Parent].Node;
            range.Node = range.Count > 0 ? Nodes.Length : node;
            range.Offered = 0;
            bool isChain = range.Kind == RangeKind.Chain, isTop = range.Kind == RangeKind.Top;
            bool isLeaf = range.Kind == RangeKind.Leaf || isTop && Tops[TopOf(range.First)].IsLeaf || isChain && !HasNodes(range);
            for (int left = range.Count; left > 0;)
            {
                int count = isChain ? math.min(left, Sizes.MaxPointsPerNode) : left;
                left -= count;
                Nodes.Add(new NodeDraft
                {
                    First = range.First,
                    End = range.End,
                    Parent = node,
                    Count = count,
                    SideLog2 = range.SideLog2,
                    CellLog2 = range.CellLog2,
                    IsLeaf = isLeaf && left == 0,
                    IsTop = isTop,
                });
                node = Nodes.Length - 1;
            }
            if (Tops.Length == 0 || range.Kind == RangeKind.Sampled || range.Kind == RangeKind.Passed)
                return;
            for (int t = TopOf(range.First), last = TopOf(range.End - 1); t <= last; t++)
            {
                var top = Tops[t];
                top.AttachNode = node;
                Tops[t] = top;
            }
        }

        void Renumber()
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int end = Spend(m_now.Point, Count, CostOfLook);
            for (int i = m_now.Point; i < end; i++)
            {
                ref var range = ref ranges[RangeOf(i)];
                m_rangeOfPoint[i] = range.Node;
                if (range.Kind == RangeKind.Chain)
                    m_rangeOfPoint[i] += range.Offered++ / Sizes.MaxPointsPerNode;
            }
            m_now.Point = end;
            if (end == Count)
                m_now.Stage = Stage.Done;
        }

        /// <summary>Whether a chunk has nodes below its top, if the points are tops.</summary>
        bool HasNodes(in SampledRange range)
        {
            bool hasNodes = false;
            for (int t = TopOf(range.First); Tops.Length > 0 && t <= TopOf(range.End - 1); t++)
                hasNodes |= Tops[t].HasNodes;
            return hasNodes;
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
    }
}
