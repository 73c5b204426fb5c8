using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Build
{
    /// <summary>Nodes of a converted cloud that were chosen, by file. Chunks' tables are loaded as a choice reaches
    /// them.</summary>
    internal class ChosenNodes : IDisposable
    {
        public const int UpperFile = -1;

        const int MaxTableFetches = 16;

        protected CloudFolder Folder { get; }
        readonly Dictionary<int, NodeTable> m_tables = new Dictionary<int, NodeTable>();
        readonly Dictionary<int, List<int>> m_nodesOfFile = new Dictionary<int, List<int>>();

        public ChosenNodes(CloudFolder folder) => Folder = folder;

        public int NodeCount { get; private set; }
        public long Points { get; private set; }

        public int CheckedPoints => Points <= int.MaxValue / 64
            ? (int)Points
            : throw PointCloudException.Wanted(FailureCode.Unsupported, Folder.FolderPath, -1, "points of one picture",
                "at most " + int.MaxValue / 64, Points);

        public IEnumerable<int> Files => m_nodesOfFile.Keys;

        /// <summary>Chosen nodes of a file, in the order of its table.</summary>
        public List<int> NodesOf(int file) => m_nodesOfFile[file];

        public NodeTable TableOf(int file) => file == UpperFile ? Folder.Upper : m_tables[file];

        public RemoteFile RemoteOf(int file) => Folder.RemoteOf(file == UpperFile ? 0 : 1 + file);

        public string PathOf(int file) => file == UpperFile ? Folder.UpperPath : Folder.ChunkPath(file);

        /// <summary>Chooses what streaming would choose without a camera: the children of the widest spacing first,
        /// ties by file and node number, until the next one would exceed the budget.</summary>
        /// <param name="budget">The most points, except that the root is always chosen.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void ChooseEvenly(long budget)
        {
            Clear();
            // Node -1 stands for a chunk that is not open yet.
            var next = new SortedSet<(float Narrowness, int File, int Node)>();
            if (Folder.Upper.Nodes.Length > 0)
                next.Add((float.NegativeInfinity, UpperFile, 0));
            while (next.Count > 0)
            {
                var best = next.Min;
                next.Remove(best);
                var (narrowness, file, index) = best;
                if (index < 0)
                {
                    FetchSoon(next);
                    var roots = Load(file).Nodes;
                    for (int root = 0; root < roots.Length && roots[root].Parent < 0; root++)
                        next.Add((narrowness, file, root));
                    continue;
                }
                var node = TableOf(file).Nodes[index];
                if (Points > 0 && Points + PointsWithLeaves(file, index) > budget)
                    break;
                AddWithLeaves(file, index);
                float below = -(float)(math.cmax(Folder.Manifest.Grid.Step) * math.pow(2.0, node.CellLog2));
                for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                    if (TableOf(file).Nodes[child].PlaneNode == child)
                        next.Add((below, file, child));
                for (int chunk = node.FirstChunk; file == UpperFile && chunk < node.FirstChunk + node.ChunkCount; chunk++)
                    next.Add((below, chunk, -1));
            }
            SortNodes();
        }

        /// <summary>Chooses all nodes of some levels that have a spacing, which excludes leaves.</summary>
        /// <param name="firstLevel">Counted from the root.</param>
        /// <param name="lastLevel">Included, as is <paramref name="lastFile"/>.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void ChooseSampled(int firstLevel, int lastLevel, int firstFile = UpperFile, int lastFile = int.MaxValue)
        {
            Clear();
            for (int file = firstFile; file <= lastFile && file < Folder.Chunks.Length; file++)
            {
                for (int next = Math.Max(0, file); next < Math.Min(file + MaxTableFetches, Folder.Chunks.Length); next++)
                    Fetch(next);
                var nodes = (file == UpperFile ? Folder.Upper : Load(file)).Nodes;
                for (int n = 0; n < nodes.Length; n++)
                {
                    int level = Folder.Manifest.Root.SideLog2 - nodes[n].SideLog2;
                    if (nodes[n].HasSpacing && level >= firstLevel && level <= lastLevel)
                        Add(file, n, nodes[n].PointCount);
                }
            }
        }

        /// <summary>Whether everything below a chosen node that the picture could show is also chosen, so that the node's points
        /// represent only themselves.</summary>
        public virtual bool IsRefined(int file, int node)
        {
            var record = TableOf(file).Nodes[node];
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                if (!IsChosen(file, TableOf(file).Nodes[child].PlaneNode))
                    return false;
            for (int chunk = record.FirstChunk; chunk < record.FirstChunk + record.ChunkCount; chunk++)
            {
                if (!m_tables.TryGetValue(chunk, out var table))
                    return false;
                for (int n = 0; n < table.Nodes.Length && table.Nodes[n].Parent < 0; n++)
                    if (!IsChosen(chunk, n))
                        return false;
            }
            return true;
        }

        public virtual void Dispose()
        {
            foreach (var table in m_tables.Values)
                table.Dispose();
            m_tables.Clear();
        }

        // The tables of the chunks that come next, if they are on a web server.
        void FetchSoon(SortedSet<(float Narrowness, int File, int Node)> next)
        {
            int count = 0;
            foreach (var soon in next)
            {
                if (count++ == MaxTableFetches)
                    break;
                if (soon.Node < 0)
                    Fetch(soon.File);
            }
        }

        // Begins to, if it is on a web server: Load then waits less.
        protected void Fetch(int chunk)
        {
            if (!m_tables.ContainsKey(chunk))
                Folder.IsTableFetched(chunk);
        }

        protected NodeTable Load(int chunk)
        {
            if (!m_tables.TryGetValue(chunk, out var table))
                m_tables.Add(chunk, table = Folder.LoadTable(chunk));
            return table;
        }

        protected void Clear()
        {
            m_nodesOfFile.Clear();
            NodeCount = 0;
            Points = 0;
        }

        /// <summary>Adds a node and the leaves that are inlined in it; then call <see cref="SortNodes"/>.</summary>
        protected void AddWithLeaves(int file, int node)
        {
            var nodes = TableOf(file).Nodes;
            Add(file, node, nodes[node].PointCount);
            for (int child = nodes[node].FirstChild; child < nodes[node].FirstChild + nodes[node].ChildCount; child++)
                if (nodes[child].PlaneNode == node)
                    Add(file, child, nodes[child].PointCount);
        }

        protected void SortNodes()
        {
            foreach (var nodes in m_nodesOfFile.Values)
                nodes.Sort();
        }

        bool IsChosen(int file, int node) => m_nodesOfFile.TryGetValue(file, out var nodes) && nodes.BinarySearch(node) >= 0;

        long PointsWithLeaves(int file, int node)
        {
            var nodes = TableOf(file).Nodes;
            long points = nodes[node].PointCount;
            for (int child = nodes[node].FirstChild; child < nodes[node].FirstChild + nodes[node].ChildCount; child++)
                points += nodes[child].PlaneNode == node ? nodes[child].PointCount : 0;
            return points;
        }

        void Add(int file, int node, int points)
        {
            if (!m_nodesOfFile.TryGetValue(file, out var chosen))
                m_nodesOfFile.Add(file, chosen = new List<int>());
            chosen.Add(node);
            NodeCount++;
            Points += points;
        }
    }
}
