using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace FastPoints.Store
{
    /// <summary>Nodes of a converted cloud that were chosen, by page of its hierarchy. Pages are loaded as a choice reaches
    /// them.</summary>
    internal class CloudSelection : IDisposable
    {
        protected const int MaxPageFetches = 16;

        public CloudFolder Folder { get; }
        readonly Dictionary<int, NodeTable> m_tables = new Dictionary<int, NodeTable>();
        readonly Dictionary<int, List<int>> m_nodesOfPage = new Dictionary<int, List<int>>();

        public CloudSelection(CloudFolder folder) => Folder = folder;

        public int NodeCount { get; private set; }
        public long Points { get; private set; }

        public int PointCountOrThrow => Points <= int.MaxValue / 64
            ? (int)Points
            : throw PointCloudException.Wanted(FailureCode.Unsupported, Folder.FolderPath, -1, "points chosen at once",
                "at most " + int.MaxValue / 64, Points);

        public IEnumerable<int> Pages => m_nodesOfPage.Keys;

        /// <summary>Chosen nodes of a page, in its order.</summary>
        public virtual List<int> NodesOf(int page) => m_nodesOfPage[page];

        public NodeTable TableOf(int page) => page == 0 ? Folder.Root : m_tables[page];

        /// <summary>The file of planes that were computed, or of the others.</summary>
        public RemoteFile RemoteOf(int page, bool isComputed = false) =>
            isComputed ? Folder.RemoteOfComputed(page) : Folder.PlanesRemoteOf(page);

        public string PathOf(int page, bool isComputed = false) =>
            isComputed ? Folder.PathOfComputed(page) : Folder.PlanesPathOf(page);

        /// <summary>Chooses what streaming would choose without a camera: the children of the widest spacing first,
        /// ties by page and node number, until the next one would exceed the budget.</summary>
        /// <param name="budget">The most points, except that the root is always chosen.</param>
        /// <exception cref="PointCloudException">A page is damaged.</exception>
        public void ChooseEvenly(long budget)
        {
            Clear();
            // Node -1 stands for a page that is not loaded yet.
            var next = new SortedSet<(float Narrowness, int Page, int Node)>();
            if (Folder.Root.Nodes.Length > 0)
                next.Add((float.NegativeInfinity, 0, 0));
            while (next.Count > 0)
            {
                var best = next.Min;
                next.Remove(best);
                var (narrowness, page, index) = best;
                if (index < 0)
                {
                    FetchSoon(next);
                    var roots = Load(page).Nodes;
                    for (int root = 0; root < roots.Length && roots[root].Parent < 0; root++)
                        next.Add((narrowness, page, root));
                    continue;
                }
                var node = TableOf(page).Nodes[index];
                if (Points > 0 && Points + PointsWithLeaves(page, index) > budget)
                    break;
                AddWithLeaves(page, index);
                float below = -(float)(math.cmax(Folder.Manifest.Grid.Step) * math.pow(2.0, node.CellLog2));
                for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                    if (TableOf(page).Nodes[child].PlaneNode == child)
                        next.Add((below, page, child));
                for (int link = node.FirstLink; link < node.FirstLink + node.LinkCount; link++)
                    next.Add((below, Folder.FirstBelow(page) + link, -1));
            }
            SortNodes();
        }

        /// <summary>Chooses all nodes with points in a box.</summary>
        /// <exception cref="PointCloudException">A page is damaged.</exception>
        public void ChooseIn(Grid3 min, Grid3 end)
        {
            Clear();
            foreach (var (page, index) in NodesIn(min, end))
                if (Intersects(TableOf(page).Nodes[index], min, end))
                    Add(page, index, TableOf(page).Nodes[index].PointCount);
            SortNodes();
        }

        /// <summary>Whether everything below a chosen node that the picture could show is also chosen, so that the node's points
        /// represent only themselves.</summary>
        public virtual bool IsRefined(int page, int node)
        {
            var record = TableOf(page).Nodes[node];
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                if (!IsChosen(page, TableOf(page).Nodes[child].PlaneNode))
                    return false;
            for (int link = record.FirstLink; link < record.FirstLink + record.LinkCount; link++)
            {
                int below = Folder.FirstBelow(page) + link;
                if (!m_tables.TryGetValue(below, out var table))
                    return false;
                for (int n = 0; n < table.Nodes.Length && table.Nodes[n].Parent < 0; n++)
                    if (!IsChosen(below, n))
                        return false;
            }
            return true;
        }

        public virtual void Dispose() => DropTables(-1);

        protected void DropTables(int tables)
        {
            if (m_tables.Count <= tables)
                return;
            foreach (var table in m_tables.Values)
                table.Dispose();
            m_tables.Clear();
        }

        // The pages that come next, if they are on a web server.
        void FetchSoon(SortedSet<(float Narrowness, int Page, int Node)> next)
        {
            int count = 0;
            foreach (var soon in next)
            {
                if (count++ == MaxPageFetches)
                    break;
                if (soon.Node < 0)
                    Fetch(soon.Page);
            }
        }

        // Begins to, if it is on a web server: Load then waits less.
        protected void Fetch(int page)
        {
            if (page > 0 && !m_tables.ContainsKey(page))
                Folder.BeginFetchPage(page);
        }

        protected NodeTable Load(int page)
        {
            if (page == 0)
                return Folder.Root;
            if (!m_tables.TryGetValue(page, out var table))
                m_tables.Add(page, table = Folder.LoadPage(page));
            return table;
        }

        protected void Clear()
        {
            m_nodesOfPage.Clear();
            NodeCount = 0;
            Points = 0;
        }

        /// <summary>Adds a node and the leaves that are inlined in it; then call <see cref="SortNodes"/>.</summary>
        protected void AddWithLeaves(int page, int node)
        {
            var nodes = TableOf(page).Nodes;
            Add(page, node, nodes[node].PointCount);
            for (int child = nodes[node].FirstChild; child < nodes[node].FirstChild + nodes[node].ChildCount; child++)
                if (nodes[child].PlaneNode == node)
                    Add(page, child, nodes[child].PointCount);
        }

        protected void SortNodes()
        {
            foreach (var nodes in m_nodesOfPage.Values)
                nodes.Sort();
        }

        protected IEnumerator<JobStep> LoadPage(int page)
        {
            using var begun = Folder.BeginPage(page);
            while (!begun.IsDone)
                yield return default;
            var table = begun.Take();
            m_tables.Add(page, table);
            Folder.Register(page, table.View);
        }

        /// <summary>Nodes whose cubes intersect a box, from the root down.</summary>
        /// <param name="missing">Told of a page that is to be loaded before the walk, which gives no node, goes on.</param>
        protected IEnumerable<(int Page, int Node)> NodesIn(Grid3 min, Grid3 end, Action<int> missing = null)
        {
            var next = new Stack<(int Page, int Node)>();
            if (Load(0).Nodes.Length > 0)
                next.Push((0, 0));
            while (next.Count > 0)
            {
                var (page, index) = next.Pop();
                var table = Load(page);
                var node = table.Nodes[index];
                if (!AreBelow(node.Corner, end) || !AreBelow(min, EndOf(node.Cube)))
                    continue;
                yield return (page, index);
                for (int child = node.FirstChild; child < node.FirstChild + node.ChildCount; child++)
                    next.Push((page, child));
                for (int link = node.FirstLink; link < node.FirstLink + node.LinkCount; link++)
                {
                    int below = Folder.FirstBelow(page) + link;
                    if (missing != null && !m_tables.ContainsKey(below))
                    {
                        missing(below);
                        yield return default;
                    }
                    var roots = Load(below).Nodes;
                    for (int root = 0; root < roots.Length && roots[root].Parent < 0; root++)
                        next.Push((below, root));
                }
            }
        }

        protected static Grid3 EndOf(GridCube cube) => cube.Corner + new Grid3(cube.Side, cube.Side, cube.Side);

        protected static bool Intersects(in NodeRecord node, Grid3 min, Grid3 end)
        {
            int shift = node.BoundsShift;
            long rest = (1L << shift) - 1;
            var low = node.Corner + new Grid3((long)node.MinX << shift, (long)node.MinY << shift, (long)node.MinZ << shift);
            var high = node.Corner + new Grid3(((long)node.MaxX << shift) + rest, ((long)node.MaxY << shift) + rest,
                ((long)node.MaxZ << shift) + rest);
            return AreBelow(low, end) && !IsAnyBelow(high, min);
        }

        static bool AreBelow(Grid3 a, Grid3 b) => a.X < b.X && a.Y < b.Y && a.Z < b.Z;

        static bool IsAnyBelow(Grid3 a, Grid3 b) => a.X < b.X || a.Y < b.Y || a.Z < b.Z;

        bool IsChosen(int page, int node) => m_nodesOfPage.TryGetValue(page, out var nodes) && nodes.BinarySearch(node) >= 0;

        long PointsWithLeaves(int page, int node)
        {
            var nodes = TableOf(page).Nodes;
            long points = nodes[node].PointCount;
            for (int child = nodes[node].FirstChild; child < nodes[node].FirstChild + nodes[node].ChildCount; child++)
                points += nodes[child].PlaneNode == node ? nodes[child].PointCount : 0;
            return points;
        }

        protected void Add(int page, int node, int points)
        {
            if (!m_nodesOfPage.TryGetValue(page, out var chosen))
                m_nodesOfPage.Add(page, chosen = new List<int>());
            chosen.Add(node);
            NodeCount++;
            Points += points;
        }
    }
}
