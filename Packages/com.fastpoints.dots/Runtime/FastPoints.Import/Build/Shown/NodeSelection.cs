using System;
using System.Collections.Generic;
using FastPoints.Core;
using FastPoints.Drawing;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Build
{
    /// <summary>Chooses the nodes of a stored cloud that a picture is drawn from: those that streaming would choose
    /// (<see cref="SelectNodesJob"/>), but completely: chunks' tables are loaded as the selection reaches them.</summary>
    internal sealed unsafe class NodeSelection : IDisposable
    {
        /// <summary>The file of the upper levels.</summary>
        public const int UpperFile = -1;

        /// <summary>The selection restarts when it lacks this many chunks: a smaller number would cost more turns, a larger one
        /// would load what the budget does not reach.</summary>
        const int ChunksPerRound = 16;

        readonly CloudFolder m_folder;
        readonly Dictionary<int, NodeTable> m_tables = new Dictionary<int, NodeTable>();
        readonly Dictionary<int, List<int>> m_nodesOfFile = new Dictionary<int, List<int>>();
        readonly LodSelector m_selector = new LodSelector();
        NativeArray<HierarchyPage> m_pages;

        public NodeSelection(CloudFolder folder)
        {
            m_folder = folder;
            var grid = new HierarchyGrid(folder.Manifest);
            m_pages = new NativeArray<HierarchyPage>(1 + folder.Chunks.Length, Allocator.Persistent);
            for (int chunk = 0; chunk < folder.Chunks.Length; chunk++)
                m_pages[1 + chunk] = HierarchyPage.OfChunk(folder.Chunks[chunk], grid);
            Build(UpperFile, folder.Upper);
        }

        public int NodeCount { get; private set; }
        public long Points { get; private set; }

        /// <summary>The files with chosen nodes.</summary>
        public IEnumerable<int> Files => m_nodesOfFile.Keys;

        /// <summary>Chosen nodes of a file, in the order of its table.</summary>
        public List<int> NodesOf(int file) => m_nodesOfFile[file];

        public NodeTable TableOf(int file) => file == UpperFile ? m_folder.Upper : m_tables[file];

        public string PathOf(int file) => file == UpperFile ? m_folder.UpperPath : m_folder.ChunkPath(file);

        /// <summary>Chooses all nodes of some levels that have a spacing, which excludes leaves.</summary>
        /// <param name="first">The first level, counted from the root.</param>
        /// <param name="last">The last level, included.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void ChooseSampled(int first, int last)
        {
            Clear();
            for (int file = UpperFile; file < m_folder.Chunks.Length; file++)
            {
                var nodes = (file == UpperFile ? m_folder.Upper : Load(file)).Nodes;
                for (int n = 0; n < nodes.Length; n++)
                {
                    int level = m_folder.Manifest.Root.SideLog2 - nodes[n].SideLog2;
                    if (nodes[n].HasSpacing && level >= first && level <= last)
                        Add(file, n, nodes[n].PointCount);
                }
            }
        }

        /// <summary>Whether everything below a chosen node that the picture could show is also chosen, so that the node's points
        /// represent only themselves. Ask after <see cref="Choose"/>.</summary>
        public bool IsRefined(int file, int node)
        {
            var record = TableOf(file).Nodes[node];
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                if (!IsResolved(file, child))
                    return false;
            for (int chunk = record.FirstChunk; chunk < record.FirstChunk + record.ChunkCount; chunk++)
            {
                var page = m_pages[1 + chunk];
                if (page.VisitedFrame != m_selector.Frame)
                    continue;
                if (!page.IsLoaded)
                    return false;
                for (int n = 0; n < page.RootCount; n++)
                    if (!IsResolved(chunk, n))
                        return false;
            }
            return true;
        }

        /// <summary>Whether it is chosen, its parent is chosen if it is an inlined leaf, or it is out of view.</summary>
        bool IsResolved(int file, int node)
        {
            var state = m_pages[1 + file].States[TableOf(file).Nodes[node].PlaneNode];
            return state.SelectedFrame == m_selector.Frame || state.VisitedFrame != m_selector.Frame;
        }

        /// <summary>Chooses for a view in georeferenced space, or, without one, evenly from the root down.</summary>
        /// <param name="budget">The most points, except that the root is always chosen.</param>
        /// <exception cref="PointCloudException">A chunk's table is damaged.</exception>
        public void Choose(StreamView? camera, long budget)
        {
            var settings = LodSettings.Default;
            settings.PointBudget = budget;
            settings.Hysteresis = 1;
            if (!camera.HasValue)
                settings.MinScreenErrorPx = settings.SmallestNodePx = 0;
            var view = camera ?? StreamView.Everything(1);
            using (var views = new NativeArray<StreamView>(1, Allocator.TempJob) { [0] = view })
            {
                do
                {
                    foreach (var missing in m_selector.Missing)
                        Load(missing.Page - 1);
                    m_selector.Begin();
                    m_selector.Add(0, (HierarchyPage*)m_pages.GetUnsafePtr(), CloudPlacement.Geo(m_folder.Manifest.Grid,
                        m_folder.Manifest.Root));
                    m_selector.Choose(views, settings, ChunksPerRound);
                }
                while (m_selector.Missing.Length > 0);
            }
            SortByFile(m_selector.Selected);
        }

        public void Dispose()
        {
            if (!m_pages.IsCreated)
                return;
            m_selector.Dispose();
            for (int p = 0; p < m_pages.Length; p++)
            {
                var page = m_pages[p];
                page.Free();
            }
            m_pages.Dispose();
            foreach (var table in m_tables.Values)
                table.Dispose();
            m_tables.Clear();
        }

        /// <summary>Sorts the chosen nodes with their inlined leaves by file, in the order of its table.</summary>
        void SortByFile(NativeArray<SelectedNode> selected)
        {
            Clear();
            foreach (var chosen in selected)
            {
                int file = chosen.Page - 1;
                var nodes = TableOf(file).Nodes;
                Add(file, chosen.Node, nodes[chosen.Node].PointCount);
                int end = nodes[chosen.Node].FirstChild + nodes[chosen.Node].ChildCount;
                for (int child = nodes[chosen.Node].FirstChild; child < end; child++)
                    if (nodes[child].PlaneNode == chosen.Node)
                        Add(file, child, nodes[child].PointCount);
            }
            foreach (var nodes in m_nodesOfFile.Values)
                nodes.Sort();
        }

        NodeTable Load(int chunk)
        {
            if (!m_tables.TryGetValue(chunk, out var table))
            {
                m_tables.Add(chunk, table = m_folder.LoadTable(chunk));
                Build(chunk, table);
            }
            return table;
        }

        void Build(int file, NodeTable table)
        {
            var page = m_pages[1 + file];
            var chunks = (HierarchyPage*)m_pages.GetUnsafePtr() + 1;
            HierarchyPageBuilding.Build(table.View, default, new HierarchyGrid(m_folder.Manifest),
                file == UpperFile ? chunks : null, ref page);
            m_pages[1 + file] = page;
        }

        void Clear()
        {
            m_nodesOfFile.Clear();
            NodeCount = 0;
            Points = 0;
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
