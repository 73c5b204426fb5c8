using System;
using System.Collections.Generic;
using FastPoints.Points;
using FastPoints.Samplers;

namespace FastPoints.Tests.Samplers
{
    /// <summary>The random sampler as one would write it down: from the root down, each cube takes the point of the highest
    /// priority of each of its cells that has none of a cube above.</summary>
    sealed class RandomReference
    {
        const int Untaken = -1, InLeaf = -2;

        readonly Grid3[] m_places;
        readonly uint[] m_priority;
        readonly NodeSizes m_sizes;

        /// <summary>By point: log2 of the cells at which it was taken; negative in leaves and chains.</summary>
        public int[] CellOfPoint { get; }

        /// <param name="places">Along the Morton curve.</param>
        public RandomReference(Grid3[] places, uint[] priority, NodeSizes sizes)
        {
            m_places = places;
            m_priority = priority;
            m_sizes = sizes;
            CellOfPoint = new int[places.Length];
            Array.Fill(CellOfPoint, Untaken);
            var all = new List<int>();
            for (int i = 0; i < places.Length; i++)
                all.Add(i);
            Sample(all);
        }

        void Sample(List<int> points)
        {
            int left = 0, side = 0;
            foreach (int point in points)
            {
                left += CellOfPoint[point] == Untaken ? 1 : 0;
                var d = m_places[point];
                var first = m_places[points[0]];
                for (long differs = d.X ^ first.X | d.Y ^ first.Y | d.Z ^ first.Z; differs >> side != 0;)
                    side++;
            }
            int cell = side;
            for (int finer = side - 1; finer >= Math.Max(0, side - m_sizes.CellsLog2); finer--)
            {
                if (WinnersAt(points, finer).Count > m_sizes.MaxPointsPerNode)
                    break;
                cell = finer;
            }
            bool isTakenAlmostWhole = left <= m_sizes.MaxPointsPerNode && WinnersAt(points, cell).Count >= left - left / 4;
            if (left <= m_sizes.MaxPointsPerLeaf || isTakenAlmostWhole || side == 0)
            {
                foreach (int point in points)
                    if (CellOfPoint[point] == Untaken)
                        CellOfPoint[point] = InLeaf;
                return;
            }
            foreach (int winner in WinnersAt(points, cell))
                CellOfPoint[winner] = cell;
            var parts = new SortedDictionary<int, List<int>>();
            foreach (int point in points)
            {
                var p = m_places[point];
                int octant = (int)(p.X >> side - 1 & 1 | (p.Y >> side - 1 & 1) << 1 | (p.Z >> side - 1 & 1) << 2);
                if (!parts.TryGetValue(octant, out var part))
                    parts[octant] = part = new List<int>();
                part.Add(point);
            }
            foreach (var part in parts.Values)
                Sample(part);
        }

        List<int> WinnersAt(List<int> points, int cell)
        {
            var winnerOfCell = new Dictionary<Grid3, int>();
            var taken = new HashSet<Grid3>();
            foreach (int point in points)
            {
                var p = m_places[point];
                var at = new Grid3(p.X >> cell, p.Y >> cell, p.Z >> cell);
                if (CellOfPoint[point] != Untaken)
                    taken.Add(at);
                if (!winnerOfCell.TryGetValue(at, out int best) || m_priority[point] > m_priority[best])
                    winnerOfCell[at] = point;
            }
            var result = new List<int>();
            foreach (var entry in winnerOfCell)
                if (!taken.Contains(entry.Key))
                    result.Add(entry.Value);
            return result;
        }
    }
}
