using System;
using System.Collections.Generic;
using System.Linq;
using FastPoints.Nodes;

namespace FastPoints.Tests.Nodes
{
    /// <summary>The samplers as one would write them down: cubes offer points from the finest spacing up; a dart is compared
    /// with every point taken at its spacing.</summary>
    sealed class SamplingReference
    {
        sealed class Cube
        {
            public List<int> Points;
            public List<int> Offered;
            public List<Cube> Parts = new List<Cube>();
            public Cube Parent;
            public int CellLog2;
            public bool IsSampled;
            public bool IsPassed;
        }

        const int InLeaf = -2;

        readonly Grid3[] m_positions;
        readonly uint[] m_priority;
        readonly NodeSizes m_sizes;
        readonly long m_side;

        // Nearer to a sample than its spacing, without having been a candidate there.
        readonly HashSet<int> m_barred = new HashSet<int>();

        /// <summary>By point: log2 of the spacing at which it was taken; negative in leaves and chains.</summary>
        public int[] CellOfPoint { get; }

        /// <param name="positions">Along the Morton curve.</param>
        public SamplingReference(Grid3[] positions, uint[] priority, NodeSizes sizes, Sampler sampler)
        {
            m_positions = positions;
            m_priority = priority;
            m_sizes = sizes;
            for (m_side = 1; positions.Any(p => Math.Max(p.X, Math.Max(p.Y, p.Z)) >= m_side);)
                m_side *= 2;
            CellOfPoint = new int[positions.Length];
            Array.Fill(CellOfPoint, InLeaf);
            var cubes = new List<Cube> { new Cube { Points = Enumerable.Range(0, positions.Length).ToList() } };
            for (int i = 0; i < cubes.Count; i++)
            {
                Plan(cubes[i]);
                cubes.AddRange(cubes[i].Parts);
            }
            foreach (var spacing in cubes.Where(c => c.IsSampled).GroupBy(c => c.CellLog2).OrderBy(g => g.Key))
            {
                var taken = new List<int>();
                foreach (var cube in spacing)
                {
                    cube.Offered = sampler == Sampler.Random ? BestOfCells(cube) : Darts(cube, taken);
                    foreach (int point in cube.Offered)
                        CellOfPoint[point] = cube.CellLog2;
                }
                foreach (var cube in cubes)
                    if (sampler != Sampler.Random && cube.Parent?.CellLog2 > spacing.Key && !cube.IsPassed &&
                        !(cube.IsSampled && cube.CellLog2 >= spacing.Key))
                        m_barred.UnionWith(cube.Offered.Where(p => taken.Any(t => IsNear(p, t, spacing.Key))));
            }
        }

        void Plan(Cube cube)
        {
            int side = 0;
            var first = m_positions[cube.Points[0]];
            foreach (int point in cube.Points)
            {
                var d = m_positions[point];
                for (long differs = d.X ^ first.X | d.Y ^ first.Y | d.Z ^ first.Z; differs >> side != 0;)
                    side++;
            }
            cube.CellLog2 = side;
            int count = cube.Points.Count, cells = 1;
            for (int cell = side - 1; cell >= Math.Max(0, side - m_sizes.CellsLog2); cell--)
            {
                int finer = cube.Points.Select(p => CellOf(p, cell)).Distinct().Count();
                if (finer > m_sizes.MaxPointsPerNode)
                    break;
                cube.CellLog2 = cell;
                cells = finer;
            }
            cube.Offered = cube.Points;
            if (count <= Math.Min(m_sizes.MaxPointsPerNode, m_sizes.TargetPointsPerLeaf / 4 * 5) ||
                count <= m_sizes.MaxPointsPerNode && cells >= count - count / 4)
                return;
            if (side == 0)
            {
                cube.Offered = new List<int> { Best(cube.Points) };
                return;
            }
            cube.IsPassed = cube.Parent != null && cube.Parent.CellLog2 <= cube.CellLog2;
            cube.IsSampled = !cube.IsPassed;
            foreach (var part in cube.Points.GroupBy(p => CellOf(p, side - 1)))
                cube.Parts.Add(new Cube { Points = part.ToList(), Parent = cube.IsSampled ? cube : cube.Parent });
        }

        Grid3 CellOf(int point, int cell)
        {
            var p = m_positions[point];
            return new Grid3(p.X >> cell, p.Y >> cell, p.Z >> cell);
        }

        int Best(IEnumerable<int> points) => points.OrderByDescending(p => m_priority[p]).ThenBy(p => p).First();

        IEnumerable<int> Candidates(Cube cube) => cube.Parts.SelectMany(p =>
            p.IsPassed ? Candidates(p) : p.Offered.Where(o => !m_barred.Contains(o)));

        List<int> BestOfCells(Cube cube) => Candidates(cube).GroupBy(p => CellOf(p, cube.CellLog2)).Select(Best).ToList();

        List<int> Darts(Cube cube, List<int> takenOfSpacing)
        {
            var own = new List<int>();
            int tileLog2 = Math.Min(62, cube.CellLog2 + DartGrid.TileSpacingsLog2);
            long strip = m_side >= 1L << tileLog2 ? 1L << cube.CellLog2 >> 1 : 0, step = strip * 7 / 4;
            long Inward(long at) => at < strip ? at + step : m_side - at <= strip ? at - step : at;
            Grid3 Moved(Grid3 p) => new Grid3(Inward(p.X), Inward(p.Y), Inward(p.Z));
            bool IsAtFace(int point) => MortonOrder.Compare(Moved(m_positions[point]), m_positions[point]) != 0;
            foreach (var tile in Candidates(cube).GroupBy(p => CellOf(p, tileLog2)))
            {
                foreach (int point in tile.OrderBy(IsAtFace).ThenBy(p => PoissonPriority.ClassOf(m_priority[p])).ThenBy(p => p))
                {
                    if (own.Count == m_sizes.MaxPointsPerNode || takenOfSpacing.Any(t => IsNear(point, t, cube.CellLog2) ||
                        IsNear(Moved(m_positions[point]), m_positions[t], cube.CellLog2)))
                        continue;
                    own.Add(point);
                    takenOfSpacing.Add(point);
                }
            }
            own.Sort();
            return own;
        }

        bool IsNear(int a, int b, int cell) => IsNear(m_positions[a], m_positions[b], cell);

        /// <summary>To the step for spacings of up to 2048 steps.</summary>
        static bool IsNear(Grid3 a, Grid3 b, int cell)
        {
            int unit = Math.Max(0, cell - 11);
            Grid3 p = new Grid3(a.X >> unit, a.Y >> unit, a.Z >> unit), q = new Grid3(b.X >> unit, b.Y >> unit, b.Z >> unit);
            long near = (1L << cell - unit) + (unit > 0 ? 2 : 0);
            double x = p.X - q.X, y = p.Y - q.Y, z = p.Z - q.Z;
            return x * x + y * y + z * z < near * near;
        }
    }
}
