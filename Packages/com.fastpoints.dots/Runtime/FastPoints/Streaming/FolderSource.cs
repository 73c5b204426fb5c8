using System;
using System.Collections.Generic;
using FastPoints.Store;
using Unity.Collections;
using Unity.Jobs;

namespace FastPoints.Streaming
{
    /// <summary>The source of a cloud's folder, finished or not; then of the generation that was opened.</summary>
    public sealed class FolderSource : NodeSource
    {
        const int MaxTranscoders = 8;

        readonly CloudLocalSpace m_grid;
        readonly List<ulong[]> m_checked = new List<ulong[]>(); // By page, once registered: see VerifiedPlanes.
        NativeArray<int> m_planes;
        NativeArray<PlaneShape> m_shapes;
        readonly List<EditedTranscoder> m_transcoders = new List<EditedTranscoder>();
        readonly Stack<NodeTranscoder> m_idle = new Stack<NodeTranscoder>();
        EditedNodes m_edited;
        bool m_isWhole; // To examine single points.

        /// <summary>Owns the folder. Streams the position and the named planes, as far as the cloud has them.</summary>
        public FolderSource(CloudFolder folder, params string[] planes)
        {
            Folder = folder;
            m_grid = folder.Manifest.LocalSpace;
            var wanted = new SortedSet<int> { StoreLayout.PositionPlane };
            foreach (string name in planes)
                if (folder.Layout.PlaneOf(name) >= 0)
                    wanted.Add(folder.Layout.PlaneOf(name));
            var indices = new int[wanted.Count];
            wanted.CopyTo(indices);
            m_planes = new NativeArray<int>(indices, Allocator.Persistent);
            m_shapes = folder.Layout.CreateShapes(Allocator.Persistent);
        }

        /// <summary>Opens a folder with all planes but averages: a small file and a page, on any thread.</summary>
        public static FolderSource OpenWhole(string path)
        {
            var folder = CloudFolder.Open(path);
            var names = new List<string>();
            foreach (var plane in folder.Layout.Planes)
                if (plane.AverageOf < 0)
                    names.Add(plane.Name);
            return new FolderSource(folder, names.ToArray()) { m_isWhole = true };
        }

        /// <summary>The cloud that is streamed.</summary>
        public CloudFolder Folder { get; }

        // What is applied to nodes, to be set before pages are made; null if they are shown as stored.
        internal EditPlan Edits
        {
            get => m_edited?.Plan;
            set => m_edited = value != null ? new EditedNodes(value, Folder, m_planes, m_isWhole) : null;
        }

        internal PointCloudException Refused { get; set; } // Why edits are not applied: reported once.

        public override PointCloudException Update()
        {
            var refused = Refused;
            Refused = null;
            return refused;
        }

        internal override bool HasNodesOf(NodeSource other) => other is FolderSource folder && !Folder.IsUnfinished &&
            folder.Folder.Manifest.RootHash == Folder.Manifest.RootHash;

        internal override bool Transcodes(int page, int node) => m_edited != null && m_edited.Has(page, node);

        public override NodeTranscoder TryRentTranscoder(int points)
        {
            if (m_idle.Count > 0)
                return m_idle.Pop();
            if (m_transcoders.Count == MaxTranscoders)
                return null;
            m_transcoders.Add(new EditedTranscoder(m_edited));
            return m_transcoders[m_transcoders.Count - 1];
        }

        public override void ReturnTranscoder(NodeTranscoder transcoder) => m_idle.Push(transcoder);
        public override NodeTranscoder CreateFullTranscoder() => new EditedTranscoder(m_edited);

        public override string Path => SourcePath.WithoutQuery(Folder.FolderPath);
        public override CloudCrs Crs => Folder.Manifest.Crs;
        public override bool HasAllPoints => !Folder.IsUnfinished;
        public override CloudGrid Grid => Folder.Manifest.Grid;
        public override GridCube Root => Folder.Manifest.Root;
        public override NodeCubes Cubes => new NodeCubes { Size = Root.Side * Grid.Step, Step = Grid.Step };
        public override StoreLayout Layout => Folder.Layout;
        public override NativeArray<int> Planes => m_planes;
        public override NativeArray<PlaneShape> Shapes => m_shapes;
        public override int PageCount => Folder.PageCount;

        public override unsafe void CreatePages(HierarchyPage* pages)
        {
            for (int page = 1; page < PageCount; page++)
                pages[page] = EmptyPage(page);
            pages[0] = default;
            HierarchyPageBuilding.Build(Folder.Root.View, m_planes, m_grid, ref pages[0]);
            Number(0, pages[0], Folder.Root.View);
        }

