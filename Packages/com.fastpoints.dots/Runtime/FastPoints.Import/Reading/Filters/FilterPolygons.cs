using System;
using System.Collections.Generic;
using System.IO;
using FastPoints.Store;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;

namespace FastPoints.Reading
{
    /// <summary>An edge of a ring, counted from the polygons' min corner. Blittable.</summary>
    internal struct FilterEdge
    {
        public double2 From;
        public double2 To;

        /// <summary>Edges of one polygon have one number.</summary>
        public int Polygon;
    }

    /// <summary>Polygons with holes, from GeoJSON or WKT, and their edges by slabs of y, so that a point is compared with few of
    /// them. A point belongs if any polygon holds it: by an even-odd count of that polygon's rings, or on an edge.</summary>
    internal sealed class FilterPolygons : IDisposable
    {
        const long MaxFileBytes = 256 << 20;
        const int MaxDepth = 32;

        readonly List<FilterEdge> m_edges = new List<FilterEdge>();
        readonly List<(int Polygon, double2[] Vertices)> m_rings = new List<(int, double2[])>();
        double2 m_min = new double2(double.PositiveInfinity, double.PositiveInfinity);
        double2 m_max = new double2(double.NegativeInfinity, double.NegativeInfinity);
        int m_polygons;

        FilterPolygons() { }

        public IReadOnlyList<(int Polygon, double2[] Vertices)> Rings => m_rings;
        public double2 Min => m_min;
        public double2 Max => m_max;

        /// <summary>The first edge of each slab among <see cref="EdgesOfSlabs"/>, and one more entry.</summary>
        public NativeArray<int> FirstOfSlab { get; private set; }

        /// <summary>By slab, in each by polygon.</summary>
        public NativeArray<FilterEdge> EdgesOfSlabs { get; private set; }

        /// <summary>Differs for other polygons.</summary>
        public unsafe ulong Hash => ContentHash.Of(EdgesOfSlabs.GetUnsafeReadOnlyPtr(),
            (long)EdgesOfSlabs.Length * sizeof(FilterEdge)) ^ math.asulong(m_min.x) ^ 2 * math.asulong(m_min.y);

        /// <exception cref="PointCloudException">The file cannot be read or is no polygon.</exception>
        public static FilterPolygons Read(string path)
        {
            try
            {
                if (new FileInfo(path).Length > MaxFileBytes)
                    throw new FormatException("wanted at most " + MaxFileBytes + " bytes");
                return Parse(File.ReadAllText(path));
            }
            catch (Exception e) when (e is FormatException || e is IOException || e is UnauthorizedAccessException)
            {
                throw new PointCloudException(FailureCode.BadInput, path, -1, "no polygon: " + e.Message);
            }
        }

        /// <exception cref="FormatException">It is neither GeoJSON nor WKT with polygons.</exception>
        public static FilterPolygons Parse(string text)
        {
            var polygons = new FilterPolygons();
            if (text.TrimStart('\uFEFF', ' ', '\t', '\r', '\n').StartsWith("{", StringComparison.Ordinal))
                polygons.AddGeoJson(JsonReader.Parse(text.TrimStart('\uFEFF')), 0);
            else
                new WktPolygons(text, polygons).Read();
            if (polygons.m_edges.Count == 0)
                throw new FormatException("wanted a Polygon or a MultiPolygon, got none");
            polygons.MakeSlabs();
            return polygons;
        }

        public void Dispose()
        {
            if (!FirstOfSlab.IsCreated)
                return;
            FirstOfSlab.Dispose();
            EdgesOfSlabs.Dispose();
            FirstOfSlab = default;
        }

        void AddGeoJson(object value, int depth)
        {
            if (depth > MaxDepth || !(value is Dictionary<string, object> members))
                throw new FormatException("wanted an object of GeoJSON, got " + JsonReader.Describe(value));
            members.TryGetValue("type", out object type);
            switch (type as string)
            {
                case "FeatureCollection":
                    foreach (object feature in ListOf(members, "features"))
                        AddGeoJson(feature, depth + 1);
                    break;
                case "GeometryCollection":
                    foreach (object geometry in ListOf(members, "geometries"))
                        AddGeoJson(geometry, depth + 1);
                    break;
                case "Feature":
                    if (members.TryGetValue("geometry", out object featureGeometry) && featureGeometry != null)
                        AddGeoJson(featureGeometry, depth + 1);
                    break;
                case "Polygon":
                    AddRings(ListOf(members, "coordinates"));
                    break;
                case "MultiPolygon":
                    foreach (object polygon in ListOf(members, "coordinates"))
                        AddRings(ListOf(polygon));
                    break;
                default:
                    throw new FormatException("wanted a Polygon or a MultiPolygon, got " + JsonReader.Describe(type));
            }
        }

        void AddRings(List<object> rings)
        {
            m_polygons++;
            foreach (object ring in rings)
            {
                var points = new List<double2>();
                foreach (object item in ListOf(ring))
                {
                    var at = ListOf(item);
                    if (at.Count < 2)
                        throw new FormatException("wanted x and y, got " + at.Count + " numbers");
                    points.Add(new double2(JsonReader.ToDouble(at[0]), JsonReader.ToDouble(at[1])));
                }
                AddRing(points);
            }
        }

        static List<object> ListOf(Dictionary<string, object> members, string name) =>
            ListOf(members.TryGetValue(name, out object value) ? value : null);

        static List<object> ListOf(object value) =>
            value as List<object> ?? throw new FormatException("wanted a list, got " + JsonReader.Describe(value));

