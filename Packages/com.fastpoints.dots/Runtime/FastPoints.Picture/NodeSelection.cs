using System.Collections.Generic;
using FastPoints.Store;
using FastPoints.Streaming;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;

namespace FastPoints.Picture
{
    /// <summary>Chooses the nodes of a converted cloud that a picture is drawn from: those that streaming would choose
    /// (<see cref="SelectNodesJob"/>), but completely.</summary>
    internal sealed unsafe class NodeSelection : CloudSelection
    {
        /// <summary>The selection restarts when it lacks this many pages: a smaller number would cost more turns, a larger one
        /// would load what the budget does not reach.</summary>
        const int PagesPerRound = 16;

        readonly LodSelector m_selector = new LodSelector();
        NativeList<HierarchyPage> m_pages = new NativeList<HierarchyPage>(Allocator.Persistent);
        Dictionary<int, List<int>> m_stored; // While it loads: the chosen nodes that edits do not reach, by page.
        bool m_hasView;

        public EditPlan Edits { get; set; } // Points are read as these leave them; null as stored.

        public NodeSelection(CloudFolder folder) : base(folder)
        {
            AddPages();
            Build(0, folder.Root);
        }

        /// <summary>Valid after <see cref="Choose"/>.</summary>
        public override bool IsRefined(int page, int node)
        {
            if (!m_hasView)
                return base.IsRefined(page, node);
            var record = TableOf(page).Nodes[node];
            for (int child = record.FirstChild; child < record.FirstChild + record.ChildCount; child++)
                if (!IsResolved(page, child))
                    return false;
            for (int link = record.FirstLink; link < record.FirstLink + record.LinkCount; link++)
            {
                int number = Folder.FirstBelow(page) + link;
                var below = m_pages[number];
                if (below.VisitedFrame != m_selector.Frame)
                    continue;
                if (!below.IsLoaded)
                    return false;
                for (int n = 0; n < below.RootCount; n++)
                    if (!IsResolved(number, n))
                        return false;
            }
            return true;
        }

        /// <summary>Whether it is chosen, its parent is chosen if it is an inlined leaf, or it is out of view.</summary>
        bool IsResolved(int page, int node)
        {
            var state = m_pages[page].States[TableOf(page).Nodes[node].PlaneNode];
            return state.SelectedFrame == m_selector.Frame || state.VisitedFrame != m_selector.Frame;
        }

        /// <summary>Chooses for a view in georeferenced space, or, without one, evenly from the root down.</summary>
        /// <param name="budget">The most points, except that the root is always chosen.</param>
        /// <param name="light">Of what shades the picture from outside of it.</param>
        /// <exception cref="PointCloudException">A page is damaged.</exception>
        public void Choose(StreamView? camera, long budget, StreamView? light = null)
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
            using (var all = new NativeArray<StreamView>(2, Allocator.TempJob)
            { [0] = camera.Value, [1] = light.GetValueOrDefault() })
            {
                var views = all.GetSubArray(0, light.HasValue ? 2 : 1);
                do
                {
                    foreach (var missing in m_selector.Missing)
                        Fetch(missing.Page);
                    foreach (var missing in m_selector.Missing)
                        Build(missing.Page, Load(missing.Page));
                    m_selector.Begin();
                    m_selector.Add(0, m_pages.GetUnsafePtr(), CloudPlacement.Geo(Folder.Manifest.Grid,
                        Folder.Manifest.Root));
                    m_selector.Select(views, settings, PagesPerRound);
                }
                while (m_selector.Missing.Length > 0);
            }
            Clear();
            foreach (var chosen in m_selector.Selected)
                AddWithLeaves(chosen.Page, chosen.Node);
            SortNodes();
        }

        public override List<int> NodesOf(int page) => m_stored != null ? m_stored[page] : base.NodesOf(page);

        /// <summary>Coroutine: as <see cref="LoadNodes.Run"/>, and as edited.</summary>
        public IEnumerator<JobStep> Load(PointBatch batch, StageProgress progress)
        {
            using var points = Edits != null ? new EditedPoints(Edits, Folder, batch.Schema) : null;
            var edited = new HashSet<EditedNode>();
            bool IsStored(int page, int index)
            {
                if (!(points?.Find(page, index, TableOf(page)) is EditedNode node))
                    return true;
                edited.Add(node);
                return false;
            }
            var stored = new Dictionary<int, List<int>>();
            foreach (int page in Pages)
            {
                stored.Add(page, NodesOf(page).FindAll(index => IsStored(page, index)));
                yield return default;
            }
            m_stored = stored;
            try
            {
                yield return JobStep.Of(LoadNodes.Run(Folder, this, batch, progress));
            }
            finally
            {
                m_stored = null;
            }
            foreach (var node in edited)
                yield return JobStep.Of(points.Add(node, batch));
        }

        public override void Dispose()
        {
            if (!m_pages.IsCreated)
                return;
            m_selector.Dispose();
            for (int p = 0; p < m_pages.Length; p++)
                m_pages.ElementAt(p).Free();
            m_pages.Dispose();
            base.Dispose();
        }

        void Build(int number, NodeTable table)
        {
            HierarchyPageBuilding.Build(table.View, default, Folder.Grid, ref m_pages.ElementAt(number));
            AddPages();
            var page = m_pages[number];
            for (int n = 0; n < page.NodeCount; n++)
                page.Nodes[n].FirstPage += Folder.FirstBelow(number);
        }

        void AddPages()
        {
            while (m_pages.Length < Folder.PageCount)
                m_pages.Add(HierarchyPage.OfLink(Folder.LinkOf(m_pages.Length), Folder.Grid));
        }
    }
}
