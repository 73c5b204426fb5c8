using System;
using System.Collections.Generic;
using FastPoints.Base;
using FastPoints.Picture;
using FastPoints.Points;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Pipeline
{
    /// <summary>
    /// Which nodes of a stored cloud a picture is drawn from: those where the points above lie farthest apart on the screen
    /// first, until a budget of points is used up. Chunks' tables are loaded as the selection gets to them.
    /// </summary>
    public sealed class NodeSelection : IDisposable
    {
        /// <summary>Points closer than this on the screen add nothing to see.</summary>
        const double FinestSpacingPx = 0.4;

        /// <summary>The file of the upper levels.</summary>
        public const int UpperFile = -1;

        /// <summary>A node, or a chunk whose nodes are not known yet.</summary>
        struct Candidate
        {
            public double SpacingPx;

            /// <summary>Chunk, or <see cref="UpperFile"/>.</summary>
            public int File;

            /// <summary>Node of the file's table; -1 for the chunk itself.</summary>
            public int Node;
            public double SpacingGeo;
        }

        readonly CloudFolder m_folder;
        readonly Dictionary<int, NodeTable> m_tables = new Dictionary<int, NodeTable>();
        readonly Dictionary<int, List<int>> m_nodesOfFile = new Dictionary<int, List<int>>();
        readonly List<Candidate> m_heap = new List<Candidate>();
        readonly HashSet<(int File, int Node)> m_outOfView = new HashSet<(int File, int Node)>();

        public NodeSelection(CloudFolder folder)
        {
            m_folder = folder;
        }

        public int NodeCount { get; private set; }
        public long Points { get; private set; }

        /// <summary>The files that nodes were chosen of.</summary>
        public IEnumerable<int> Files => m_nodesOfFile.Keys;

        /// <summary>Chosen nodes of a file, in the order of its table.</summary>
        public List<int> NodesOf(int file) => m_nodesOfFile[file];

        public NodeTable TableOf(int file) => file == UpperFile ? m_folder.Upper : m_tables[file];

        public string PathOf(int file) => file == UpperFile ? m_folder.UpperPath : m_folder.ChunkPath(file);

        /// <summary>Chooses all nodes of some levels that have a spacing: no leaves.</summary>
        /// <param name="first">Counted from the root.</param>
        /// <param name="last">Included.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void ChooseSampled(int first, int last)
        {
            m_nodesOfFile.Clear();
            m_outOfView.Clear();
            NodeCount = 0;
            Points = 0;
            for (int file = UpperFile; file < m_folder.Chunks.Length; file++)
            {
                var nodes = (file == UpperFile ? m_folder.Upper : Load(file)).Nodes;
                for (int n = 0; n < nodes.Length; n++)
                {
                    int level = m_folder.Manifest.Root.SideLog2 - nodes[n].SideLog2;
                    if (SpacingCheck.HasSpacing(nodes[n]) && level >= first && level <= last)
                        Add(file, n, nodes[n].PointCount);
                }
            }
        }

        /// <summary>Whether all below a chosen node that the picture could show is chosen too, so that the node's points stand for
        /// themselves alone.</summary>
        public bool IsRefined(int file, int node)
        {
            var record = TableOf(file).Nodes[node];
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                if (!IsSettled(file, child))
                    return false;
            for (int chunk = record.FirstChunk; chunk < record.FirstChunk + record.ChunkCount; chunk++)
            {
                if (m_outOfView.Contains((chunk, -1)))
                    continue;
                if (!m_tables.TryGetValue(chunk, out var table))
                    return false;
                for (int n = 0; n < table.Nodes.Length && table.Nodes[n].Parent < 0; n++)
                    if (!IsSettled(chunk, n))
                        return false;
            }
            return true;
        }

        bool IsSettled(int file, int node) => m_outOfView.Contains((file, node)) ||
            m_nodesOfFile.TryGetValue(file, out var nodes) && nodes.BinarySearch(node) >= 0;

        /// <summary>Chooses for a camera, or, without one, from the root down evenly.</summary>
        /// <param name="budget">Points at most, but for the root, which is always chosen.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void Choose(Camera? camera, int widthPx, int heightPx, long budget)
        {
            m_nodesOfFile.Clear();
            m_heap.Clear();
            m_outOfView.Clear();
            NodeCount = 0;
            Points = 0;
            var view = camera.HasValue
                ? new PointProjection(camera.Value, m_folder.Manifest.Grid.FromCorner(default), widthPx, heightPx)
                : default;
            if (m_folder.Upper.Nodes.Length > 0)
                Push(UpperFile, 0, double.PositiveInfinity, m_folder.Upper.Nodes[0].Cube, camera, view);
            while (m_heap.Count > 0)
            {
                var best = Pop();
                if (best.SpacingPx < FinestSpacingPx)
                    break;
                if (best.Node < 0)
                {
                    var roots = Load(best.File).Nodes;
                    for (int n = 0; n < roots.Length && roots[n].Parent < 0; n++)
                        Push(best.File, n, best.SpacingGeo, roots[n].Cube, camera, view);
                    continue;
                }
                var nodes = TableOf(best.File).Nodes;
                var node = nodes[best.Node];
                if (NodeCount > 0 && Points + node.PointCount > budget)
                    break;
                Add(best.File, best.Node, node.PointCount);
                double spacing = math.cmax(m_folder.Manifest.Grid.Step) * math.pow(2.0, node.CellLog2);
                for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                    Push(best.File, child, spacing, nodes[child].Cube, camera, view);
                for (int chunk = node.FirstChunk; chunk < node.FirstChunk + node.ChunkCount; chunk++)
                    Push(chunk, -1, spacing, m_folder.Chunks[chunk].Cube, camera, view);
            }
            foreach (var chosen in m_nodesOfFile.Values)
                chosen.Sort();
        }

        public void Dispose()
        {
            foreach (var table in m_tables.Values)
                table.Dispose();
            m_tables.Clear();
        }

        NodeTable Load(int chunk)
        {
            if (!m_tables.TryGetValue(chunk, out var table))
                m_tables.Add(chunk, table = m_folder.LoadTable(chunk));
            return table;
        }

        void Add(int file, int node, int points)
        {
            if (!m_nodesOfFile.TryGetValue(file, out var chosen))
                m_nodesOfFile.Add(file, chosen = new List<int>());
            chosen.Add(node);
            NodeCount++;
            Points += points;
        }

        /// <param name="spacingGeo">Of the points above, whose gaps the node fills.</param>
        void Push(int file, int node, double spacingGeo, GridCube cube, Camera? camera, in PointProjection view)
        {
            double spacingPx = spacingGeo;
            if (camera.HasValue)
            {
                var grid = m_folder.Manifest.Grid;
                double radius = 0.5 * math.length(grid.Step * (double)cube.Side);
                var center = camera.Value.ToView(grid.ToGeo(cube.Corner) + grid.Step * (0.5 * cube.Side));
                double nearest = math.max(center.z - radius, 1e-3 * radius);
                double scale = view.IsOrthographic ? view.ScalePx : view.ScalePx / nearest;
                if (node != 0 || file != UpperFile)
                {
                    double farthest = view.IsOrthographic ? 1 : math.max(center.z + radius, 0);
                    if (farthest <= 0 || !InView(center, radius, view))
                    {
                        m_outOfView.Add((file, node));
                        return;
                    }
                }
                spacingPx = spacingGeo * scale;
            }
            m_heap.Add(new Candidate { SpacingPx = spacingPx, File = file, Node = node, SpacingGeo = spacingGeo });
            SiftUp(m_heap.Count - 1);
        }

        /// <summary>Whether a sphere reaches into the picture's four sides.</summary>
        static bool InView(double3 center, double radius, in PointProjection view)
        {
            double halfWidth = 0.5 * view.WidthPx / view.ScalePx, halfHeight = 0.5 * view.HeightPx / view.ScalePx;
            if (view.IsOrthographic)
                return math.abs(center.x) <= halfWidth + radius && math.abs(center.y) <= halfHeight + radius;
            // Distance to the planes through the eye and the picture's edges.
            return (math.abs(center.x) - halfWidth * center.z) / math.sqrt(1 + halfWidth * halfWidth) <= radius &&
                (math.abs(center.y) - halfHeight * center.z) / math.sqrt(1 + halfHeight * halfHeight) <= radius;
        }

        Candidate Pop()
        {
            var best = m_heap[0];
            var last = m_heap[m_heap.Count - 1];
            m_heap.RemoveAt(m_heap.Count - 1);
            if (m_heap.Count == 0)
                return best;
            int at = 0;
            for (int child; (child = 2 * at + 1) < m_heap.Count; at = child)
            {
                if (child + 1 < m_heap.Count && IsBefore(m_heap[child + 1], m_heap[child]))
                    child++;
                if (!IsBefore(m_heap[child], last))
                    break;
                m_heap[at] = m_heap[child];
            }
            m_heap[at] = last;
            return best;
        }

        void SiftUp(int at)
        {
            var moved = m_heap[at];
            for (int parent; at > 0 && IsBefore(moved, m_heap[parent = (at - 1) / 2]); at = parent)
                m_heap[at] = m_heap[parent];
            m_heap[at] = moved;
        }

        /// <summary>Ties by file and node, so that a choice can be repeated.</summary>
        static bool IsBefore(in Candidate a, in Candidate b) =>
            a.SpacingPx != b.SpacingPx ? a.SpacingPx > b.SpacingPx : a.File != b.File ? a.File < b.File : a.Node < b.Node;
    }
}
