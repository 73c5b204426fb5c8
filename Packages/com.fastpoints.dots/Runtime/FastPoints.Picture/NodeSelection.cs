using FastPoints.Build;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Picture
{
    /// <summary>Chooses the nodes of a converted cloud that a picture is drawn from: those that streaming would choose
    /// (<see cref="SelectNodesJob"/>), but completely.</summary>
    internal sealed unsafe class NodeSelection : ChosenNodes
    {
        /// <summary>The selection restarts when it lacks this many chunks: a smaller number would cost more turns, a larger one
        /// would load what the budget does not reach.</summary>
        const int ChunksPerRound = 16;

        readonly LodSelector m_selector = new LodSelector();
        NativeArray<HierarchyPage> m_pages;
        bool m_hasView;

        public NodeSelection(CloudFolder folder) : base(folder)
        {
            var grid = new HierarchyGrid(folder.Manifest);
            m_pages = new NativeArray<HierarchyPage>(1 + folder.Chunks.Length, Allocator.Persistent);
            for (int chunk = 0; chunk < folder.Chunks.Length; chunk++)
                m_pages[1 + chunk] = HierarchyPage.OfChunk(folder.Chunks[chunk], grid);
            Build(UpperFile, folder.Upper);
        }

        /// <summary>Valid after <see cref="Choose"/>.</summary>
        public override bool IsRefined(int file, int node)
        {
            if (!m_hasView)
                return base.IsRefined(file, node);
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
            m_hasView = camera.HasValue;
            if (!m_hasView)
            {
                ChooseEvenly(budget);
                return;
            }
            var settings = LodSettings.Default;
            settings.PointBudget = budget;
            settings.Hysteresis = 1;
            using (var views = new NativeArray<StreamView>(1, Allocator.TempJob) { [0] = camera.Value })
            {
                do
                {
                    foreach (var missing in m_selector.Missing)
                        Fetch(missing.Page - 1);
                    foreach (var missing in m_selector.Missing)
                        Build(missing.Page - 1, Load(missing.Page - 1));
                    m_selector.Begin();
                    m_selector.Add(0, (HierarchyPage*)m_pages.GetUnsafePtr(), CloudPlacement.Geo(Folder.Manifest.Grid,
                        Folder.Manifest.Root));
                    m_selector.Choose(views, settings, ChunksPerRound);
                }
                while (m_selector.Missing.Length > 0);
            }
            Clear();
            foreach (var chosen in m_selector.Selected)
                AddWithLeaves(chosen.Page - 1, chosen.Node);
            SortNodes();
        }

        public override void Dispose()
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
            base.Dispose();
        }

        void Build(int file, NodeTable table)
        {
            var page = m_pages[1 + file];
            var chunks = (HierarchyPage*)m_pages.GetUnsafePtr() + 1;
            HierarchyPageBuilding.Build(table.View, default, new HierarchyGrid(Folder.Manifest),
                file == UpperFile ? chunks : null, ref page);
            m_pages[1 + file] = page;
        }
    }
}