        public override HierarchyPage EmptyPage(int page) => HierarchyPage.OfLink(Folder.LinkOf(page), m_grid);

        public override void RegisterPage(int page, in HierarchyPage built, NativeArray<byte> table)
        {
            Folder.Register(page, PageView.Of(table));
            Number(page, built, PageView.Of(table));
        }

        internal override bool KeepsFilesOpen => !Folder.IsUnfinished;

        public override string PlanesPathOf(int page) => Folder.PlanesPathOf(page);

        internal override bool IsComputed(int plane) => Folder.Layout.Planes[m_planes[plane]].IsComputed;

        internal override string PathOfComputed(int page) => StreamsComputed ? Folder.PathOfComputed(page) : null;

        internal override RemoteFile RemoteOfComputed(int page) => StreamsComputed ? Folder.RemoteOfComputed(page) : null;
        bool StreamsComputed => IsComputed(m_planes.Length - 1); // They are the last.

        internal override bool IsVerified(int page, int node, int plane) =>
            m_checked[page] != null && VerifiedPlanes.Has(m_checked[page], BitOf(node, plane));

        internal override void SetVerified(int page, int node, int plane)
        {
            if (m_checked[page] != null)
                VerifiedPlanes.Add(m_checked[page], BitOf(node, plane));
        }

        internal override void Invalidate(int page)
        {
            if (page < m_checked.Count && m_checked[page] != null)
                Array.Clear(m_checked[page], 0, m_checked[page].Length);
            Folder.DropTail();
            RemoteOfTable(page)?.DropCached();
            PlanesRemoteOf(page)?.DropCached();
            RemoteOfComputed(page)?.DropCached();
            MarkStale();
        }

        internal override RemoteFile PlanesRemoteOf(int page) => Folder.PlanesRemoteOf(page);

        internal override RemoteFile RemoteOfTable(int page) => Folder.RemoteOfTable(page);

        internal override double RoundTrip => Folder.RemoteOfTable(0)?.RoundTrip ?? 0;

        internal override void MarkStale() => MarkedStale?.Invoke();

        internal Action MarkedStale { get; set; } // Set by whoever would open it again.

        internal override FilePiece TableOf(int page) => Folder.TableOf(page);

        internal override bool TryCopyTable(int page, NativeArray<byte> to) => Folder.TryCopyPage(page, to);

        public override JobHandle ScheduleBuild(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem) => JobFor(page, table, built, problem).Schedule();

        public override string Describe(int page, NativeArray<byte> table, TableProblem problem) =>
            NodeTable.Describe(problem, JobFor(page, table, default, default).Check);

        public override IEnumerator<JobStep> OpenForPicking(Action<NodeSource> opened)
        {
            string path = Folder.FolderPath;
            var edits = Edits;
            return PoolTask.Run<FolderSource>(path, () =>
            {
                var source = OpenWhole(path);
                source.Edits = edits;
                return source;
            }, opened, unwanted => unwanted.DisposeUnread());
        }

        public override void Dispose()
        {
            foreach (var transcoder in m_transcoders)
                transcoder.Dispose();
            m_transcoders.Clear();
            m_idle.Clear();
            DisposeUnread();
        }

        // On any thread, as long as no transcoder was rented.
        void DisposeUnread()
        {
            Folder.Dispose();
            if (!m_planes.IsCreated)
                return;
            m_planes.Dispose();
            m_shapes.Dispose();
        }

        long BitOf(int node, int plane) => (long)node * m_shapes.Length + m_planes[plane];

        unsafe void Number(int page, in HierarchyPage built, in PageView table)
        {
            m_edited?.Register(page, built, table);
            for (int n = 0; n < built.NodeCount; n++)
                built.Nodes[n].FirstPage += Folder.FirstBelow(page);
            while (m_checked.Count < PageCount)
                m_checked.Add(null);
            if (Folder.VerifiedPlanes != null && built.NodeCount > 0)
                m_checked[page] ??= Folder.VerifiedPlanes.BitsOf(Folder.LinkOf(page), PlanesPathOf(page),
                    (long)built.NodeCount * m_shapes.Length);
        }

        BuildHierarchyPageJob JobFor(int page, NativeArray<byte> table, NativeReference<HierarchyPage> built,
            NativeReference<TableProblem> problem) => new BuildHierarchyPageJob
            {
                Table = table,
                Link = Folder.LinkOf(page),
                Grid = m_grid,
                Shapes = m_shapes,
                ComputedPlaneCount = Folder.Layout.ComputedPlaneCount,
                Wanted = m_planes,
                Built = built,
                Problem = problem,
            };
    }
}
