using System;
using System.Collections.Generic;
using FastPoints.Points;
using FastPoints.Samplers;

namespace FastPoints.Tests.Samplers
{
    /// <summary>The Poisson sampler as one would write it down: dart throwing in the order of priority, every dart compared with
    /// every point taken before.</summary>
    sealed class PoissonReference
    {
        sealed class Cube
        {
            public List<int> Points;
            public int SideLog2;
            public int CellLog2;
            public int Taken;
        }

        const int Untaken = -1, InLeaf = -2;

        readonly Grid3[] m_places;
        readonly NodeSizes m_sizes;
        readonly List<Cube> m_waiting = new List<Cube>();

        /// <summary>By point: log2 of the spacing at which it was taken; negative in leaves and chains.</summary>
        public int[] CellOfPoint { get; }

        /// <param name="order">All points, in the order in which they are tried.</param>
        /// <param name="isTiled">Cube by cube, and tile by tile in a cube; otherwise all of one spacing in this order.</param>
        public PoissonReference(Grid3[] places, NodeSizes sizes, int[] order, bool isTiled)
        {
            m_places = places;
            m_sizes = sizes;
            CellOfPoint = new int[places.Length];
            Array.Fill(CellOfPoint, Untaken);
            var all = new Cube { Points = new List<int>() };
            for (int i = 0; i < places.Length; i++)
                all.Points.Add(i);
            Visit(all);
            var cubeOfPoint = new Cube[places.Length];
            while (m_waiting.Count > 0)
            {
                int cell = 0;
                foreach (var cube in m_waiting)
                    cell = Math.Max(cell, cube.CellLog2);
                var cubes = m_waiting.FindAll(c => c.CellLog2 == cell);
                m_waiting.RemoveAll(c => c.CellLog2 == cell);
                Array.Clear(cubeOfPoint, 0, cubeOfPoint.Length);
                foreach (var cube in cubes)
                    foreach (int point in cube.Points)
                        cubeOfPoint[point] = cube;
                var tried = isTiled ? ByTile(order, cubes, cubeOfPoint, cell) : order;
                foreach (int point in tried)
                {
                    var cube = cubeOfPoint[point];
                    if (cube == null || CellOfPoint[point] != Untaken || cube.Taken == m_sizes.MaxPointsPerNode ||
                        IsKeptOff(point, cell))
                        continue;
                    CellOfPoint[point] = cell;
                    cube.Taken++;
                }
                foreach (var cube in cubes)
                    foreach (var part in PartsOf(cube))
                        Visit(part);
            }
        }

        /// <summary>The points of the cubes, which come along the curve as they do: by tile, the order kept within
        /// each.</summary>
        int[] ByTile(int[] order, List<Cube> cubes, Cube[] cubeOfPoint, int cell)
        {
            cubes.Sort((a, b) => a.Points[0].CompareTo(b.Points[0]));
            int tileLog2 = Math.Min(62, cell + SamplePoissonJob.TileSpacingsLog2);
            var tileOfPoint = new int[m_places.Length];
            int tiles = 0;
            foreach (var cube in cubes)
                for (int i = 0; i < cube.Points.Count; i++)
                {
                    var place = m_places[cube.Points[i]];
                    var before = m_places[cube.Points[Math.Max(0, i - 1)]];
                    bool isNew = i == 0 || ((place.X ^ before.X) | (place.Y ^ before.Y) | (place.Z ^ before.Z)) >> tileLog2 != 0;
                    tileOfPoint[cube.Points[i]] = isNew ? ++tiles : tiles;
                }
            var result = new List<int>();
            foreach (int point in order)
                if (cubeOfPoint[point] != null)
                    result.Add(point);
            var places = new Dictionary<int, int>();
            for (int i = 0; i < result.Count; i++)
                places[result[i]] = i;
            result.Sort((a, b) => tileOfPoint[a] != tileOfPoint[b]
                ? tileOfPoint[a].CompareTo(tileOfPoint[b])
                : places[a].CompareTo(places[b]));
            return result.ToArray();
        }

        /// <summary>The order of the sampler: classes of priority, along the Morton curve.</summary>
        public static int[] OrderOf(uint[] priority)
        {
            var order = new int[priority.Length];
            var keys = new long[priority.Length];
            for (int i = 0; i < order.Length; i++)
            {
                order[i] = i;
                keys[i] = (long)PoissonPriority.ClassOf(priority[i]) << 32 | (uint)i;
            }
            Array.Sort(keys, order);
            return order;
        }

        void Visit(Cube cube)
        {
            int left = 0, side = 0;
            foreach (int point in cube.Points)
            {
                left += CellOfPoint[point] == Untaken ? 1 : 0;
                var d = m_places[point];
                var first = m_places[cube.Points[0]];
                for (long differs = d.X ^ first.X | d.Y ^ first.Y | d.Z ^ first.Z; differs >> side != 0;)
                    side++;
            }
            cube.SideLog2 = side;
            cube.CellLog2 = side;
            int cells = Math.Min(1, left);
            for (int cell = side - 1; cell >= Math.Max(0, side - m_sizes.CellsLog2); cell--)
            {
                var all = new HashSet<Grid3>();
                var taken = new HashSet<Grid3>();
                foreach (int point in cube.Points)
                {
                    var p = m_places[point];
                    var at = new Grid3(p.X >> cell, p.Y >> cell, p.Z >> cell);
                    all.Add(at);
                    if (CellOfPoint[point] != Untaken)
                        taken.Add(at);
                }
                if (all.Count - taken.Count > m_sizes.MaxPointsPerNode)
                    break;
                cube.CellLog2 = cell;
                cells = all.Count - taken.Count;
            }
            bool isTakenAlmostWhole = left <= m_sizes.MaxPointsPerNode && cells >= left - left / 4;
            if (left <= m_sizes.MaxPointsPerLeaf || isTakenAlmostWhole || side == 0)
            {
                foreach (int point in cube.Points)
                    if (CellOfPoint[point] == Untaken)
                        CellOfPoint[point] = InLeaf;
                return;
            }
            m_waiting.Add(cube);
        }

        bool IsKeptOff(int point, int cell)
        {
            for (int other = 0; other < m_places.Length; other++)
            {
                if (CellOfPoint[other] < 0)
                    continue;
                var d = m_places[point] - m_places[other];
                // Exact for spacings below 2^31.
                if (((d.X < 0 ? -d.X : d.X) | (d.Y < 0 ? -d.Y : d.Y) | (d.Z < 0 ? -d.Z : d.Z)) >> cell == 0 &&
                    d.X * d.X + d.Y * d.Y + d.Z * d.Z < 1L << 2 * cell)
                    return true;
            }
            return false;
        }

        IEnumerable<Cube> PartsOf(Cube cube)
        {
            var parts = new Cube[8];
            foreach (int point in cube.Points)
            {
                var p = m_places[point];
                int bit = cube.SideLog2 - 1;
                int octant = (int)(p.X >> bit & 1 | (p.Y >> bit & 1) << 1 | (p.Z >> bit & 1) << 2);
                (parts[octant] ??= new Cube { Points = new List<int>() }).Points.Add(point);
            }
            foreach (var part in parts)
                if (part != null)
                    yield return part;
        }
    }
}
