using System.Collections.Generic;
using System.Linq;
using FastPoints.Evaluation;
using FastPoints.Surface;
using Unity.Mathematics;

namespace FastPoints.Tests.Surface
{
    /// <summary>The surface of points in memory, cell by cell, joined where cells have the same vertex.</summary>
    internal sealed class TestSurface
    {
        public readonly SurfaceGrid Grid;
        public readonly List<double3> Vertices = new List<double3>();
        public readonly List<int3> Triangles = new List<int3>();
        readonly Dictionary<(long X, long Y, long Z), int> m_numberOf = new Dictionary<(long X, long Y, long Z), int>();

        public TestSurface(IReadOnlyList<double3> points, SurfaceGrid grid)
        {
            Grid = grid;
            using var batch = TestBatches.OfPositions(points.ToArray());
            using var builder = new SurfaceBuilder(grid, new float3(0, 0, 1));
            foreach (var cell in CellsOf(points, grid).OrderBy(c => (c.z, c.y, c.x)))
            {
                JobCoroutine.RunToEnd(builder.Run(cell, (b, at) => b.Add(at, batch, 1)));
                Take(builder, cell);
            }
        }

        public TriangleGrid ToGrid() => new TriangleGrid(Vertices, Triangles, Grid.VoxelMetres);

        static HashSet<int3> CellsOf(IReadOnlyList<double3> points, SurfaceGrid grid)
        {
            var cells = new HashSet<int3>();
            foreach (var point in points)
            {
                int3 first = grid.CellOf(point - grid.ReachMetres), last = grid.CellOf(point + grid.ReachMetres);
                for (int z = first.z; z <= last.z; z++)
                    for (int y = first.y; y <= last.y; y++)
                        for (int x = first.x; x <= last.x; x++)
                            cells.Add(new int3(x, y, z));
            }
            return cells;
        }

        void Take(SurfaceBuilder builder, int3 cell)
        {
            var vertices = builder.Vertices;
            var numbers = new int[vertices.Length];
            long cellSteps = (long)Grid.CellEdgeVoxels * SurfaceGrid.StepsPerVoxel;
            for (int i = 0; i < numbers.Length; i++)
            {
                var at = (cell.x * cellSteps + vertices[i].x, cell.y * cellSteps + vertices[i].y,
                    cell.z * cellSteps + vertices[i].z);
                if (!m_numberOf.TryGetValue(at, out numbers[i]))
                {
                    m_numberOf.Add(at, numbers[i] = Vertices.Count);
                    Vertices.Add(new double3(at.Item1, at.Item2, at.Item3) * (Grid.VoxelMetres / SurfaceGrid.StepsPerVoxel));
                }
            }
            foreach (var t in builder.Triangles)
                Triangles.Add(new int3(numbers[t.x], numbers[t.y], numbers[t.z]));
        }

        /// <summary>Edges that are not passed as often one way as the other.</summary>
        public int CountOpenEdges()
        {
            var balance = new Dictionary<(int, int), int>();
            foreach (var t in Triangles)
                foreach (var (a, b) in new[] { (t.x, t.y), (t.y, t.z), (t.z, t.x) })
                {
                    // Two vertices may have moved to one place.
                    if (a == b)
                        continue;
                    var edge = a < b ? (a, b) : (b, a);
                    balance.TryGetValue(edge, out int was);
                    balance[edge] = was + (a < b ? 1 : -1);
                }
            return balance.Values.Count(v => v != 0);
        }

        /// <summary>Where a line between two places passes triangles, of any side: shares of the way, ascending.</summary>
        public static List<double> Passes(TriangleGrid grid, double3 from, double3 to)
        {
            var shares = new List<double>();
            var way = to - from;
            foreach (int t in grid.TrianglesIn(math.min(from, to), math.max(from, to)).Distinct())
            {
                var (a, b, c) = grid.CornersOf(t);
                double3 ab = b - a, ac = c - a, across = math.cross(way, ac);
                double volume = math.dot(ab, across);
                if (volume == 0)
                    continue;
                double u = math.dot(from - a, across) / volume;
                var turned = math.cross(from - a, ab);
                double v = math.dot(way, turned) / volume, share = math.dot(ac, turned) / volume;
                if (u >= 0 && v >= 0 && u + v <= 1 && share >= 0 && share <= 1)
                    shares.Add(share);
            }
            shares.Sort();
            return shares;
        }
    }
}
