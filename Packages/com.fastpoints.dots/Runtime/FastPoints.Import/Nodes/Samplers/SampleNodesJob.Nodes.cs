using System.Runtime.CompilerServices;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Stage = FastPoints.Nodes.SampleScratch.Stage;

namespace FastPoints.Nodes
{
    /// <summary>After the choice: averages, and nodes for the ranges.</summary>
    internal unsafe partial struct SampleNodesJob
    {
        /// <summary>The range that a point belongs to, excluded or not.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        int RangeOf(int point) => m_rangeOfPoint[point] ^ m_rangeOfPoint[point] >> 31;

        void BeginAverages(int number)
        {
            m_state.Stage = Stage.NextSpacing;
            if (!Averaged.HasColumns)
                return;
            for (number++; number < Scratch.Ranges.Length; number++)
            {
                if (!IsOfSpacing(Scratch.Ranges[number]))
                    continue;
                m_state.Range = number;
                m_state.Point = Scratch.Ranges[number].First;
                m_state.HasTile = false;
                m_state.Stage = Stage.Average;
                return;
            }
        }

        /// <summary>Adds what each candidate that was not taken represents to the nearest sample.</summary>
        void AddToAverages()
        {
            var range = Scratch.Ranges[m_state.Range];
            var grid = Grid;
            for (; m_state.Point < range.End && m_budget > 0; m_state.Point++)
            {
                int i = m_state.Point, own = RangeOf(i);
                m_budget -= CostOfAverageSurvey;
                if (own == m_state.Range || Scratch.Ranges[own].Parent != m_state.Range)
                    continue;
                m_budget -= CostOfAverage;
                var position = PositionAt(i);
                var tile = grid.TileOf(position);
                if (!m_state.HasTile || (tile.X ^ m_state.Tile.X | tile.Y ^ m_state.Tile.Y | tile.Z ^ m_state.Tile.Z) != 0)
                    grid.BeginTile(tile);
                m_state.Tile = tile;
                m_state.HasTile = true;
                if (grid.Nearest(grid.DartOf(position, 0), out int nearest) && nearest >= 0)
                    AddAverage(i, nearest);
            }
            if (m_state.Point == range.End)
                BeginAverages(m_state.Range);
        }

        void AddAverage(int from, int to)
        {
            int stride = Layout.StrideBytes;
            if (Averaged.AverageOfPoint[to] < 0)
            {
                var first = Averaged.Of(to, m_records + (long)to * stride, Layout);
                Averaged.AverageOfPoint[to] = Averaged.Sums.Length;
                Averaged.Sums.Add(first);
            }
            var more = Averaged.Of(from, m_records + (long)from * stride, Layout);
            ref var sum = ref Averaged.Sums.ElementAt(Averaged.AverageOfPoint[to]);
            sum.Points += more.Points;
            sum.Sum += more.Sum;
        }

        void CountPoints()
        {
            var ranges = Scratch.Ranges.GetUnsafePtr();
            int end = Spend(m_state.Point, Count, CostOfSurvey);
            for (int i = m_state.Point; i < end; i++)
                ranges[RangeOf(i)].Count++;
            m_state.Point = end;
            if (end < Count)
                return;
            for (int r = 0; r < Scratch.Ranges.Length; r++)
                AddNodes(ref ranges[r], ranges);
            m_state.Point = 0;
            m_state.Stage = Stage.Renumber;
        }

        void AddNodes(ref SampledCube range, SampledCube* ranges)
        {
            int node = range.Parent < 0 ? -1 : ranges[range.Parent].Node;
            range.Node = range.Count > 0 ? Nodes.Length : node;
            range.Offered = 0;
            bool isChain = range.Kind == SampledCubeKind.Chain, isTopRemainder = range.Kind == SampledCubeKind.Top;
            bool isLeaf = range.Kind == SampledCubeKind.Leaf || isTopRemainder && Tops[TopOf(range.First)].IsLeaf ||
                isChain && !HasNodes(range);
            for (int left = range.Count; left > 0;)
            {
                int count = isChain ? math.min(left, Sizes.MaxPointsPerNode) : left;
                left -= count;
                Nodes.Add(new NodeDraft
                {
                    First = range.First,
                    End = range.End,
                    Parent = node,
                    OwnCount = count,
                    SideLog2 = range.SideLog2,
                    CellLog2 = range.CellLog2,
                    IsLeaf = isLeaf && left == 0,
                    IsTopRemainder = isTopRemainder,
                });
                node = Nodes.Length - 1;
            }
            if (Tops.Length == 0 || range.Kind == SampledCubeKind.Sampled || range.Kind == SampledCubeKind.Passed)
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
            int end = Spend(m_state.Point, Count, CostOfSurvey);
            for (int i = m_state.Point; i < end; i++)
            {
                ref var range = ref ranges[RangeOf(i)];
                m_rangeOfPoint[i] = range.Node;
                if (range.Kind == SampledCubeKind.Chain)
                    m_rangeOfPoint[i] += range.Offered++ / Sizes.MaxPointsPerNode;
            }
            m_state.Point = end;
            if (end == Count)
                m_state.Stage = Stage.Done;
        }

        /// <summary>Whether a chunk has nodes below its top, if the points are tops.</summary>
        bool HasNodes(in SampledCube range)
        {
            bool hasNodes = false;
            for (int t = TopOf(range.First); Tops.Length > 0 && t <= TopOf(range.End - 1); t++)
                hasNodes |= Tops[t].HasNodes;
            return hasNodes;
        }

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