        /// <summary>An open ring is closed.</summary>
        void AddRing(List<double2> points)
        {
            m_rings.Add((m_polygons, points.ToArray()));
            for (int i = 0; i < points.Count; i++)
            {
                if (!math.isfinite(points[i].x) || !math.isfinite(points[i].y))
                    throw new FormatException("wanted finite coordinates");
                m_min = new double2(math.min(m_min.x, points[i].x), math.min(m_min.y, points[i].y));
                m_max = new double2(math.max(m_max.x, points[i].x), math.max(m_max.y, points[i].y));
                m_edges.Add(new FilterEdge { From = points[i], To = points[(i + 1) % points.Count], Polygon = m_polygons });
            }
        }

        void MakeSlabs()
        {
            int slabs = math.clamp(m_edges.Count, 1, 1 << 16);
            // Long edges are in many slabs: their lists stay a small multiple of the edges.
            while (slabs > 1 && EntriesWith(slabs) > 8L * m_edges.Count + 64)
                slabs /= 2;
            var first = new NativeArray<int>(slabs + 1, Allocator.Persistent);
            var next = new int[slabs + 1];
            foreach (var edge in m_edges)
                for (int slab = FirstSlab(edge, slabs); slab <= LastSlab(edge, slabs); slab++)
                    next[slab + 1]++;
            for (int slab = 0; slab < slabs; slab++)
                first[slab + 1] = next[slab + 1] += next[slab];
            var edges = new NativeArray<FilterEdge>(next[slabs], Allocator.Persistent);
            foreach (var edge in m_edges)
                for (int slab = FirstSlab(edge, slabs); slab <= LastSlab(edge, slabs); slab++)
                    edges[next[slab]++] = new FilterEdge
                    {
                        From = edge.From - m_min,
                        To = edge.To - m_min,
                        Polygon = edge.Polygon,
                    };
            FirstOfSlab = first;
            EdgesOfSlabs = edges;
            m_edges.Clear();
        }

        long EntriesWith(int slabs)
        {
            long count = 0;
            foreach (var edge in m_edges)
                count += LastSlab(edge, slabs) - FirstSlab(edge, slabs) + 1;
            return count;
        }

        // A slab more on either side: a point next to an edge is rounded into another.
        int FirstSlab(in FilterEdge edge, int slabs) =>
            math.max(0, SlabOf(math.min(edge.From.y, edge.To.y) - m_min.y, m_max.y - m_min.y, slabs) - 1);

        int LastSlab(in FilterEdge edge, int slabs) =>
            math.min(slabs - 1, SlabOf(math.max(edge.From.y, edge.To.y) - m_min.y, m_max.y - m_min.y, slabs) + 1);

        public static int SlabOf(double y, double height, int slabs) =>
            height > 0 ? (int)math.clamp(y / height * slabs, 0, slabs - 1) : 0;

        /// <summary>POLYGON and MULTIPOLYGON of WKT; what follows x and y of a vertex is skipped.</summary>
        sealed class WktPolygons
        {
            readonly string m_text;
            readonly FilterPolygons m_target;
            int m_at;

            public WktPolygons(string text, FilterPolygons to) => (m_text, m_target) = (text, to);

            public void Read()
            {
                string word = Word();
                if (word.StartsWith("SRID", StringComparison.OrdinalIgnoreCase) && m_text.IndexOf(';') is var end && end >= 0)
                {
                    m_at = end + 1;
                    word = Word();
                }
                bool isMany = word.Equals("MULTIPOLYGON", StringComparison.OrdinalIgnoreCase);
                if (!isMany && !word.Equals("POLYGON", StringComparison.OrdinalIgnoreCase))
                    throw Bad("GeoJSON, POLYGON or MULTIPOLYGON");
                if (char.IsLetter(Peek()))
                    Word();
                if (isMany)
                    InParentheses(Polygon);
                else
                    Polygon();
                if (Peek() != '\0')
                    throw Bad("the end");
            }

            void Polygon()
            {
                m_target.m_polygons++;
                InParentheses(Ring);
            }

            void Ring()
            {
                var points = new List<double2>();
                InParentheses(() =>
                {
                    points.Add(new double2(Number(), Number()));
                    while (Peek() != ',' && Peek() != ')')
                        Number();
                });
                m_target.AddRing(points);
            }

            void InParentheses(Action item)
            {
                Take('(');
                item();
                while (Peek() == ',')
                {
                    m_at++;
                    item();
                }
                Take(')');
            }

            double Number()
            {
                Peek();
                int from = m_at;
                while (m_at < m_text.Length && "+-.eE0123456789".IndexOf(m_text[m_at]) >= 0)
                    m_at++;
                return NumberText.TryRead(m_text.Substring(from, m_at - from), out double value) ? value : throw Bad("a number");
            }

            string Word()
            {
                Peek();
                int from = m_at;
                while (m_at < m_text.Length && char.IsLetter(m_text[m_at]))
                    m_at++;
                return m_text.Substring(from, m_at - from);
            }

            void Take(char wanted)
            {
                if (Peek() != wanted)
                    throw Bad("'" + wanted + "'");
                m_at++;
            }

            char Peek()
            {
                while (m_at < m_text.Length && char.IsWhiteSpace(m_text[m_at]))
                    m_at++;
                return m_at < m_text.Length ? m_text[m_at] : '\0';
            }

            FormatException Bad(string wanted) => new FormatException("wanted " + wanted + " at character " + (m_at + 1) +
                ", got " + (m_at < m_text.Length ? "'" + m_text[m_at] + "'" : "the end"));
        }
    }
}
