using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Evaluation
{
    internal sealed class TriangleGrid
    {
        readonly double m_edge;
        readonly List<double3> m_vertices;
        readonly List<int3> m_triangles;
        readonly Dictionary<int3, int> m_lastOfCube = new Dictionary<int3, int>();

        // Entries are linked backwards.
        readonly List<(int Triangle, int Before)> m_entries = new List<(int Triangle, int Before)>();

        /// <param name="edge">Of a cube, about as long as a triangle.</param>
        public TriangleGrid(List<double3> vertices, List<int3> triangles, double edge)
        {
            m_edge = edge;
            m_vertices = vertices;
            m_triangles = triangles;
            for (int t = 0; t < triangles.Count; t++)
            {
                var (a, b, c) = CornersOf(t);
                foreach (var cube in CubesOf(math.min(a, math.min(b, c)), math.max(a, math.max(b, c))))
                {
                    m_entries.Add((t, m_lastOfCube.TryGetValue(cube, out int before) ? before : -1));
                    m_lastOfCube[cube] = m_entries.Count - 1;
                }
            }
        }

        public (double3 A, double3 B, double3 C) CornersOf(int triangle)
        {
            var t = m_triangles[triangle];
            return (m_vertices[t.x], m_vertices[t.y], m_vertices[t.z]);
        }

        public IEnumerable<int> TrianglesIn(double3 min, double3 max)
        {
            foreach (var cube in CubesOf(min, max))
                for (int e = m_lastOfCube.TryGetValue(cube, out int last) ? last : -1; e >= 0; e = m_entries[e].Before)
                    yield return m_entries[e].Triangle;
        }

        /// <returns>The distance to the nearest triangle; infinity if none is nearer than the limit.</returns>
        public double DistanceTo(double3 place, double limit)
        {
            double best = double.PositiveInfinity;
            for (double reach = m_edge / 2; ; reach = math.min(2 * reach, limit))
            {
                foreach (int t in TrianglesIn(place - reach, place + reach))
                {
                    var (a, b, c) = CornersOf(t);
                    best = math.min(best, math.distance(place, Nearest(place, a, b, c)));
                }
                if (best <= reach || reach >= limit)
                    return best <= limit ? best : double.PositiveInfinity;
            }
        }

        /// <summary>The nearest place of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).</summary>
        public static double3 Nearest(double3 p, double3 a, double3 b, double3 c)
        {
            double3 ab = b - a, ac = c - a, ap = p - a;
            double d1 = math.dot(ab, ap), d2 = math.dot(ac, ap);
            if (d1 <= 0 && d2 <= 0)
                return a;
            var bp = p - b;
            double d3 = math.dot(ab, bp), d4 = math.dot(ac, bp);
            if (d3 >= 0 && d4 <= d3)
                return b;
            double vc = d1 * d4 - d3 * d2;
            if (vc <= 0 && d1 >= 0 && d3 <= 0)
                return a + ab * (d1 / (d1 - d3));
            var cp = p - c;
            double d5 = math.dot(ab, cp), d6 = math.dot(ac, cp);
            if (d6 >= 0 && d5 <= d6)
                return c;
            double vb = d5 * d2 - d1 * d6;
            if (vb <= 0 && d2 >= 0 && d6 <= 0)
                return a + ac * (d2 / (d2 - d6));
            double va = d3 * d6 - d5 * d4;
            if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
                return b + (c - b) * ((d4 - d3) / (d4 - d3 + (d5 - d6)));
            double share = 1 / (va + vb + vc);
            return a + ab * (vb * share) + ac * (vc * share);
        }

        IEnumerable<int3> CubesOf(double3 min, double3 max)
        {
            int3 first = (int3)math.floor(min / m_edge), last = (int3)math.floor(max / m_edge);
            for (int z = first.z; z <= last.z; z++)
                for (int y = first.y; y <= last.y; y++)
                    for (int x = first.x; x <= last.x; x++)
                        yield return new int3(x, y, z);
        }
    }
}
